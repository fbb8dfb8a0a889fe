#include "renderer/radiance/solids.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "renderer/radiance/direction_grid.h"
#include "renderer/radiance/lids.h"
#include "renderer/radiance/union_find.h"
#include "renderer/radiance/weld.h"
#include "scene/light_points.h"

namespace lightbench {
namespace {

/// The mesh's triangles between welded vertices, part by part that is connected; triangles between fewer than
/// three of them are left out.
std::vector<Triangles> connected_parts(const Mesh& mesh) {
  const std::vector<std::uint32_t> welded = weld_positions(mesh.positions);
  UnionFind groups(mesh.positions.size());
  Triangles triangles;
  for (const glm::uvec3& t : mesh.triangles) {
    const glm::uvec3 w(welded[t.x], welded[t.y], welded[t.z]);
    if (w.x == w.y || w.y == w.z || w.z == w.x) continue;
    triangles.push_back(w);
    groups.join(w.x, w.y), groups.join(w.y, w.z);
  }
  std::ranges::stable_sort(triangles, {}, [&](const glm::uvec3& t) { return groups.find(t.x); });
  std::vector<Triangles> parts;
  for (const glm::uvec3& t : triangles) {
    if (parts.empty() || groups.find(parts.back().front().x) != groups.find(t.x)) parts.emplace_back();
    parts.back().push_back(t);
  }
  return parts;
}

bool has_cut_outs(const Scene& scene, const Mesh& mesh) {
  return std::ranges::any_of(mesh.parts, [&](const MeshPart& part) {
    return scene.materials[std::size_t(part.material)].cutout_texture != kNoTexture;
  });
}

using Corners = std::vector<glm::vec3>;  // three for each triangle

Bounds bounds_of(const Corners& corners) {
  Bounds bounds;
  for (const glm::vec3& corner : corners) bounds.add(corner);
  return bounds;
}

/// Six times the volume; negative where triangles are wound the wrong way.
double signed_volume(const Corners& corners) {
  const glm::dvec3 origin(corners.front());
  double volume = 0;
  for (std::size_t i = 0; i < corners.size(); i += 3)
    volume += glm::dot(glm::dvec3(corners[i]) - origin,
                       glm::cross(glm::dvec3(corners[i + 1]) - origin, glm::dvec3(corners[i + 2]) - origin));
  return volume;
}

/// Of its size's cube: the volume up to which a mesh with its lids is no more than a sheet. Floats of a sheet
/// make less than a millionth.
constexpr double kSheet = 1e-5;

/// A part of a mesh in the world, wound outwards, with lids where it stands on something; none where it is
/// open, or but a sheet.
std::optional<Corners> solid_of(const Mesh& mesh, const Triangles& part, const glm::mat4& transform,
                                const SceneRays& scene) {
  const auto in_the_world = [&](std::uint32_t vertex) {
    return glm::vec3(transform * glm::vec4(mesh.positions[vertex], 1));
  };
  const auto rims = open_rims(part);
  if (!rims) return std::nullopt;
  Corners corners;
  for (const std::vector<std::uint32_t>& rim : *rims) {
    std::vector<glm::vec3> places;
    for (const std::uint32_t vertex : rim) places.push_back(in_the_world(vertex));
    const auto lid = lid_of(places, scene);
    if (!lid) return std::nullopt;
    corners.insert(corners.end(), lid->begin(), lid->end());
  }
  for (const glm::uvec3& t : part)
    for (const std::uint32_t vertex : {t.x, t.y, t.z}) corners.push_back(in_the_world(vertex));
  const double volume = signed_volume(corners);
  if (std::abs(volume) <= kSheet * std::pow(double(bounds_of(corners).diagonal()), 3)) return std::nullopt;
  if (volume < 0)
    for (std::size_t i = 0; i < corners.size(); i += 3) std::swap(corners[i + 1], corners[i + 2]);
  return corners;
}

/// Points that send light, those of emitters among them.
std::vector<glm::vec3> light_places(const Scene& scene) {
  std::vector<glm::vec3> places;
  for (const Light& light : light_points(scene))
    if (light.kind != LightKind::directional) places.push_back(light.position);
  for (const Entity& entity : scene.entities) {
    const Mesh& mesh = scene.meshes[std::size_t(entity.mesh)];
    for (const MeshPart& part : mesh.parts) {
      if (scene.materials[std::size_t(part.material)].emission == glm::vec3(0)) continue;
      for (std::uint32_t t = part.first_triangle; t < part.first_triangle + part.triangle_count; ++t)
        places.emplace_back(entity.transform * glm::vec4(mesh.positions[mesh.triangles[t].x], 1));
    }
  }
  return places;
}

bool holds_any(const Corners& solid, const std::vector<glm::vec3>& places) {
  const Bounds bounds = bounds_of(solid);
  return std::ranges::any_of(places, [&](const glm::vec3& place) {
    return glm::all(glm::lessThanEqual(bounds.min, place)) && glm::all(glm::lessThanEqual(place, bounds.max));
  });
}

/// With these triangles and nothing else.
Scene scene_of(Corners corners) {
  Mesh mesh;
  for (std::uint32_t i = 0; i < corners.size(); i += 3) mesh.triangles.emplace_back(i, i + 1, i + 2);
  mesh.positions = std::move(corners);
  mesh.normals.resize(mesh.positions.size(), glm::vec3(0, 1, 0));  // which nobody looks at
  mesh.parts = {{0, 0, std::uint32_t(mesh.triangles.size())}};
  Scene scene;
  scene.materials.emplace_back();
  scene.meshes.push_back(std::move(mesh));
  scene.entities.push_back({"solids"});
  return scene;
}

}  // namespace

Solids::Solids(const Scene& scene) {
  const std::vector<glm::vec3> lights = light_places(scene);
  const SceneRays surfaces(scene);
  Corners corners;
  for (const Entity& entity : scene.entities) {
    const Mesh& mesh = scene.meshes[std::size_t(entity.mesh)];
    if (has_cut_outs(scene, mesh)) continue;
    for (const Triangles& part : connected_parts(mesh)) {
      const auto solid = solid_of(mesh, part, entity.transform, surfaces);
      if (solid && !holds_any(*solid, lights)) corners.insert(corners.end(), solid->begin(), solid->end());
    }
  }
  if (corners.empty()) return;
  scene_ = scene_of(std::move(corners));
  rays_.emplace(scene_);
}

bool Solids::contain(const glm::vec3& point, const glm::vec3& normal) const {
  if (!rays_) return false;
  // Off the axes, along which models have their edges. From within, all meet an inner side, unless another
  // solid stands there too; so most decide.
  constexpr std::array<glm::vec3, 5> kLocal{glm::vec3(0.05f, 0.998f, 0.03f), glm::vec3(0.55f, 0.77f, 0.32f),
                                            glm::vec3(-0.47f, 0.79f, 0.39f), glm::vec3(0.29f, 0.76f, -0.58f),
                                            glm::vec3(-0.38f, 0.73f, -0.57f)};
  const glm::mat3 frame = frame_of_normal(normal);
  std::size_t within = 0;
  for (const glm::vec3& local : kLocal) {
    const glm::vec3 direction = glm::normalize(frame * local);
    const auto hit = rays_->closest_hit(point, direction);
    if (hit && glm::dot(hit->normal, direction) > 0) ++within;
  }
  return 2 * within > kLocal.size();
}

}  // namespace lightbench
