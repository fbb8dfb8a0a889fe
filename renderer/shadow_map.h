#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

#include "renderer/direct_light.h"
#include "renderer/gl_framebuffer.h"
#include "renderer/gl_objects.h"
#include "renderer/gl_program.h"

namespace lightbench {

inline constexpr int kMaxShadowViews = 6;

/// The block Light of shaders/light.glsl, std140. Shadow views are the six faces of a cube around a point
/// light, the one perspective view of a narrow spot, or the orthographic views of a directional light, one
/// for each slice of the camera's depths (slices grow with the distance). Each is fitted to what the camera
/// sees of it, so that no texels are spent elsewhere.
struct LightBlock {
  struct View {
    glm::vec4 right;
    glm::vec4 up;
    glm::vec4 forward;
  };
  glm::vec4 position;
  glm::vec4 direction;
  glm::vec4 color;
  glm::vec4 attenuation;
  glm::vec4 cone;
  glm::vec4 shadow_origin;
  glm::vec4 shadow_extent;
  glm::vec4 shadow_slices;
  std::array<View, kMaxShadowViews> views;
};
static_assert(sizeof(LightBlock) == 16 * std::size_t{8 + 18});

enum class ShadowProjection { cube, perspective, orthographic };
ShadowProjection shadow_projection(const Light& light);
/// What shaders that include light.glsl are compiled with.
ShaderDefines projection_defines(ShadowProjection projection);

/// The light's part of the block; `share` is the part of the mean visibility that it makes.
LightBlock light_block(const Light& light, float share);
/// Sets origin, depth range and views, which are not fitted yet.
void place_shadow_views(LightBlock& block, const Light& light, const Bounds& casters);

/// Divides the depths from `nearest` to `farthest` (eye-space z / far) among `count` orthographic views.
void slice_depths(LightBlock& block, float nearest, float farthest, int count);

/// Smallest and largest coordinates seen across a view; empty where nothing is seen.
struct ViewExtent {
  glm::vec2 min{1e30f};
  glm::vec2 max{-1e30f};
  bool empty() const { return min.x > max.x || min.y > max.y; }
};
/// Narrows a view to an extent, but to no less than `least` to each side, with a margin of some of its `size`
/// texels.
void fit_view(LightBlock::View& view, const ViewExtent& extent, float least, int size, int margin);

/// From world space to the clip space of a view, of reversed depth: 1 nearest to the light.
glm::dmat4 shadow_clip_matrix(const LightBlock& block, int view, ShadowProjection projection);

/// Maps and working space of each projection, kept from frame to frame, since making them costs as much as
/// drawing them.
struct ShadowTextures {
  struct Maps {
    GlTexture depths;   ///< array of depth32f
    GlTexture blurred;  ///< array of r32f, of exponential maps
    std::array<GlTexture, 2> work;
  };
  std::array<Maps, 3> of_projection;
};

/// Draws the shadow map of a light as it needs to be for what any of the G-buffers shows, and completes the
/// block. Returns the texture that shaders/shadow.glsl reads.
const GlTexture& draw_shadow_map(FrameContext& frame, std::span<const LitPicture> seen_by, const Light& light,
                                 const ShadowOptions& options, ShadowTextures& textures, LightBlock& block);

}  // namespace lightbench
