#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace lightbench {

/// Adds a value to a hash of several.
inline std::uint64_t mix_hash(std::uint64_t hash, std::uint32_t value) {
  hash = (hash ^ value) * 0x9E3779B97F4A7C15ull;
  return hash ^ (hash >> 29);
}

/// A hash table from keys that the caller keeps to 32-bit values: open addressing, no removal.
class IndexTable {
 public:
  explicit IndexTable(std::size_t capacity) : slots_(std::bit_ceil(2 * capacity + 2), kNone) {}

  /// The stored index for which `equal` holds, or `index`, which is then stored.
  template <typename Equal>
  std::uint32_t find_or_insert(std::uint64_t hash, std::uint32_t index, Equal equal) {
    std::size_t slot = std::size_t(hash) & (slots_.size() - 1);
    while (slots_[slot] != kNone) {
      if (equal(slots_[slot])) return slots_[slot];
      slot = (slot + 1) & (slots_.size() - 1);
    }
    return slots_[slot] = index;
  }

 private:
  static constexpr std::uint32_t kNone = ~0u;

  std::vector<std::uint32_t> slots_;
};

}  // namespace lightbench
