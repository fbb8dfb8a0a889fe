#include "scene/light_points.h"

#include <glm/geometric.hpp>
#include <gmock/gmock.h>

namespace lightbench {
namespace {

using testing::SizeIs;

Light area_light(AreaShape shape, const glm::ivec2& points) {
  Light light;
  light.kind = LightKind::area;
  light.shape = shape;
  light.position = {1, 2, 3};
  light.edge_u = {4, 0, 0};
  light.edge_v = {0, 0, 2};
  light.power = 6;
  light.points = points;
  return light;
}

glm::vec3 mean_position(const std::vector<Light>& lights) {
  glm::vec3 sum(0);
  for (const Light& light : lights) sum += light.position;
  return sum / float(lights.size());
}

TEST(LightPoints, OfAQuadAreTheMiddlesOfItsCells) {
  const std::vector<Light> points = light_points(area_light(AreaShape::quad, {2, 3}));
  ASSERT_THAT(points, SizeIs(6));
  EXPECT_EQ(points.front().kind, LightKind::point);
  EXPECT_FLOAT_EQ(points.front().power, 1);
  EXPECT_LT(glm::length(points[0].position - glm::vec3(0, 2, 3 - 2.0f / 3)), 1e-6f);
  EXPECT_LT(glm::length(points[5].position - glm::vec3(2, 2, 3 + 2.0f / 3)), 1e-6f);
  EXPECT_LT(glm::length(mean_position(points) - glm::vec3(1, 2, 3)), 1e-6f);
}

TEST(LightPoints, OfATriangleHaveItsCentroid) {
  for (const int n : {1, 2, 5}) {
    const std::vector<Light> points = light_points(area_light(AreaShape::triangle, {n, 1}));
    ASSERT_THAT(points, SizeIs(n * n));
    const glm::vec3 centroid = glm::vec3(1, 2, 3) + glm::vec3(4, 0, 2) / 3.0f;
    EXPECT_LT(glm::length(mean_position(points) - centroid), 1e-5f) << n;
  }
}

TEST(LightPoints, KeepOtherLightsAsTheyAre) {
  Scene scene;
  scene.lights.resize(2);
  scene.lights[0].kind = LightKind::spot;
  scene.lights[1] = area_light(AreaShape::quad, {1, 1});
  const std::vector<Light> points = light_points(scene);
  ASSERT_THAT(points, SizeIs(2));
  EXPECT_EQ(points[0].kind, LightKind::spot);
  EXPECT_EQ(points[1].position, glm::vec3(1, 2, 3));
}

TEST(LightPoints, AreCountedWithoutMakingThem) {
  Scene scene;
  scene.lights = {Light(), area_light(AreaShape::quad, {2, 3}), area_light(AreaShape::triangle, {5, 5})};
  for (const Light& light : scene.lights) EXPECT_EQ(light_point_count(light), light_points(light).size());
  EXPECT_EQ(light_point_count(scene), 1u + 6 + 25);
}

}  // namespace
}  // namespace lightbench
