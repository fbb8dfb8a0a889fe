#pragma once

#include <string>
#include <vector>

#include "base/image.h"
#include "base/params.h"
#include "renderer/caustics/light_tracer.h"
#include "scene/scene.h"

namespace lightbench {

/// Raised when equal arguments give another image.
inline constexpr int kLightTracerVersion = 2;
/// "light tracer 2, Embree 3.13.5".
std::string light_tracer_version();

struct LightTracedOptions {
  LightTraceOptions trace;
  bool surface =
      true;  ///< whether the water's surface shows what is below it refracted, and the background reflected
};

struct LightTracedImage {
  Image image;   ///< linear RGBA; alpha is the share of a pixel's primary rays that hit something
  double noise;  ///< estimated mean error of the sRGB image, of 255: half the difference of two halves of the
                 ///< rays
};

/// A picture of a scene with water, by rays from its lights: each surface shows its colour times what lands
/// around (trace_light) times the cosine to the axis of its map, and ambient light; what is above
/// the water is lit directly, with shadows. What a map does not show, since something stands over it, gets no
/// light. The scene must be at the view's time and have water and lights that shine through it
/// (water_light_problem); else throws Error.
LightTracedImage light_traced_image(const Scene& scene, const View& view, int width, int height,
                                    int supersampling, const LightTracedOptions& options);

/// The options as rows, and what is made of values.
std::vector<ParamSpec> light_tracer_params();
LightTracedOptions light_tracer_options(const ParamValues& params);

}  // namespace lightbench
