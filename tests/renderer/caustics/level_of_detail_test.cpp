#include <gtest/gtest.h>

#include "tests/renderer/caustics/water_scenes.h"

/// Parameter `level_of_detail` of technique `caustics`.
namespace lightbench {
namespace {

using namespace test;

constexpr int kWidth = 160, kHeight = 120;

Scene ball_alone() {
  Scene scene = ball_in_waves();
  std::erase_if(scene.entities, [](const Entity& entity) { return entity.name == "floor"; });
  return scene;
}

/// From the front, so that the near side of the ball's box, of edge 1, is `pixels` high.
View from_front(double pixels) {
  constexpr double kDistance = 20, kNearSide = kDistance - 0.5;
  View view;
  view.name = "front";
  view.camera.position = {0, 0.5, kDistance};
  view.camera.look_at = {0, 0.5, 0};
  view.camera.fov = float(2 * std::atan(kHeight / pixels / 2 / kNearSide));
  return view;
}

using Params = std::map<std::string, ParamValue>;

Image drawn(const Scene& scene, const View& view, Params params) {
  params.try_emplace("surface", false);
  params.emplace("map_size", 128LL);
  return render(scene, view, {.technique = "caustics", .params = params, .width = kWidth, .height = kHeight})
      .image;
}

class GlLevelOfDetail : public testing::TestWithParam<const char*> {
 protected:
  /// The ball by this method.
  static Image ball(const View& view, long long slices, bool level_of_detail) {
    return drawn(
        ball_alone(), view,
        {{"method", std::string(GetParam())}, {"slices", slices}, {"level_of_detail", level_of_detail}});
  }
};

TEST_P(GlLevelOfDetail, AReceiverHasNoMoreSlicesThanItIsPixelsLarge) {
  const View view = from_front(7.5);
  const Image image = ball(view, 100, true);
  EXPECT_EQ(image, ball(view, 8, false));
  EXPECT_NE(image, ball(view, 100, false));
}

TEST_P(GlLevelOfDetail, AReceiverThatIsLargerThanItsSlicesKeepsThem) {
  const View view = from_front(60);
  EXPECT_EQ(ball(view, 30, true), ball(view, 30, false));
}

TEST_P(GlLevelOfDetail, AReceiverOfWhichThePictureShowsACornerKeepsItsSlices) {
  View view = from_front(60);
  // The lower right corner of the picture shows 24 x 24 of the 60 x 60 pixels of the ball's box.
  const glm::vec3 aside(-0.5f + (24 - kWidth / 2.0f) / 60.0f, 0.5f - (24 - kHeight / 2.0f) / 60.0f, 0);
  view.camera.position += aside;
  view.camera.look_at += aside;
  EXPECT_EQ(ball(view, 30, true), ball(view, 30, false));
}

INSTANTIATE_TEST_SUITE_P(Methods, GlLevelOfDetail, testing::Values("level_map", "hit", "volumetric"));

// A flat view over the water: the ball shows where its refracted picture is, and straight on it would be
// below the frame.
TEST(GlLevelOfDetailBelowWater, AReceiverThatShowsOnlyByRefractionKeepsItsSlices) {
  View view;
  view.camera.look_at = {0, 1.6f, 1.19f};
  view.camera.position = view.camera.look_at + 5.0f * glm::vec3(0, std::sin(0.21f), std::cos(0.21f));
  view.camera.fov = 0.05f;
  const auto through = [&](long long slices, bool level_of_detail) {
    return drawn(ball_alone(), view,
                 {{"surface", true}, {"slices", slices}, {"level_of_detail", level_of_detail}});
  };
  const Image image = through(100, true);
  EXPECT_EQ(image, through(100, false));
  EXPECT_NE(image, through(1, false)) << "the ball is seen";
}

}  // namespace
}  // namespace lightbench
