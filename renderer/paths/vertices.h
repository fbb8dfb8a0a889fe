#pragma once

#include <vector>

#include "renderer/paths/rows.h"

namespace lightbench {

/// Fields in the upper half of a row of vertices, and of what else belongs to paths.
enum { kSeedField = 4, kIndexField, kSlotField };

/// Ends of eight paths, from where they go on.
struct Vertices8 {
  Vec8 position, normal, offset;
  Vec8 throughput;  ///< share of the light arriving here that the primary ray shows
  UInt8 seed, index, slot;

  static Vertices8 load(const Row* rows);
  void append_to(std::vector<Row>& rows, int& size, Int8 mask) const;
};

inline Vertices8 Vertices8::load(const Row* rows) {
  const auto lane = [](int i) { return i; };
  const Fields8 low = load_half<&Row::low>(rows, lane), high = load_half<&Row::high>(rows, lane);
  return {vec_of(low, 0),
          vec_of(low, 3),
          {low.v[6], low.v[7], high.v[0]},
          vec_of(high, 1),
          as_numbers(high.v[kSeedField]),
          as_numbers(high.v[kIndexField]),
          as_numbers(high.v[kSlotField])};
}

inline void Vertices8::append_to(std::vector<Row>& rows, int& size, Int8 mask) const {
  Fields8 low, high{};
  set_fields(low, 0, position);
  set_fields(low, 3, normal);
  low.v[6] = offset.x, low.v[7] = offset.y, high.v[0] = offset.z;
  set_fields(high, 1, throughput);
  high.v[kSeedField] = as_floats(seed);
  high.v[kIndexField] = as_floats(index);
  high.v[kSlotField] = as_floats(slot);
  append(rows, size, low, high, mask);
}

}  // namespace lightbench
