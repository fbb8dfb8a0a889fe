#include "renderer/paths/emitters.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "renderer/embree_scene.h"
#include "scene/nearest_surface.h"

namespace lightbench {
namespace {

float largest_component(const glm::vec3& v) {
  return std::max({v.x, v.y, v.z});
}

}  // namespace

Emitters::Emitters(const Scene& scene) : scene_(scene) {
  for (const Entity& entity : scene.entities) {
    const Mesh& mesh = scene.meshes[std::size_t(entity.mesh)];
    for (const MeshPart& part : mesh.parts) {
      const Material& material = scene.materials[std::size_t(part.material)];
      if (largest_component(material.emission) > 0) add(entity, mesh, part, material);
    }
  }
  if (!empty()) per_emission_ = float(1 / cumulative_.back());
}

void Emitters::add(const Entity& entity, const Mesh& mesh, const MeshPart& part, const Material& material) {
  const glm::mat3 normal_matrix(glm::transpose(glm::inverse(glm::dmat3(glm::mat3(entity.transform)))));
  for (std::uint32_t i = 0; i < part.triangle_count; ++i) {
    const glm::uvec3& t = mesh.triangles[part.first_triangle + i];
    const glm::vec3 corner = transform_point(entity.transform, mesh.positions[t.x]);
    const glm::vec3 edge_u = transform_point(entity.transform, mesh.positions[t.y]) - corner;
    const glm::vec3 edge_v = transform_point(entity.transform, mesh.positions[t.z]) - corner;
    const glm::vec3 across = glm::cross(edge_u, edge_v);
    const double area = 0.5 * double(glm::length(across));
    if (!(area > 0) || !std::isfinite(area)) continue;
    const glm::mat3 normals =
        normal_matrix * glm::mat3(mesh.normals[t.x], mesh.normals[t.y], mesh.normals[t.z]);
    triangles_.push_back({corner, edge_u, edge_v, glm::normalize(across), normals, &mesh, t, &material});
    const double before = cumulative_.empty() ? 0 : cumulative_.back();
    cumulative_.push_back(before + area * double(largest_component(material.emission)));
  }
}

EmitterPoint Emitters::sample(float pick, float u, float v) const {
  const auto found = std::upper_bound(cumulative_.begin(), cumulative_.end(), pick * cumulative_.back());
  const auto index = std::min<std::ptrdiff_t>(found - cumulative_.begin(), std::ssize(triangles_) - 1);
  const Triangle& t = triangles_[std::size_t(index)];
  // Uniform over the triangle, keeping the strata of the square (Shirley, Wang, Zimmerman 1996).
  const float root = std::sqrt(u);
  const float a = root * (1 - v), b = root * v;
  EmitterPoint point{t.corner + a * t.edge_u + b * t.edge_v, t.normal,
                     t.modelled_normals * glm::vec3(1 - a - b, a, b), t.material->emission};
  if (t.material->cutout_texture != kNoTexture && !t.mesh->uvs.empty()) {
    const auto& uvs = t.mesh->uvs;
    const glm::vec2 uv = (1 - a - b) * uvs[t.vertices.x] + a * uvs[t.vertices.y] + b * uvs[t.vertices.z];
    if (is_cut_out(scene_.textures[std::size_t(t.material->cutout_texture)], uv))
      point.emission = glm::vec3(0);
  }
  return point;
}

}  // namespace lightbench
