#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace lightbench {

/// A corner of a face as it is written: indices from 1, or negative ones that count back from the last vertex
/// so far; 0 where the file gives none.
struct WrittenCorner {
  std::int32_t position = 0;
  std::int32_t uv = 0;
  std::int32_t normal = 0;
};

/// Reads v, v/vt, v//vn or v/vt/vn, and the same with nothing behind a slash; nothing where the word is none
/// of these. An index of a uv or a normal that cannot be there, 0 or one of too many digits, is read as the
/// largest number: it is not there either.
std::optional<WrittenCorner> read_corner(std::string_view word);

}  // namespace lightbench
