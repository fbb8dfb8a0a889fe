#include "scene/box_mesh.h"

namespace lightbench {

Mesh box_mesh(const std::string& name, const Bounds& box, int material) {
  Mesh mesh;
  mesh.name = name;
  for (int axis = 0; axis < 3; ++axis)
    for (const bool high : {false, true}) {
      const int u = (axis + 1) % 3;
      const int v = (axis + 2) % 3;
      glm::vec3 normal(0);
      normal[axis] = high ? 1.0f : -1.0f;
      const auto first = unsigned(mesh.positions.size());
      for (unsigned corner = 0; corner < 4; ++corner) {
        glm::vec3 p;
        p[axis] = high ? box.max[axis] : box.min[axis];
        p[u] = corner == 1 || corner == 2 ? box.max[u] : box.min[u];
        p[v] = corner >= 2 ? box.max[v] : box.min[v];
        mesh.positions.push_back(p);
        mesh.normals.push_back(normal);
      }
      // u, v and the axis are right-handed, so the corners turn to the left seen from the high side.
      const unsigned b = high ? 1 : 3;
      const unsigned d = high ? 3 : 1;
      mesh.triangles.emplace_back(first, first + b, first + 2);
      mesh.triangles.emplace_back(first, first + 2, first + d);
    }
  mesh.parts.push_back({material, 0, 12});
  return mesh;
}

}  // namespace lightbench
