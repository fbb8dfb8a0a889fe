#include "base/input_file.h"

#include <array>
#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/error.h"

namespace lightbench {
namespace {

const char* kind_of(mode_t mode) {
  if (S_ISFIFO(mode)) return "a FIFO";
  if (S_ISSOCK(mode)) return "a socket";
  return S_ISCHR(mode) || S_ISBLK(mode) ? "a device" : "something else";
}

[[noreturn]] void fail_to_open(const std::filesystem::path& file) {
  const int error = errno;
  struct stat facts {};
  if (::stat(file.c_str(), &facts) == 0 && S_ISSOCK(facts.st_mode))
    throw Error("is not a regular file (a socket)", file.string());
  throw Error(fmt::format("cannot read the file: {}", std::strerror(error)), file.string());
}

std::uint64_t checked_size(const struct stat& facts, std::uint64_t largest, const std::string& where) {
  if (S_ISDIR(facts.st_mode)) throw Error("is a folder, not a file", where);
  if (!S_ISREG(facts.st_mode))
    throw Error(fmt::format("is not a regular file ({})", kind_of(facts.st_mode)), where);
  const auto size = std::uint64_t(facts.st_size);
  if (size > largest)
    throw Error(
        fmt::format("the file has {}, and at most {} are read", bytes_text(size), bytes_text(largest)),
        where);
  return size;
}

}  // namespace

InputFile::InputFile(std::filesystem::path file, std::uint64_t largest)
    : file_(std::move(file)),
      descriptor_(::open(file_.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY)) {
  if (descriptor_ < 0) fail_to_open(file_);
  struct stat facts {};
  try {
    if (::fstat(descriptor_, &facts) != 0) fail_to_open(file_);
    size_ = checked_size(facts, largest, file_.string());
  } catch (...) {
    ::close(descriptor_);
    throw;
  }
}

InputFile::~InputFile() {
  ::close(descriptor_);
}

std::size_t InputFile::read(std::span<char> bytes) {
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t count = ::read(descriptor_, bytes.data() + done, bytes.size() - done);
    if (count == 0) break;
    if (count > 0)
      done += std::size_t(count);
    else if (errno != EINTR)
      throw Error(fmt::format("cannot read the file: {}", std::strerror(errno)), file_.string());
  }
  return done;
}

std::string bytes_text(std::uint64_t bytes) {
  constexpr std::array kUnits{"bytes", "kB", "MB", "GB", "TB", "PB", "EB"};
  if (bytes == 1) return "1 byte";
  double amount = double(bytes);
  std::size_t unit = 0;
  for (; amount >= 1000 && unit + 1 < kUnits.size(); ++unit) amount /= 1000;
  return fmt::format("{:.4g} {}", amount, kUnits[unit]);
}

}  // namespace lightbench
