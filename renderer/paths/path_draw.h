#pragma once

#include "renderer/paths/sobol.h"

namespace lightbench {

/// What a pair of random numbers of a path is for; each has dimensions of its own at each bounce.
enum class Draw : std::uint32_t { direction, emitter_pick, emitter_place, light_pick };

/// The numbers of the index-th path of those that share a seed.
template <typename UInt>
[[gnu::always_inline]] inline SobolPair<UInt> draw(UInt index, UInt path_seed, int bounce, Draw purpose) {
  return sobol_pair(index, hash_pair(path_seed, 4 * std::uint32_t(bounce) + std::uint32_t(purpose)));
}

/// Of all paths of a picture; of those of a primary ray.
inline std::uint32_t picture_seed(std::uint64_t seed) {
  return hash_pair(hash_bits(std::uint32_t(seed)), std::uint32_t(seed >> 32));
}
inline std::uint32_t primary_seed(std::uint32_t picture, int x, int y) {
  return hash_pair(hash_pair(picture, std::uint32_t(x)), std::uint32_t(y));
}
/// Of one half of a primary ray's paths.
inline std::uint32_t half_seed(std::uint32_t primary, int half) {
  return hash_pair(primary, std::uint32_t(half));
}

}  // namespace lightbench
