#include "scene/scene_check.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "scene/light_points.h"
#include "scene/motion.h"
#include "scene/nearest_surface.h"

namespace lightbench {
namespace {

// Nearer to a surface than this share of the scene, a light is hidden by it or not as rounding has it.
constexpr float kInSurface = 1e-6f;

// With more points of all lights than this, shadow maps take so long that a warning says so.
constexpr std::size_t kManyPoints = 256;

// For each light all triangles are searched, and so not for more lights than make this many searches.
constexpr std::size_t kMostSearchedTriangles = 4'000'000'000;

bool emits(const Material& m) {
  return m.emission != glm::vec3(0);
}

bool reaches(const Light& light, const Bounds& bounds) {
  const glm::vec3 nearest = glm::clamp(light.position, bounds.min, bounds.max);
  return light.attenuation.kind != Attenuation::Kind::radius ||
         glm::length(light.position - nearest) < light.attenuation.radius;
}

/// Whether points can be moved by it and normals by its inverse, in 32-bit floats.
bool is_usable(const glm::mat4& transform) {
  for (int i = 0; i < 4; ++i)
    if (!std::isfinite(glm::dot(transform[i], transform[i]))) return false;
  return std::isnormal(glm::determinant(glm::mat3(transform)));
}

/// Numbers that are each in their range may be too much together: a transform, a size, and keyframes. Bounds
/// do not tell, since NaN is neither below nor above anything.
void check_places(const Scene& scene, const std::string& where, ProblemList& problems) {
  RepeatedProblem unusable(problems, Problem::Severity::error,
                           "entities that are made too large or too small for 32-bit floats", where);
  for (const Entity& entity : scene.entities) {
    bool usable = is_usable(entity.transform);
    for (const MotionKey& key : entity.motion.keys)
      usable = usable && is_usable(transform_at(entity.motion, key.time));
    if (!usable)
      unusable.add(fmt::format("entity '{}' is made too large or too small for 32-bit floats", entity.name),
                   where);
  }
}

void check_reach(const Scene& scene, const Bounds& bounds, const std::string& where, ProblemList& problems) {
  RepeatedProblem out_of_reach(problems, Problem::Severity::warning,
                               "lights that reach nothing within their radius", where);
  for (const Light& light : scene.lights) {
    if (light.kind == LightKind::directional) continue;
    const std::vector<Light> points = light_points(light);
    if (std::none_of(points.begin(), points.end(),
                     [&](const Light& point) { return reaches(point, bounds); }))
      out_of_reach.add(fmt::format("the light '{}' reaches nothing within its radius", light.name), where);
  }
}

void check_lights_in_surfaces(const Scene& scene, const Bounds& bounds, const std::string& where,
                              ProblemList& problems) {
  RepeatedProblem in_surface(problems, Problem::Severity::warning, "lights that lie in a surface", where);
  std::size_t left = std::max<std::size_t>(kMostSearchedTriangles / triangle_count(scene), 1);
  for (const Light& light : scene.lights) {
    if (light.kind == LightKind::directional || light.kind == LightKind::area) continue;
    if (left-- == 0)
      return problems.note(
          "not all lights are looked at for whether they lie in a surface: it takes too long", where);
    if (distance_to_nearest_surface(scene, light.position) <= kInSurface * bounds.diagonal())
      in_surface.add(fmt::format("the light '{}' lies in a surface", light.name), where);
  }
}

void check_light_points(const Scene& scene, const std::string& where, ProblemList& problems) {
  const std::size_t points = light_point_count(scene);
  if (points > kManyPoints)
    problems.warning(
        fmt::format(
            "the lights have {} points: where OpenGL draws a shadow map of each, a picture takes about "
            "{:.0f} s longer than with few 'points'",
            points, kShadowMapSeconds * double(points)),
        where);
}

void check_materials(const Scene& scene, const std::string& where, ProblemList& problems) {
  std::vector<std::string> bright;
  std::vector<std::string> emitting;
  std::vector<std::string> blackened;
  for (const Material& m : scene.materials) {
    if (std::max({m.diffuse.x, m.diffuse.y, m.diffuse.z}) > 1) bright.push_back(m.name);
    if (emits(m)) emitting.push_back(m.name);
    if (m.diffuse_texture != kNoTexture && m.diffuse == glm::vec3(0)) blackened.push_back(m.name);
  }
  if (!bright.empty())
    problems.warning(fmt::format("{}: a diffuse colour above 1 gives back more light than it gets",
                                 counted_names("materials", bright)),
                     where);
  if (!blackened.empty())
    problems.warning(
        fmt::format("{}: map_Kd is multiplied by Kd, which is 0, and shows black; set 'diffuse' in a "
                    "scene file where the texture alone is meant",
                    counted_names("materials", blackened)),
        where);
  if (!emitting.empty())
    problems.note(fmt::format("{} emit light (Ke)", counted_names("materials", emitting)), where);
}

}  // namespace

void check_scene(const Scene& scene, const std::filesystem::path& file, ProblemList& problems) {
  const std::string where = file.string();
  if (triangle_count(scene) == 0) {
    if (!problems.has_errors()) problems.error("the scene is empty: it has no triangles", where);
    return;
  }
  check_places(scene, where, problems);
  const Bounds bounds = swept_bounds(scene);
  if (!std::isfinite(bounds.diagonal()) || bounds.diagonal() > 1e18f)
    problems.error("the scene is too large for 32-bit floats", where);
  const bool lit = std::any_of(scene.materials.begin(), scene.materials.end(), emits);
  const bool background = scene.background.lights && scene.background.color != glm::vec3(0);
  if (scene.lights.empty())
    problems.warning(lit || background ? "the scene has no lights; only emission and the background light it"
                                       : "the scene has no lights: all of it is black",
                     where);
  check_reach(scene, bounds, where, problems);
  check_lights_in_surfaces(scene, bounds, where, problems);
  check_light_points(scene, where, problems);
  check_materials(scene, where, problems);
}

}  // namespace lightbench
