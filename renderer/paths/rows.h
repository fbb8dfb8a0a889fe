#pragma once

#include <vector>

#include "renderer/paths/lanes.h"

/// Between eight things of eight values each, one after the other in memory, and eight vectors of one value
/// of all things: so that shading is eight wide, while paths can be sorted, packed and looked up one by one.
namespace lightbench {

/// Eight values of each of eight things; and the other way round.
struct Fields8 {
  Float8 v[kLanes];
};

inline void set_fields(Fields8& fields, int first, const Vec8& v) {
  fields.v[first] = v.x, fields.v[first + 1] = v.y, fields.v[first + 2] = v.z;
}
inline Vec8 vec_of(const Fields8& fields, int first) {
  return {fields.v[first], fields.v[first + 1], fields.v[first + 2]};
}

/// In place.
[[gnu::always_inline]] inline void transpose(Fields8& fields) {
  Float8(&r)[kLanes] = fields.v;
  Float8 a[kLanes], b[kLanes];
#pragma GCC unroll 8
  for (int i = 0; i < kLanes; i += 2) {
    a[i] = __builtin_shufflevector(r[i], r[i + 1], 0, 8, 1, 9, 4, 12, 5, 13);
    a[i + 1] = __builtin_shufflevector(r[i], r[i + 1], 2, 10, 3, 11, 6, 14, 7, 15);
  }
#pragma GCC unroll 8
  for (int i = 0; i < kLanes; i += 4)
#pragma GCC unroll 8
    for (int j = 0; j < 2; ++j) {
      b[i + 2 * j] = __builtin_shufflevector(a[i + j], a[i + 2 + j], 0, 1, 8, 9, 4, 5, 12, 13);
      b[i + 2 * j + 1] = __builtin_shufflevector(a[i + j], a[i + 2 + j], 2, 3, 10, 11, 6, 7, 14, 15);
    }
#pragma GCC unroll 8
  for (int i = 0; i < 4; ++i) {
    r[i] = __builtin_shufflevector(b[i], b[i + 4], 0, 1, 2, 3, 8, 9, 10, 11);
    r[i + 4] = __builtin_shufflevector(b[i], b[i + 4], 4, 5, 6, 7, 12, 13, 14, 15);
  }
}

/// One thing: a cache line of two times eight values.
struct alignas(64) Row {
  Float8 low, high;
};

/// The things whose numbers `index(lane)` gives, by value.
template <Float8 Row::*half, typename Index>
[[gnu::always_inline]] inline Fields8 load_half(const Row* rows, const Index& index) {
  Fields8 result;
#pragma GCC unroll 8
  for (int i = 0; i < kLanes; ++i) result.v[i] = rows[index(i)].*half;
  transpose(result);
  return result;
}

/// Puts the things in the lanes of the mask one behind the other from rows[size] on; there must be room.
[[gnu::always_inline]] inline void append(std::vector<Row>& rows, int& size, Fields8 low, Fields8 high,
                                          Int8 mask) {
  transpose(low);
  transpose(high);
  for_lanes(mask, [&](int i) { rows[std::size_t(size++)] = {low.v[i], high.v[i]}; });
}

/// The same bits.
inline Float8 as_floats(UInt8 n) {
  return Float8(n);
}
inline UInt8 as_numbers(Float8 v) {
  return UInt8(v);
}

}  // namespace lightbench
