#include "base/files.h"

#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include "base/error.h"
#include "base/hash.h"

namespace lightbench {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t kMaxFileNameBytes = 120;

std::string system_message() {
  return std::strerror(errno);
}

void make_parent_folders(const fs::path& file) {
  if (file.parent_path().empty()) return;
  std::error_code error;
  fs::create_directories(file.parent_path(), error);
  if (error) throw Error("cannot make the folder: " + error.message(), file.parent_path().string());
}

/// The bytes must be on the disk before the rename: else a power cut leaves an empty file under the final
/// name.
void flush_to_disk(const fs::path& file) {
  const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) throw Error("cannot write: " + system_message(), file.string());
  const bool flushed = ::fsync(descriptor) == 0;
  ::close(descriptor);
  if (!flushed) throw Error("cannot write: " + system_message(), file.string());
}

bool is_plain(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' || c == '_' ||
         c == '-' || c == '+' || c == '=' || c == '~' || c == ',' || c == '[' || c == ']';
}

}  // namespace

std::string read_file(const fs::path& file) {
  std::error_code error;
  if (fs::is_directory(file, error)) throw Error("is a folder, not a file", file.string());
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw Error("cannot read the file: " + system_message(), file.string());
  std::string bytes{std::istreambuf_iterator<char>(stream), {}};
  if (stream.bad()) throw Error("cannot read the file", file.string());
  return bytes;
}

void write_file_atomic(const fs::path& file, std::string_view bytes) {
  AtomicFile target(file);
  std::ofstream stream(target.path(), std::ios::binary);
  stream.write(bytes.data(), std::streamsize(bytes.size()));
  stream.close();
  if (!stream) throw Error("cannot write: " + system_message(), file.string());
  target.commit();
}

AtomicFile::AtomicFile(fs::path target) : target_(std::move(target)) {
  static std::atomic<unsigned> counter{0};
  make_parent_folders(target_);
  std::error_code error;
  if (fs::is_directory(target_, error))
    throw Error("is a folder, cannot write a file there", target_.string());
  temporary_ = target_.parent_path() / fmt::format(".{}.tmp-{}-{}{}", target_.stem().string().substr(0, 100),
                                                   ::getpid(), counter++, target_.extension().string());
}

AtomicFile::~AtomicFile() {
  if (temporary_.empty()) return;
  std::error_code ignored;
  fs::remove(temporary_, ignored);
}

void AtomicFile::commit() {
  flush_to_disk(temporary_);
  std::error_code error;
  fs::rename(temporary_, target_, error);
  if (error) throw Error("cannot write: " + error.message(), target_.string());
  temporary_.clear();
}

TemporaryFolder::TemporaryFolder(std::string_view prefix) {
  std::error_code error;
  std::string pattern = (fs::temp_directory_path(error) / fmt::format("{}-XXXXXX", prefix)).string();
  if (error || !::mkdtemp(pattern.data()))
    throw Error("cannot make a temporary folder: " + system_message(), pattern);
  path_ = pattern;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

std::string escape_file_name(std::string_view name) {
  std::string result;
  for (const char c : name) {
    const bool leading_dot = c == '.' && result.empty();
    if (is_plain(c) && !leading_dot)
      result += c;
    else
      result += fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  if (result.empty()) return "%";
  if (result.size() <= kMaxFileNameBytes) return result;
  // A cut name keeps its hash apart with %%, which no escaped name contains.
  return result.substr(0, kMaxFileNameBytes - 18) + "%%" + hash_bytes(name).substr(0, 16);
}

fs::path resolve_path(std::string_view text, const fs::path& base, const std::string& where) {
  std::string result;
  for (std::size_t i = 0; i < text.size();) {
    if (text.compare(i, 2, "${") != 0) {
      result += text[i++];
      continue;
    }
    const std::size_t end = text.find('}', i);
    if (end == std::string_view::npos) throw Error("a '${' without its '}'", where);
    const std::string name(text.substr(i + 2, end - i - 2));
    if (!name.starts_with("LIGHTBENCH_"))
      throw Error(
          fmt::format("only variables that start with LIGHTBENCH_ may stand in a path, not '{}'", name),
          where);
    const char* value = std::getenv(name.c_str());
    if (!value || !*value) throw Error(fmt::format("the environment variable {} is not set", name), where);
    result += value;
    i = end + 1;
  }
  if (result.empty()) throw Error("an empty path", where);
  if (result.find('\0') != std::string::npos) throw Error("a path with a zero byte", where);
  return (base / result).lexically_normal();
}

fs::path executable_path() {
  return fs::read_symlink("/proc/self/exe");
}

}  // namespace lightbench
