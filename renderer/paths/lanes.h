#pragma once

#include <cstdint>

#include <glm/vec3.hpp>

// Without AVX, such vectors are passed to functions in another way than with it: all of this project is
// compiled alike.
#pragma GCC diagnostic ignored "-Wpsabi"

#ifdef __AVX__
#include <immintrin.h>
#endif

/// Eight values side by side, for shading as wide as a packet of rays. These are the compiler's own vectors
/// (GCC, Clang): one AVX register each, or two of SSE where there is no AVX. Comparisons give masks of all
/// ones.
namespace lightbench {

inline constexpr int kLanes = 8;

using Float8 = float __attribute__((vector_size(32)));
using Int8 = std::int32_t __attribute__((vector_size(32)));
using UInt8 = std::uint32_t __attribute__((vector_size(32)));

inline Float8 splat(float value) {
  return Float8{} + value;
}
inline Float8 select(Int8 mask, Float8 yes, Float8 no) {
  return mask ? yes : no;
}
inline Float8 min8(Float8 a, Float8 b) {
  return select(a < b, a, b);
}
inline Float8 max8(Float8 a, Float8 b) {
  return select(a > b, a, b);
}
inline Float8 abs8(Float8 v) {
  return max8(v, -v);
}

inline Float8 sqrt8(Float8 v) {
#ifdef __AVX__
  return _mm256_sqrt_ps(v);
#else
  for (int i = 0; i < kLanes; ++i) v[i] = __builtin_sqrtf(v[i]);
  return v;
#endif
}

/// Eight floats or whole numbers at an address aligned to 32 bytes.
inline Float8 load8(const float* from) {
  using Aliased = float __attribute__((vector_size(32), may_alias));
  return *reinterpret_cast<const Aliased*>(from);
}
inline void store8(float* to, Float8 v) {
  using Aliased = float __attribute__((vector_size(32), may_alias));
  *reinterpret_cast<Aliased*>(to) = v;
}
inline UInt8 load8(const std::uint32_t* from) {
  using Aliased = std::uint32_t __attribute__((vector_size(32), may_alias));
  return *reinterpret_cast<const Aliased*>(from);
}

/// One bit for each lane of a mask.
inline unsigned bits_of(Int8 mask) {
#ifdef __AVX__
  return unsigned(_mm256_movemask_ps(reinterpret_cast<__m256>(mask)));
#else
  unsigned bits = 0;
  for (int i = 0; i < kLanes; ++i) bits |= (mask[i] != 0 ? 1u : 0u) << i;
  return bits;
#endif
}
inline bool any(Int8 mask) {
  return bits_of(mask) != 0;
}
/// Calls `body(lane)` for each lane of the mask, in order.
template <typename Body>
void for_lanes(Int8 mask, const Body& body) {
  for (unsigned bits = bits_of(mask); bits != 0; bits &= bits - 1) body(__builtin_ctz(bits));
}
/// The first `count` lanes.
inline Int8 first_lanes(int count) {
  return Int8{0, 1, 2, 3, 4, 5, 6, 7} < count;
}

inline UInt8 lane_numbers() {
  return UInt8{0, 1, 2, 3, 4, 5, 6, 7};
}
/// 0 <= result < 1.
inline Float8 unit_float(UInt8 n) {
  return __builtin_convertvector(Int8(n >> 8), Float8) * 0x1p-24f;
}

/// Eight vectors.
struct Vec8 {
  Float8 x, y, z;

  glm::vec3 lane(int i) const { return {x[i], y[i], z[i]}; }
  void set_lane(int i, const glm::vec3& v) { x[i] = v.x, y[i] = v.y, z[i] = v.z; }
};

inline Vec8 load_vec8(const float* x, const float* y, const float* z) {
  return {load8(x), load8(y), load8(z)};
}
inline Vec8 splat(const glm::vec3& v) {
  return {splat(v.x), splat(v.y), splat(v.z)};
}
inline Vec8 operator+(const Vec8& a, const Vec8& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Vec8 operator-(const Vec8& a, const Vec8& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Vec8 operator-(const Vec8& a) {
  return {-a.x, -a.y, -a.z};
}
inline Vec8 operator*(const Vec8& a, const Vec8& b) {
  return {a.x * b.x, a.y * b.y, a.z * b.z};
}
inline Vec8 operator*(const Vec8& a, Float8 s) {
  return {a.x * s, a.y * s, a.z * s};
}
inline Vec8 select(Int8 mask, const Vec8& yes, const Vec8& no) {
  return {select(mask, yes.x, no.x), select(mask, yes.y, no.y), select(mask, yes.z, no.z)};
}
inline Float8 dot(const Vec8& a, const Vec8& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Float8 largest(const Vec8& v) {
  return max8(v.x, max8(v.y, v.z));
}
inline Vec8 abs8(const Vec8& v) {
  return {abs8(v.x), abs8(v.y), abs8(v.z)};
}

}  // namespace lightbench
