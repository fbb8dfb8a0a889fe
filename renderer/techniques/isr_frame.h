#pragma once

#include <optional>
#include <string>

#include <glm/vec2.hpp>

#include "base/params.h"
#include "renderer/frame_context.h"

/// What the passes of technique `isr` share.
namespace lightbench {

// Texture units of techniques/isr/*.glsl.
inline constexpr unsigned kPatchUnit = 6;
inline constexpr unsigned kCoarseRadianceUnit = 7;
inline constexpr unsigned kCoarseNormalUnit = 8;
inline constexpr unsigned kDepthUnit = 8;
inline constexpr unsigned kIndirectUnit = 9;
inline constexpr unsigned kLightUnit = 9;
inline constexpr unsigned kCoverUnit = 10;
inline constexpr unsigned kLitUnit = 11;

/// The frame in blocks of pixels: techniques/isr/coarse.glsl.
struct CoarseScene {
  GlTexture patches;
  GlTexture radiance;
  GlTexture normals;
  GlTexture depths;
};

/// What is gathered for its patches.
struct CoarseLight {
  GlTexture indirect;              ///< RGBA16F: light of a white surface; alpha: the share of directions seen
  std::optional<GlTexture> cover;  ///< RG16F: ambient openness; the share of directions that surfaces cover
};

/// One frame's inputs, common to all passes.
struct Isr {
  FrameContext& frame;
  const ParamValues& params;
  const GBuffer& gbuffer;
  const DirectLight& direct;
  ShaderDefines defines;
  glm::ivec2 coarse_size;
  bool occlusion;

  float number(const char* name) const { return float(params.number(name)); }
  bool is(const char* name, const char* choice) const { return params.text(name) == choice; }
  int block() const { return params.integer("resolution"); }
  const Program& program(const std::string& name, const ShaderDefines& more = {}) const {
    ShaderDefines all = defines;
    all.insert(all.end(), more.begin(), more.end());
    return frame.fullscreen_program("techniques/isr/" + name + ".frag.glsl", all);
  }
  GlTexture coarse_texture(TexelFormat format) const {
    return GlTexture(format, coarse_size.x, coarse_size.y);
  }
};

/// Texels for `light`, and to draw into them.
inline CoarseLight make_light(const Isr& isr) {
  CoarseLight light{isr.coarse_texture(TexelFormat::rgba16f), std::nullopt};
  if (isr.occlusion) light.cover = isr.coarse_texture(TexelFormat::rg16f);
  return light;
}

inline Framebuffer target_of(const CoarseLight& light) {
  if (light.cover) return Framebuffer({&light.indirect, &*light.cover});
  return Framebuffer({&light.indirect});
}

}  // namespace lightbench
