#pragma once

#include <cstdint>
#include <vector>

#include "renderer/paths/path_lights.h"

namespace lightbench {

/// A light point as texels ask it.
class BakeLight {
 public:
  /// Stands where the light says.
  explicit BakeLight(const Light& point) : light_(point) {}
  /// The sample-th of `samples` points of an area light, placed by each texel's seed.
  BakeLight(const Light& area, int light, int sample, int samples);

  /// The light that arrives at eight texels, each with its seed.
  Incident8 incident(const Surfaces8& surfaces, UInt8 seeds) const;
  bool directional() const { return light_.directional(); }

 private:
  Vec8 position(UInt8 seeds) const;

  PathLight light_;
  const Light* area_ = nullptr;
  std::uint32_t number_ = 0, sample_ = 0;
};

/// The lights of a scene that can send any light: with `samples` points on each area light, or, with 0, its
/// own fixed points. Keeps references to them.
std::vector<BakeLight> bake_lights(const Scene& scene, int samples);

}  // namespace lightbench
