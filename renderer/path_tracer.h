#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/image.h"
#include "base/params.h"
#include "scene/scene.h"

namespace lightbench {

/// Raised when equal arguments give another image.
inline constexpr int kPathTracerVersion = 3;
/// "path tracer 3, Embree 3.13.5".
std::string path_tracer_version();

/// Limits of what light is gathered from: the surfaces that pictures from the camera's place hold, as in
/// screen-space methods (renderer/surround.h), lit on both sides.
struct SightLimits {
  float wide_factor = 1;      ///< a picture along the view is so many times as wide as the frame
  bool all_around = false;    ///< there are pictures of all other directions too
  int layers = 1;             ///< surfaces kept along a ray from the camera, nearest first
  bool front_faces = true;    ///< behind the first keep only those whose shading normal faces the camera
  bool fill_unknown = false;  ///< what comes from elsewhere: the mean of what is known, or nothing
};

struct PathTracerOptions {
  int bounces = 2;         ///< of indirect light, 0 to 16
  int samples = 256;       ///< paths of each primary ray, 2 to 65536; rounded up to an even number
  double noise = 0;        ///< estimated error, of 255, at which a tile is done with fewer; 0: never
  std::uint64_t seed = 1;  ///< of all random choices
  int threads = 1;         ///< 1 to 256; the image does not depend on it
  bool background = true;  ///< whether paths gather the background, where it lights
  std::optional<SightLimits> limits;  ///< empty: light comes from everywhere
};

/// How fast a class of rays was traced, without the shading.
struct RayRate {
  std::string name;  ///< primary, shadow, diffuse; with limits, sight: from the camera to what paths met
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
  /// With limits only: linear RGB, what is added to the direct light; and one channel, the share of a pixel's
  /// paths whose first ray went to what no picture holds. Both are 0 on the background.
  Image indirect, unknown;
};

/// The lighting model of technique `direct`, with light that arrives over any number of diffuse bounces:
/// point, spot, directional and area lights (as their points), emitting surfaces (from the first bounce on)
/// and the background. Primary rays go through the centres of the pixels, or of the supersampling^2 parts of
/// each. The scene must be at the view's time. The result depends on nothing but the arguments. Throws Error
/// for options out of range, an image size that is not possible, a scene without triangles, and what is not
/// finite.
PathTracedImage trace_paths(const Scene& scene, const View& view, int width, int height, int supersampling,
                            const PathTracerOptions& options);

/// What the picture is for. Each use has a default seed of its own, since two pictures of one seed agree in
/// their noise: the variant would look as if it were exact.
enum class PathTracedUse { reference, variant };
std::uint64_t default_seed(PathTracedUse use);

/// The options as rows, named sets of them, and what is made of values.
std::vector<ParamSpec> path_tracer_params(PathTracedUse use);
std::vector<ParamPreset> path_tracer_presets();
PathTracerOptions path_tracer_options(const ParamValues& params);

}  // namespace lightbench
