#include "renderer/gpu_scene.h"

#include <algorithm>
#include <numeric>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/renderer/render_scene.h"

namespace lightbench {
namespace {

Mesh random_mesh(int triangles) {
  Mesh mesh;
  for (int i = 0; i < triangles; ++i) {
    const auto coordinate = [] { return float(*rc::gen::inRange(-50, 50)); };
    const glm::vec3 corner(coordinate(), coordinate(), coordinate());
    const unsigned first = unsigned(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(),
                          {corner, corner + glm::vec3(1, 0, 0), corner + glm::vec3(0, 1, 0)});
    mesh.triangles.emplace_back(first, first + 1, first + 2);
  }
  return mesh;
}

RC_GTEST_PROP(ClusterTriangles, EveryTriangleIsInOneClusterThatBoundsIt, ()) {
  const int count = *rc::gen::inRange(1, 60);
  const std::uint32_t largest = *rc::gen::inRange<std::uint32_t>(1, 10);
  const Mesh mesh = random_mesh(count);
  std::vector<std::uint32_t> order{99, 98};  // of earlier parts
  const auto clusters = cluster_triangles(mesh, {0, 0, std::uint32_t(count)}, largest, order);
  std::vector<std::uint32_t> sorted(order.begin() + 2, order.end());
  std::sort(sorted.begin(), sorted.end());
  std::vector<std::uint32_t> all(static_cast<std::size_t>(count));
  std::iota(all.begin(), all.end(), 0u);
  RC_ASSERT(sorted == all);
  std::uint32_t next = 2 * 3;
  for (const TriangleCluster& cluster : clusters) {
    RC_ASSERT(cluster.first_index == next);
    RC_ASSERT(cluster.index_count > 0u && cluster.index_count <= 3 * largest);
    next += cluster.index_count;
    for (std::uint32_t i = cluster.first_index; i < next; i += 3) {
      const glm::vec3 p = mesh.positions[mesh.triangles[order[i / 3]].x];
      RC_ASSERT(glm::all(glm::lessThanEqual(cluster.box.min, p)) &&
                glm::all(glm::lessThanEqual(p, cluster.box.max)));
    }
  }
  RC_ASSERT(next == std::uint32_t(order.size() * 3));
}

TEST(GpuSceneKey, FollowsWhatIsOnTheGpuOnly) {
  const Scene scene = test::floor_scene();
  const std::string key = gpu_scene_key(scene);
  Scene lit = scene;
  lit.lights.push_back(test::point_light({0, 1, 0}));
  EXPECT_EQ(gpu_scene_key(lit), key);
  Scene moved = scene;
  moved.entities[0].transform[3].x = 1;
  EXPECT_EQ(gpu_scene_key(moved), key) << "entities are placed anew, not uploaded";
  Scene painted = scene;
  painted.materials[0].diffuse.r = 0.4f;
  EXPECT_NE(gpu_scene_key(painted), key);
  Scene bent = scene;
  bent.meshes[0].positions[0].y = 0.25f;
  EXPECT_NE(gpu_scene_key(bent), key);
}

}  // namespace
}  // namespace lightbench
