#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <string_view>

namespace lightbench {

/// A content hash of delimited, named fields (XXH3, 128 bits): field("ab","c") and field("a","bc") differ.
class Hasher {
 public:
  Hasher();
  Hasher(Hasher&&) noexcept;
  Hasher& operator=(Hasher&&) noexcept;
  ~Hasher();

  Hasher& field(std::string_view name, std::string_view bytes);
  Hasher& field(std::string_view name, std::int64_t value);
  /// 32 lower-case hexadecimal digits.
  std::string digest() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

std::string hash_bytes(std::string_view bytes);
/// Returns the hash of what the file holds, which is read block by block. Throws Error where `read_file`
/// would; the default has no limit, since baked objects may have any size.
std::string hash_file(const std::filesystem::path& file,
                      std::uint64_t largest = std::numeric_limits<std::uint64_t>::max());

/// Returns what the file system says of a file that changes with its content: device, inode, size and times.
/// Throws Error where it says nothing.
std::string file_stamp(const std::filesystem::path& file);

/// Calls `read`, which is to read the file, and returns the hash of what it read. Throws Error where the file
/// was changed meanwhile, and what `read` throws.
std::string hash_while_reading(const std::filesystem::path& file, const std::function<void()>& read);

}  // namespace lightbench
