#pragma once

#include <cstdint>
#include <filesystem>
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
std::string hash_file(const std::filesystem::path& file);

}  // namespace lightbench
