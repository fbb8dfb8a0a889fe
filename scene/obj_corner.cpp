#include "scene/obj_corner.h"

#include <charconv>
#include <cstdlib>
#include <limits>

namespace lightbench {
namespace {

constexpr std::int32_t kTooLarge = std::numeric_limits<std::int32_t>::max();

// Takes "[+-]digits" off the front of `word`. No digits are 0; nothing where there is only a sign.
std::optional<std::int32_t> take_index(std::string_view& word) {
  const bool negative = word.starts_with('-');
  if (negative || word.starts_with('+')) {
    word.remove_prefix(1);
    if (word.empty() || word[0] < '0' || word[0] > '9') return std::nullopt;
  }
  if (word.starts_with('-')) return std::nullopt;  // which from_chars would take
  std::int32_t index = 0;
  const auto [next, error] = std::from_chars(word.data(), word.data() + word.size(), index);
  if (error == std::errc::result_out_of_range) index = kTooLarge;
  word.remove_prefix(std::size_t(next - word.data()));
  return negative ? -index : index;
}

}  // namespace

std::optional<WrittenCorner> read_corner(std::string_view word) {
  WrittenCorner corner;
  if (word.starts_with('/')) return std::nullopt;
  const auto position = take_index(word);
  if (!position || std::abs(*position) == kTooLarge) return std::nullopt;
  corner.position = *position;
  for (std::int32_t* index : {&corner.uv, &corner.normal}) {
    if (!word.starts_with('/')) break;
    word.remove_prefix(1);
    const bool is_given = !word.empty() && word[0] != '/';
    const auto read = take_index(word);
    if (!read) return std::nullopt;
    *index = is_given && *read == 0 ? kTooLarge : *read;
  }
  return word.empty() ? std::optional(corner) : std::nullopt;
}

}  // namespace lightbench
