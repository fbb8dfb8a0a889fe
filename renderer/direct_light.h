#pragma once

#include <span>
#include <string>
#include <vector>

#include "base/params.h"
#include "renderer/gbuffer.h"
#include "renderer/gl_objects.h"
#include "renderer/technique.h"

namespace lightbench {

enum class ShadowMode {
  none,
  hard,  ///< one comparison with the receiver's plane at the texel's centre
  pcf,   ///< the same for a block of texels, weighted
  esm,   ///< exponential shadow maps with four bilinear taps (image-space radiosity thesis, section 4.6)
};

struct ShadowOptions {
  ShadowMode mode = ShadowMode::hard;
  int point_size = 2048;        ///< texels along a cube map's edge; spots too
  int directional_size = 4096;  ///< texels along each slice of a directional light's map
  int slices = 4;      ///< of the camera's depths, each with a directional map of its own (hard, pcf)
  float bias = 0.5f;   ///< texels by which an occluder must be nearer than the receiver's plane
  int pcf_radius = 1;  ///< texels to each side: (2r+1)^2 comparisons
  int esm_size = 512;  ///< texels along an exponential map's edge
  int directional_esm_size = 1024;
  float esm_sharpness = 90;  ///< the constant c of eq. 30
  int esm_blur_radius = 2;   ///< texels
};

/// The rows of the shadow parameters, for techniques that are lit directly, and the options made from their
/// values.
std::vector<ParamSpec> shadow_params();
ShadowOptions shadow_options(const ParamValues& params);

/// Which textures besides `lit` are wanted.
struct DirectLightOutputs {
  bool irradiance = false;
  bool back_irradiance = false;  ///< with irradiance only, and without visibility
  bool visibility = false;
};

struct DirectLight {
  /// RGBA32F: emission + diffuse + specular in linear light, alpha 1; the background's colour, alpha 0,
  /// elsewhere.
  GlTexture lit;
  /// RGBA32F, if asked for: the sum over lights of colour * power * attenuation * visibility * max(n.l, 0),
  /// which times the albedo is the diffuse light. 0 on the background.
  GlTexture irradiance;
  /// RGBA32F, if asked for: the same of the surface's other side, which has the opposite normal.
  GlTexture back_irradiance;
  /// R32F, if asked for: mean over lights of the visible share, 0 for those behind the surface; 1 on the
  /// background.
  GlTexture visibility;
};

/// What is lit, and what for.
struct LitPicture {
  const GBuffer& gbuffer;
  DirectLightOutputs outputs;
};

/// Lights G-buffers, light after light; an area light point after point, each with a shadow map of its own
/// that serves all pictures. Timed as the passes "shadow map" and "direct" (sums over the lights).
std::vector<DirectLight> draw_direct_light(FrameContext& frame, std::span<const LitPicture> pictures,
                                           const ShadowOptions& shadows);
/// The same for one.
DirectLight draw_direct_light(FrameContext& frame, const GBuffer& gbuffer, const ShadowOptions& shadows,
                              const DirectLightOutputs& outputs = {});

/// Mean of the irradiance over the pixels that show an object; 0 where there is none.
glm::vec3 mean_irradiance(FrameContext& frame, const GBuffer& gbuffer, const GlTexture& irradiance);

}  // namespace lightbench
