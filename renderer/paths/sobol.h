#pragma once

#include <cstdint>

/// Owen-scrambled Sobol points by hashing: Burley, "Practical Hash-based Owen Scrambling", JCGT 9(4), 2020.
/// Higher dimensions are padded with pairs, each with an order and a scrambling of its own (his section 5).
/// All functions take std::uint32_t or vectors of it.
namespace lightbench {

template <typename UInt>
[[gnu::always_inline]] inline UInt reverse_bits(UInt n) {
  n = (n << 16) | (n >> 16);
  n = ((n & 0x00ff00ffu) << 8) | ((n & 0xff00ff00u) >> 8);
  n = ((n & 0x0f0f0f0fu) << 4) | ((n & 0xf0f0f0f0u) >> 4);
  n = ((n & 0x33333333u) << 2) | ((n & 0xccccccccu) >> 2);
  return ((n & 0x55555555u) << 1) | ((n & 0xaaaaaaaau) >> 1);
}

/// A good hash of 32 bits (Wellons's lowbias32).
template <typename UInt>
[[gnu::always_inline]] inline UInt hash_bits(UInt n) {
  n ^= n >> 16;
  n *= 0x21f0aaadu;
  n ^= n >> 15;
  n *= 0xd35a2d97u;
  return n ^ (n >> 15);
}

/// A hash of both.
template <typename UInt>
[[gnu::always_inline]] inline UInt hash_pair(UInt seed, std::uint32_t value) {
  return hash_bits(seed ^ (value * 0x9e3779b9u + 0x85ebca6bu));
}

/// A permutation in which each bit is flipped by a hash of the bits below it (Laine and Karras, 2011, with
/// Vegdahl's constants).
template <typename UInt>
[[gnu::always_inline]] inline UInt laine_karras(UInt n, UInt seed) {
  n ^= n * 0x3d20adeau;
  n += seed;
  n *= (seed >> 16) | 1u;
  n ^= n * 0x05526c56u;
  n ^= n * 0x53a22864u;
  return n;
}

/// The index-th value of the second dimension with its bits reversed. The generator matrix is Pascal's
/// triangle modulo 2, where (i over k) is odd when k's bits are among i's: a sum over supersets, made bit by
/// bit. The first dimension with its bits reversed is the index itself.
template <typename UInt>
[[gnu::always_inline]] inline UInt sobol_second_reversed(UInt index) {
  index ^= (index & 0xaaaaaaaau) >> 1;
  index ^= (index & 0xccccccccu) >> 2;
  index ^= (index & 0xf0f0f0f0u) >> 4;
  index ^= (index & 0xff00ff00u) >> 8;
  return index ^ (index >> 16);
}

template <typename UInt>
struct SobolPair {
  UInt x, y;  ///< of 2^32
};

/// The index-th point of the scrambled (0,2)-sequence that `seed` picks.
template <typename UInt>
[[gnu::always_inline]] inline SobolPair<UInt> sobol_pair(UInt index, UInt seed) {
  const UInt shuffled = reverse_bits(laine_karras(reverse_bits(index), hash_pair(seed, 0)));
  return {reverse_bits(laine_karras(shuffled, hash_pair(seed, 1))),
          reverse_bits(laine_karras(sobol_second_reversed(shuffled), hash_pair(seed, 2)))};
}

/// 0 <= result < 1.
inline float unit_float(std::uint32_t n) {
  return float(n >> 8) * 0x1p-24f;
}

}  // namespace lightbench
