#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "renderer/path_tracer.h"
#include "renderer/radiance/direction_grid.h"
#include "renderer/radiance/object_surface.h"
#include "renderer/radiance/radiance_stack.h"

namespace lightbench {

/// Raised when equal arguments give other texels.
inline constexpr int kBakeVersion = 5;

struct BakeOptions {
  DirectionGrid grid;
  /// On each area light, placed anew for each texel; 0: the fixed points that all other techniques and
  /// references light with, which have no noise.
  int light_samples = 0;
  int bounces = 0;            ///< of indirect light, 0 to 16
  int bounce_samples = 1024;  ///< paths of each texel, 2 to 65536
  std::uint64_t seed = 1;
  float scale = 1;  ///< of the stack (radiance_stack.h)
  int threads = 1;  ///< 1 to 256; the texels do not depend on it
};

/// A texel whose radiance is traced.
struct BakeTexel {
  std::uint32_t place;   ///< in a layer: y * width + x
  std::uint32_t number;  ///< what its random choices follow from
  MeshPoint point;
  Side side;
};

struct BakeNews {
  std::vector<RayRate> rays;
  /// Of the indirect light: the mean over texels of its estimated error, of 255, as the path tracer has it.
  double noise = 0;
  bool lit = false;  ///< whether anything leaves any of them
};

/// Traces what leaves an object in all directions of the grid: emission, direct light with Phong's highlights
/// and soft shadows, and light over `bounces` diffuse bounces; the lighting model is that of the path tracer.
/// All directions of a texel share its shadow rays and its paths, so what is matte is the same in all of them
/// (thesis, chapter 5.1, but for that). Writes the texels into the stack, which has its size already and
/// holds zeros; others are left alone. `progress` is told the share that is done, 0..1, from any thread,
/// never by two at once.
BakeNews bake_texels(const PathScene& scene, std::size_t entity, std::span<const BakeTexel> texels,
                     const BakeOptions& options, HalfStack& stack,
                     const std::function<void(double)>& progress = nullptr);

}  // namespace lightbench
