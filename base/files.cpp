#include "base/files.h"

#include <cstdlib>

#include <fmt/format.h>

#include "base/atomic_file.h"
#include "base/error.h"
#include "base/hash.h"

namespace lightbench {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t kMaxFileNameBytes = 120;

bool is_plain(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' || c == '_' ||
         c == '-' || c == '+' || c == '=' || c == '~' || c == ',' || c == '[' || c == ']';
}

std::string with_doubled_braces(const std::string& text) {
  std::string result;
  for (const char c : text) result.append(c == '{' ? 2 : 1, c);
  return result;
}

/// The value of the variable that a path names.
std::string variable(const std::string& name, const std::string& where) {
  if (!name.starts_with("LIGHTBENCH_"))
    throw Error(fmt::format("only variables that start with LIGHTBENCH_ may stand in a path, not '{}'", name),
                where);
  const char* value = std::getenv(name.c_str());
  if (!value || !*value) throw Error(fmt::format("the environment variable {} is not set", name), where);
  return value;
}

/// The text of a path with `written(value)` for each variable.
template <typename Written>
std::string with_variables(std::string_view text, const std::string& where, const Written& written) {
  std::string result;
  for (std::size_t i = 0; i < text.size();) {
    if (text.compare(i, 3, "$${") == 0) {
      result += "${";
      i += 3;
      continue;
    }
    if (text.compare(i, 2, "${") != 0) {
      result += text[i++];
      continue;
    }
    const std::size_t end = text.find('}', i);
    if (end == std::string_view::npos) throw Error("a '${' without its '}'", where);
    result += written(variable(std::string(text.substr(i + 2, end - i - 2)), where));
    i = end + 1;
  }
  if (result.empty()) throw Error("an empty path", where);
  if (result.find('\0') != std::string::npos) throw Error("a path with a zero byte", where);
  return result;
}

}  // namespace

std::string read_file(const fs::path& file, std::uint64_t largest) {
  InputFile input(file, largest);
  std::string bytes(input.size(), '\0');
  bytes.resize(input.read(bytes));
  return bytes;
}

void write_file_atomic(const fs::path& file, std::string_view bytes) {
  AtomicFile target(file);
  target.write(bytes);
  target.commit();
}

std::string escape_file_name(std::string_view name, std::string_view reserved) {
  std::string result;
  for (const char c : name) {
    const bool leading_dot = c == '.' && result.empty();
    if (is_plain(c) && !leading_dot && reserved.find(c) == reserved.npos)
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
  return (base / with_variables(text, where, [](std::string value) { return value; })).lexically_normal();
}

std::string resolve_pattern(std::string_view pattern, const fs::path& base, const std::string& where) {
  return (fs::path(with_doubled_braces(base.string())) / with_variables(pattern, where, with_doubled_braces))
      .lexically_normal()
      .string();
}

std::string unresolved(std::string_view path) {
  std::string result;
  for (std::size_t i = 0; i < path.size(); ++i) result.append(path.compare(i, 2, "${") == 0 ? 2 : 1, path[i]);
  return result;
}

fs::path executable_path() {
  return fs::read_symlink("/proc/self/exe");
}

}  // namespace lightbench
