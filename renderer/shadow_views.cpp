#include <algorithm>
#include <cmath>

#include "renderer/shadow_map.h"

namespace lightbench {
namespace {

// Wider spots are drawn to the faces of a cube.
constexpr float kWidestPerspective = 1.05f;

// In units of the casters' size: nearer to a light than this nothing casts a shadow.
constexpr float kNearestCaster = 1e-5f;

struct Axes {
  glm::vec3 right, up, forward;
};

// Order of the faces as in shaders/light.glsl: +x -x +y -y +z -z.
constexpr std::array<Axes, 6> kCubeAxes{{
    {{0, 0, -1}, {0, 1, 0}, {1, 0, 0}},
    {{0, 0, 1}, {0, 1, 0}, {-1, 0, 0}},
    {{1, 0, 0}, {0, 0, 1}, {0, 1, 0}},
    {{1, 0, 0}, {0, 0, -1}, {0, -1, 0}},
    {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
    {{-1, 0, 0}, {0, 1, 0}, {0, 0, -1}},
}};

Axes axes_along(const glm::vec3& forward) {
  const glm::vec3 helper = std::abs(forward.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
  const glm::vec3 right = glm::normalize(glm::cross(forward, helper));
  return {right, glm::cross(right, forward), forward};
}

LightBlock::View view_of(const Axes& axes) {
  return {glm::vec4(axes.right, 0), glm::vec4(axes.up, 0), glm::vec4(axes.forward, 1)};
}

template <typename Function>
void for_each_corner(const Bounds& box, Function function) {
  for (int i = 0; i < 8; ++i)
    function(glm::vec3((i & 1) ? box.max.x : box.min.x, (i & 2) ? box.max.y : box.min.y,
                       (i & 4) ? box.max.z : box.min.z));
}

void place_orthographic(LightBlock& block, const Light& light, const Bounds& casters) {
  float first = std::numeric_limits<float>::max();
  float last = std::numeric_limits<float>::lowest();
  for_each_corner(casters, [&](const glm::vec3& corner) {
    const float along = glm::dot(corner - casters.center(), light.direction);
    first = std::min(first, along);
    last = std::max(last, along);
  });
  const float spare = std::max(0.01f * (last - first), 1e-6f);
  const glm::vec3 origin = casters.center() + light.direction * (first - spare);
  block.shadow_origin = glm::vec4(origin, last - first + 2 * spare);
  block.views.fill(view_of(axes_along(light.direction)));
}

void place_perspective(LightBlock& block, const Light& light, const Bounds& casters) {
  block.shadow_origin = glm::vec4(light.position, std::max(kNearestCaster * casters.diagonal(), 1e-9f));
  if (shadow_projection(light) == ShadowProjection::perspective)
    block.views[0] = view_of(axes_along(light.direction));
  else
    std::transform(kCubeAxes.begin(), kCubeAxes.end(), block.views.begin(), view_of);
}

}  // namespace

ShadowProjection shadow_projection(const Light& light) {
  if (light.kind == LightKind::directional) return ShadowProjection::orthographic;
  if (light.kind == LightKind::spot && light.outer_angle <= kWidestPerspective)
    return ShadowProjection::perspective;
  return ShadowProjection::cube;
}

ShaderDefines projection_defines(ShadowProjection projection) {
  switch (projection) {
    case ShadowProjection::cube:
      return {"SHADOW_CUBE"};
    case ShadowProjection::perspective:
      return {};
    case ShadowProjection::orthographic:
      return {"SHADOW_ORTHOGRAPHIC"};
  }
  return {};
}

LightBlock light_block(const Light& light, float share) {
  LightBlock block{};
  block.position = glm::vec4(light.position, light.kind != LightKind::directional);
  block.direction = glm::vec4(light.direction, light.kind == LightKind::spot);
  block.color = glm::vec4(light.color * light.power, share);
  const Attenuation& fade = light.attenuation;
  block.attenuation = glm::vec4(float(fade.kind), fade.distance, fade.power, fade.radius);
  block.cone = glm::vec4(std::cos(light.inner_angle), std::cos(light.outer_angle), 0, 0);
  return block;
}

void place_shadow_views(LightBlock& block, const Light& light, const Bounds& casters) {
  if (light.kind == LightKind::directional)
    place_orthographic(block, light, casters);
  else
    place_perspective(block, light, casters);
}

void slice_depths(LightBlock& block, float nearest, float farthest, int count) {
  const float doublings = std::log2(std::max(farthest / nearest, 1.0f));
  const float per_doubling = doublings > 0 ? float(count) / doublings : 0.0f;
  block.shadow_slices = glm::vec4(std::log2(nearest), per_doubling, float(count - 1), 0);
}

void fit_view(LightBlock::View& view, const ViewExtent& extent, float least, int size, int margin) {
  if (extent.empty()) {
    view.forward.w = 0;
    return;
  }
  const glm::vec2 center = 0.5f * (extent.min + extent.max);
  const float spare = float(size) / float(size - 2 * margin);
  const glm::vec2 half =
      glm::max(0.5f * (extent.max - extent.min), glm::vec2(least) + 1e-6f * glm::abs(center)) * spare;
  view.right = glm::vec4(glm::vec3(view.right) / half.x, center.x / half.x);
  view.up = glm::vec4(glm::vec3(view.up) / half.y, center.y / half.y);
}

glm::dmat4 shadow_clip_matrix(const LightBlock& block, int view, ShadowProjection projection) {
  const LightBlock::View& v = block.views[std::size_t(view)];
  const glm::dvec3 right(v.right), up(v.up), forward(v.forward);
  const double center_x = v.right.w, center_y = v.up.w, range = block.shadow_origin.w;
  glm::dmat4 from_origin(0.0);
  const bool flat = projection == ShadowProjection::orthographic;
  for (int i = 0; i < 3; ++i)
    from_origin[i] =
        flat ? glm::dvec4(right[i], up[i], -forward[i] / range, 0)
             : glm::dvec4(right[i] - center_x * forward[i], up[i] - center_y * forward[i], 0, forward[i]);
  from_origin[3] = flat ? glm::dvec4(-center_x, -center_y, 1, 1) : glm::dvec4(0, 0, range, 0);
  glm::dmat4 to_origin(1.0);
  to_origin[3] = glm::dvec4(-glm::dvec3(block.shadow_origin), 1);
  return from_origin * to_origin;
}

}  // namespace lightbench
