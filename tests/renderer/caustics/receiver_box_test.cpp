#include "renderer/caustics/receiver_box.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/renderer/caustics/water_scenes.h"

namespace lightbench {
namespace {

using namespace test;

TEST(ReceiverBox, HoldsEachVertexOfWhatIsMoved) {
  Scene scene;
  add_box(scene, "box", {{-1, 0, -2}, {1, 3, 2}});
  scene.entities[0].transform = glm::mat4({0, 2, 0, 0}, {-1, 0, 0, 0}, {0, 0, 1, 0}, {5, 6, 7, 1});
  const ReceiverBox box = receiver_box(scene, 0, glm::normalize(glm::dvec3(0.3, -1, 0.2)));
  glm::dvec3 low(1), high(0);
  for (const glm::vec3& p : scene.meshes[0].positions) {
    const glm::dvec3 place = box.to_map(glm::dvec3(glm::vec3(scene.entities[0].transform * glm::vec4(p, 1))));
    low = glm::min(low, place);
    high = glm::max(high, place);
  }
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_GT(low[axis], 0);
    EXPECT_LT(low[axis], 1e-3);
    EXPECT_LT(high[axis], 1);
    EXPECT_GT(high[axis], 1 - 1e-3);
  }
}

RC_GTEST_PROP(ReceiverBox, GoesThereAndBack, ()) {
  const auto number = [] { return *rc::gen::inRange(-1000, 1000) / 500.0 + 1e-4; };
  Scene scene;
  add_box(scene, "box", {{-1, 0, -2}, {1, 3, 2}});
  const glm::dvec3 axis = glm::normalize(glm::dvec3(number(), number(), number()));
  const ReceiverBox box = receiver_box(scene, 0, axis);
  const glm::dvec3 point(number(), number(), number()), step(number(), number(), number());
  RC_ASSERT(glm::length(box.from_map(box.to_map(point)) - point) < 1e-12);
  RC_ASSERT(glm::length(box.to_map(point + step) - box.to_map(point) - box.direction_to_map(step)) < 1e-12);
  RC_ASSERT(glm::length(glm::cross(box.v, box.w) - box.u) < 1e-12);
  // Deeper is on along the light.
  RC_ASSERT(box.direction_to_map(axis).z > 0);
}

}  // namespace
}  // namespace lightbench
