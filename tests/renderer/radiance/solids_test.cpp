#include "renderer/radiance/solids.h"

#include <gtest/gtest.h>

#include "scene/box_mesh.h"

namespace lightbench {
namespace {

constexpr glm::vec3 kMiddle(0.3f, 0.4f, 0.55f), kUp(0, 1, 0);

Light point_light(const glm::vec3& position) {
  Light light;
  light.position = position;
  return light;
}

/// A box of edge 1 at the origin, and a lamp well above it.
Scene box_scene() {
  Scene scene;
  scene.materials.emplace_back();
  scene.meshes.push_back(box_mesh("box", {{0, 0, 0}, {1, 1, 1}}, 0));
  scene.entities.push_back({"box"});
  scene.lights = {point_light({0.5f, 4, 0.5f})};
  return scene;
}

TEST(Solids, AClosedBoxIsOne) {
  const Scene scene = box_scene();
  const Solids solids(scene);
  EXPECT_TRUE(solids.contain(kMiddle, kUp));
  EXPECT_TRUE(solids.contain({0.5f, 0.001f, 0.5f}, kUp));
  EXPECT_TRUE(solids.contain({0.5f, 0.999f, 0.5f}, -kUp));
  EXPECT_FALSE(solids.contain({0.5f, 1.001f, 0.5f}, kUp));
  EXPECT_FALSE(solids.contain({-0.01f, 0.001f, 0.5f}, kUp));
}

TEST(Solids, WhicheverWayItIsWound) {
  Scene scene = box_scene();
  for (glm::uvec3& t : scene.meshes[0].triangles) std::swap(t.x, t.y);
  EXPECT_TRUE(Solids(scene).contain(kMiddle, kUp));
}

TEST(Solids, MirroredAndMovedByItsEntity) {
  Scene scene = box_scene();
  scene.entities[0].transform = glm::mat4({-1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {-2, 0, 0, 1});
  const Solids solids(scene);
  EXPECT_TRUE(solids.contain(glm::vec3(-2 - kMiddle.x, kMiddle.y, kMiddle.z), kUp));
  EXPECT_FALSE(solids.contain(kMiddle, kUp));
}

TEST(Solids, AnOpenBoxIsNone) {
  Scene scene = box_scene();
  scene.meshes[0].triangles.pop_back();
  scene.meshes[0].parts[0].triangle_count -= 1;
  EXPECT_TRUE(Solids(scene).empty());
}

/// That box without its bottom, over a floor that is as far below.
Scene bottomless_scene(float gap) {
  Scene scene = box_scene();
  Mesh& box = scene.meshes[0];
  std::erase_if(box.triangles, [&](const glm::uvec3& t) {
    return box.positions[t.x].y + box.positions[t.y].y + box.positions[t.z].y == 0;
  });
  box.parts[0].triangle_count = std::uint32_t(box.triangles.size());
  EXPECT_EQ(box.triangles.size(), 10u);
  scene.meshes.push_back(box_mesh("floor", {{-5, -gap - 1, -5}, {5, -gap, 5}}, 0));
  scene.entities.push_back({"floor", 1});
  return scene;
}

TEST(Solids, ABoxWithoutABottomIsOneWhereItStandsOnSomething) {
  const Scene standing = bottomless_scene(0), nearly = bottomless_scene(0.002f),
              aloft = bottomless_scene(0.1f);
  EXPECT_TRUE(Solids(standing).contain({0.5f, 0.001f, 0.5f}, kUp));
  EXPECT_FALSE(Solids(standing).contain({1.1f, 0.001f, 0.5f}, kUp));
  EXPECT_TRUE(Solids(nearly).contain(kMiddle, kUp));
  EXPECT_FALSE(Solids(aloft).contain(kMiddle, kUp));
}

TEST(Solids, ABoxThatReachesBeyondWhatItStandsOnIsNone) {
  Scene scene = bottomless_scene(0);
  for (glm::vec3& p : scene.meshes[1].positions) p.x = std::min(p.x, 0.8f);
  EXPECT_FALSE(Solids(scene).contain(kMiddle, kUp));
}

TEST(Solids, ARoomWithAFloorOfItsOwnIsNone) {
  Scene scene = bottomless_scene(0);
  scene.lights = {point_light({0.2f, 0.9f, 0.2f})};
  EXPECT_FALSE(Solids(scene).contain(kMiddle, kUp));
}

TEST(Solids, ASheetOnAFloorIsNone) {
  Scene scene = bottomless_scene(0);
  Mesh& box = scene.meshes[0];
  std::erase_if(box.triangles, [&](const glm::uvec3& t) {
    return box.positions[t.x].y + box.positions[t.y].y + box.positions[t.z].y != 3;
  });
  box.parts[0].triangle_count = std::uint32_t(box.triangles.size());
  EXPECT_EQ(box.triangles.size(), 2u);
  for (glm::vec3& p : box.positions) p.y *= 0.001f;
  EXPECT_FALSE(Solids(scene).contain({0.5f, 0.0005f, 0.4f}, kUp));
}

TEST(Solids, ACrackIsNoOpening) {
  // A vertex in the middle of an edge that only the triangles on one side of it know.
  Scene scene = box_scene();
  Mesh& box = scene.meshes[0];
  const glm::uvec3 t = box.triangles[0];
  const auto middle = std::uint32_t(box.positions.size());
  box.positions.push_back(0.5f * (box.positions[t.x] + box.positions[t.y]));
  box.normals.push_back(box.normals[t.x]);
  box.triangles[0] = {t.x, middle, t.z};
  box.triangles.push_back({middle, t.y, t.z});
  box.parts[0].triangle_count += 1;
  EXPECT_TRUE(Solids(scene).contain(kMiddle, kUp));
}

TEST(Solids, AMeshWithThreeTrianglesAtAnEdgeIsNone) {
  Scene scene = box_scene();
  Mesh& box = scene.meshes[0];
  const glm::uvec3 t = box.triangles[0];
  box.positions.emplace_back(0.5f, 0.5f, 0.5f);
  box.normals.emplace_back(0, 1, 0);
  box.triangles.push_back({t.x, t.y, std::uint32_t(box.positions.size() - 1)});
  box.parts[0].triangle_count += 1;
  EXPECT_TRUE(Solids(scene).empty());
}

TEST(Solids, ABoxWithHolesIsNone) {
  Scene scene = box_scene();
  scene.materials[0].cutout_texture = 0;
  EXPECT_TRUE(Solids(scene).empty());
}

TEST(Solids, ARoomIsNone) {
  Scene lamp = box_scene();
  lamp.lights = {point_light(kMiddle)};
  EXPECT_TRUE(Solids(lamp).empty());
  Scene emitter = box_scene();
  emitter.materials.push_back(emitter.materials[0]);
  emitter.materials[1].emission = glm::vec3(1);
  emitter.meshes.push_back(box_mesh("bulb", {{0.4f, 0.8f, 0.4f}, {0.5f, 0.9f, 0.5f}}, 1));
  emitter.entities.push_back({"bulb", 1});
  EXPECT_TRUE(Solids(emitter).empty());
}

TEST(Solids, OfAMeshEachConnectedPartCounts) {
  Scene scene = box_scene();
  Mesh& mesh = scene.meshes[0];
  const Mesh open = box_mesh("open", {{3, 0, 0}, {4, 1, 1}}, 0),
             far = box_mesh("far", {{6, 0, 0}, {7, 1, 1}}, 0);
  for (const Mesh* other : {&open, &far}) {
    const auto first = std::uint32_t(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), other->positions.begin(), other->positions.end());
    mesh.normals.insert(mesh.normals.end(), other->normals.begin(), other->normals.end());
    for (const glm::uvec3& t : other->triangles) mesh.triangles.push_back(t + first);
    if (other == &open) mesh.triangles.pop_back();
  }
  mesh.parts[0].triangle_count = std::uint32_t(mesh.triangles.size());
  const Solids solids(scene);
  EXPECT_TRUE(solids.contain(kMiddle, kUp));
  EXPECT_FALSE(solids.contain(kMiddle + glm::vec3(3, 0, 0), kUp));
  EXPECT_TRUE(solids.contain(kMiddle + glm::vec3(6, 0, 0), kUp));
}

}  // namespace
}  // namespace lightbench
