#pragma once

#include <cstdint>
#include <random>

#include <glm/vec3.hpp>

#include "scene/scene.h"

namespace lightbench {

/// Random numbers that are equal on every platform, unlike those of the standard distributions.
class RawRandom {
 public:
  explicit RawRandom(std::uint64_t seed) : engine_(seed) {}

  double unit() { return double(engine_() >> 11) * 0x1p-53; }  ///< 0 <= x < 1
  double between(double low, double high) { return low + (high - low) * unit(); }
  glm::dvec3 point(const Bounds& bounds) {
    const double x = between(bounds.min.x, bounds.max.x);
    const double y = between(bounds.min.y, bounds.max.y);
    const double z = between(bounds.min.z, bounds.max.z);
    return {x, y, z};
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace lightbench
