#include "scene/emitting_surface.h"

#include <glm/geometric.hpp>

namespace lightbench {
namespace {

Mesh surface_mesh(const Light& light, int material) {
  const glm::vec3 u = light.edge_u, v = light.edge_v;
  Mesh mesh;
  mesh.name = light.name;
  if (light.shape == AreaShape::quad) {
    const glm::vec3 corner = light.position - 0.5f * (u + v);
    mesh.positions = {corner, corner + u, corner + u + v, corner + v};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  } else {
    mesh.positions = {light.position, light.position + u, light.position + v};
    mesh.triangles = {{0, 1, 2}};
  }
  mesh.normals.assign(mesh.positions.size(), glm::normalize(glm::cross(u, v)));
  mesh.parts = {{material, 0, std::uint32_t(mesh.triangles.size())}};
  return mesh;
}

}  // namespace

void add_emitting_surface(Scene& scene, const Light& light) {
  Material material;
  material.name = light.name;
  material.diffuse = glm::vec3(0);
  material.emission = light.color * light.power;
  scene.materials.push_back(material);
  scene.meshes.push_back(surface_mesh(light, int(scene.materials.size()) - 1));
  scene.entities.push_back({light.name, int(scene.meshes.size()) - 1, glm::mat4(1)});
}

}  // namespace lightbench
