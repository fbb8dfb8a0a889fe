#include "scene/scene_check.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "scene/light_points.h"
#include "scene/nearest_surface.h"

namespace lightbench {
namespace {

// Nearer to a surface than this share of the scene, a light is hidden by it or not as rounding has it.
constexpr float kInSurface = 1e-6f;

bool emits(const Material& m) {
  return m.emission != glm::vec3(0);
}

bool reaches(const Light& light, const Bounds& bounds) {
  const glm::vec3 nearest = glm::clamp(light.position, bounds.min, bounds.max);
  return light.attenuation.kind != Attenuation::Kind::radius ||
         glm::length(light.position - nearest) < light.attenuation.radius;
}

void check_lights(const Scene& scene, const Bounds& bounds, const std::string& where, ProblemList& problems) {
  for (const Light& light : scene.lights) {
    if (light.kind == LightKind::directional) continue;
    const std::vector<Light> points = light_points(light);
    if (std::none_of(points.begin(), points.end(),
                     [&](const Light& point) { return reaches(point, bounds); }))
      problems.warning(fmt::format("the light '{}' reaches nothing within its radius", light.name), where);
    if (light.kind != LightKind::area &&
        distance_to_nearest_surface(scene, light.position) <= kInSurface * bounds.diagonal())
      problems.warning(fmt::format("the light '{}' lies in a surface", light.name), where);
  }
}

void check_materials(const Scene& scene, const std::string& where, ProblemList& problems) {
  std::vector<std::string> bright;
  std::vector<std::string> emitting;
  for (const Material& m : scene.materials) {
    if (std::max({m.diffuse.x, m.diffuse.y, m.diffuse.z}) > 1) bright.push_back(m.name);
    if (emits(m)) emitting.push_back(m.name);
  }
  if (!bright.empty())
    problems.warning(fmt::format("{}: a diffuse colour above 1 gives back more light than it gets",
                                 counted_names("materials", bright)),
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
  const Bounds bounds = world_bounds(scene);
  if (!std::isfinite(bounds.diagonal()) || bounds.diagonal() > 1e18f)
    problems.error("the scene is too large for 32-bit floats", where);
  const bool lit = std::any_of(scene.materials.begin(), scene.materials.end(), emits);
  const bool background = scene.background.lights && scene.background.color != glm::vec3(0);
  if (scene.lights.empty())
    problems.warning(lit || background ? "the scene has no lights; only emission and the background light it"
                                       : "the scene has no lights: all of it is black",
                     where);
  check_lights(scene, bounds, where, problems);
  check_materials(scene, where, problems);
}

}  // namespace lightbench
