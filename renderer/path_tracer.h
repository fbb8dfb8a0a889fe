#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/image.h"
#include "base/params.h"
#include "scene/scene.h"

namespace lightbench {

/// Raised when equal arguments give another image.
inline constexpr int kPathTracerVersion = 1;
/// "path tracer 1, Embree 3.13.5".
std::string path_tracer_version();

struct PathTracerOptions {
  int bounces = 2;         ///< of indirect light, 0 to 16
  int samples = 256;       ///< paths of each primary ray, 2 to 65536; rounded up to an even number
  double noise = 0;        ///< estimated error, of 255, at which a tile is done with fewer; 0: never
  std::uint64_t seed = 1;  ///< of all random choices
  int threads = 1;         ///< 1 to 256; the image does not depend on it
};

/// How fast a class of rays was traced, without the shading.
struct RayRate {
  std::string name;  ///< primary, shadow, diffuse
  std::uint64_t rays;
  double seconds;  ///< summed over threads
};

struct PathTracedImage {
  Image image;  ///< linear RGBA; alpha is the share of a pixel's primary rays that hit something, the
                ///< background's colour stands behind
  /// Estimated mean error of the sRGB image, of 255: half the difference of two images of half the samples
  /// each.
  double noise;
  std::vector<RayRate> rays;
};

/// The lighting model of technique `direct`, with light that arrives over any number of diffuse bounces:
/// point, spot, directional and area lights (as their points), emitting surfaces (from the first bounce on)
/// and the background. Primary rays go through the centres of the pixels, or of the supersampling^2 parts of
/// each. The scene must be at the view's time. The result depends on nothing but the arguments. Throws Error
/// for options out of range, an image size that is not possible, a scene without triangles, and what is not
/// finite.
PathTracedImage trace_paths(const Scene& scene, const View& view, int width, int height, int supersampling,
                            const PathTracerOptions& options);

/// The options as rows, named sets of them, and what is made of values.
std::vector<ParamSpec> path_tracer_params();
std::vector<ParamPreset> path_tracer_presets();
PathTracerOptions path_tracer_options(const ParamValues& params);

}  // namespace lightbench
