#include "scene/camera_script.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "base/error.h"
#include "scene/motion.h"
#include "scene_test_files.h"

namespace lightbench {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

std::string error_of_script(const std::string& views) {
  const SceneTestFiles files;
  try {
    read_camera_script(files.write("c.json", "{\"views\": [" + views + "]}"));
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

std::string view_with(const std::string& keys) {
  return R"({"name": "a", "position": [0, 1, 2], "look_at": [0, 0, 0])" + keys + "}";
}

TEST(CameraScript, ReadsAView) {
  const SceneTestFiles files;
  const auto views = read_camera_script(files.write("c.json", R"({"views": [
      {"name": "a", "position": [1, 2, 3], "look_at": [4, 5, 6], "up": [0, 0, 1], "fov": 90}]})"));
  ASSERT_EQ(views.size(), 1u);
  EXPECT_EQ(views[0].name, "a");
  EXPECT_EQ(views[0].camera.position, glm::vec3(1, 2, 3));
  EXPECT_EQ(views[0].camera.look_at, glm::vec3(4, 5, 6));
  EXPECT_EQ(views[0].camera.up, glm::vec3(0, 0, 1));
  EXPECT_FLOAT_EQ(views[0].camera.fov, glm::radians(90.0f));
}

TEST(CameraScript, RejectsAnUnknownKeyWithTheNearestOne) {
  EXPECT_THAT(error_of_script(view_with(R"(, "fow": 60)")),
              AllOf(HasSubstr("c.json: $.views[0]"), HasSubstr("did you mean 'fov'")));
}

TEST(CameraScript, SaysHowItsViewsWereDrawn) {
  const SceneTestFiles files;
  const std::vector<View> views{{"a", {{1, 2, 3}, {4, 5, 6}}}};
  const std::string text = camera_script_text(views, DrawnBy{18446744073709551615u, 2});
  EXPECT_THAT(text, HasSubstr(R"("drawn": {"seed": 18446744073709551615, "version": 2})"));
  EXPECT_EQ(read_camera_script(files.write("c.json", text))[0].camera.position, glm::vec3(1, 2, 3));
}

TEST(CameraScript, RejectsWrongWordsOnHowItWasDrawn) {
  const SceneTestFiles files;
  const auto file =
      files.write("c.json", R"({"drawn": {"seed": 1, "version": 0}, "views": [)" + view_with("") + "]}");
  try {
    read_camera_script(file);
    FAIL() << "there is no version 0";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("c.json: $.drawn.version"));
  }
}

TEST(CameraScript, RejectsTwoViewsOfOneName) {
  EXPECT_THAT(error_of_script(view_with("") + "," + view_with("")),
              AllOf(HasSubstr("$.views[1]"), HasSubstr("second view named 'a'")));
}

TEST(CameraScript, RejectsACameraThatLooksAtItself) {
  EXPECT_THAT(error_of_script(R"({"name": "a", "position": [1, 1, 1], "look_at": [1, 1, 1]})"),
              HasSubstr("position is its look_at"));
}

TEST(CameraScript, RejectsUpAlongTheView) {
  EXPECT_THAT(error_of_script(R"({"name": "a", "position": [0, 5, 0], "look_at": [0, 0, 0]})"),
              HasSubstr("up is along"));
  EXPECT_THAT(error_of_script(view_with(R"(, "up": [0, 0, 0])")), HasSubstr("up is zero"));
}

TEST(CameraScript, RejectsAFieldOfViewThatIsNoAngle) {
  for (const char* fov : {"0", "180", "-5", "1e9", "1e-300", "179.999999999"})
    EXPECT_THAT(error_of_script(view_with(std::string(R"(, "fov": )") + fov)), HasSubstr("$.views[0].fov"))
        << fov;
}

TEST(CameraScript, RejectsCoordinatesThatFloatsCannotHold) {
  EXPECT_THAT(error_of_script(R"({"name": "a", "position": [1e300, 0, 0], "look_at": [0, 0, 0]})"),
              HasSubstr("too large"));
}

TEST(CameraScript, RejectsAScriptWithoutViews) {
  EXPECT_THAT(error_of_script(""), HasSubstr("has no views"));
}

TEST(CameraScript, NamesAreOnlyText) {
  const SceneTestFiles files;
  const std::string name = "a \"b\" \\ <c> \xC3\xA4";
  const auto text = camera_script_text({{name, Camera{}}});
  EXPECT_EQ(read_camera_script(files.write("c.json", text))[0].name, name);
}

RC_GTEST_PROP(CameraScript, TextReadsBackToTheSameFloats, (int seed)) {
  const SceneTestFiles files;
  const auto number = [&] {
    seed = int(unsigned(seed) * 1664525u + 1013904223u);
    return float(seed) / 3e5f;
  };
  View view{"v", {}};
  view.camera.position = {number(), number(), number()};
  view.camera.look_at = {number(), number(), number()};
  view.camera.up = {number(), number(), number()};
  view.camera.fov = glm::radians(1.0f + std::abs(number()) / 41.0f);
  RC_PRE(glm::length(glm::cross(glm::normalize(view.camera.look_at - view.camera.position),
                                glm::normalize(view.camera.up))) > 1e-3f);
  const View read = read_camera_script(files.write("c.json", camera_script_text({view})))[0];
  RC_ASSERT(read.camera.position == view.camera.position);
  RC_ASSERT(read.camera.look_at == view.camera.look_at);
  RC_ASSERT(read.camera.up == view.camera.up);
  RC_ASSERT(read.camera.fov == view.camera.fov);
}

std::string view_with_keyframes(const std::string& first, const std::string& second) {
  return R"({"name": "a", "look_at": [0, 0, 0], "keyframes": [)" + first + ", " + second + "]}";
}

TEST(CameraScript, KeyframesTakeWhatTheyLackFromTheView) {
  const SceneTestFiles files;
  const auto views = read_camera_script(files.write("c.json", R"({"views": [
      {"name": "a", "look_at": [0, 1, 0], "fov": 40, "keyframes": [
          {"time": -1, "position": [0, 0, 4]}, {"time": 1, "position": [2, 0, 4], "fov": 60}]}]})"));
  ASSERT_EQ(views[0].keyframes.size(), 2u);
  EXPECT_EQ(views[0].keyframes[1].camera.look_at, glm::vec3(0, 1, 0));
  EXPECT_FLOAT_EQ(views[0].keyframes[0].camera.fov, glm::radians(40.0f));
  EXPECT_EQ(views[0].camera.position, glm::vec3(1, 0, 4)) << "the camera at time 0";
}

TEST(CameraScript, AViewIsAtItsTime) {
  const SceneTestFiles files;
  const auto views = read_camera_script(files.write("c.json", R"({"views": [
      {"name": "a", "look_at": [0, 0, 0], "time": 3, "keyframes": [
          {"time": 2, "position": [0, 0, 4]}, {"time": 4, "position": [2, 0, 4]}]}]})"));
  EXPECT_EQ(views[0].time, 3);
  EXPECT_EQ(views[0].camera.position, glm::vec3(1, 0, 4));
}

TEST(CameraScript, RejectsKeyframesThatDoNotRise) {
  EXPECT_THAT(error_of_script(view_with_keyframes(R"({"time": 1, "position": [0, 0, 1]})",
                                                  R"({"time": 1, "position": [0, 0, 2]})")),
              AllOf(HasSubstr("$.views[0].keyframes[1].time"), HasSubstr("1 is not after 1")));
}

TEST(CameraScript, RejectsASingleKeyframe) {
  EXPECT_THAT(error_of_script(view_with(R"(, "keyframes": [{"time": 0}])")),
              AllOf(HasSubstr("$.views[0].keyframes"), HasSubstr("at least two")));
}

TEST(CameraScript, RejectsAKeyframeWithoutAPosition) {
  EXPECT_THAT(error_of_script(view_with_keyframes(R"({"time": 1, "position": [0, 0, 1]})", R"({"time": 2})")),
              AllOf(HasSubstr("$.views[0].keyframes[1]"), HasSubstr("'position' is missing")));
}

TEST(CameraScript, TheWidestAndTheNarrowestViewReadBackAtEachTime) {
  const SceneTestFiles files;
  for (const char* fov : {"0.001", "179.9"}) {
    const std::string keys =
        std::string(R"(, "fov": )") + fov + R"(, "keyframes": [{"time": 0}, {"time": 1}])";
    const View moving =
        read_camera_script(files.write("c.json", "{\"views\": [" + view_with(keys) + "]}"))[0];
    for (int i = 0; i <= 100; ++i) {
      View still = view_at(moving, i / 100.0);
      still.keyframes.clear();
      const auto text = camera_script_text({still});
      EXPECT_NO_THROW(read_camera_script(files.write("still.json", text))) << text;
    }
  }
}

TEST(CameraScript, MovingViewsAndFramesReadBackAsTheyWere) {
  const SceneTestFiles files;
  View moving{"moving", {{1, 2, 3}}};
  moving.keyframes = {{-0.1, {{1, 2, 3}}}, {0.7, {{0.1f, 0.2f, 0.3f}, {4, 5, 6}, {0, 0, 1}, 0.9f}}};
  View frame{"frame", {{3, 2, 1}}, 1.0 / 3, SequenceFrame{"wa\"lk", 4}};
  const auto views = read_camera_script(files.write("c.json", camera_script_text({moving, frame})));
  ASSERT_EQ(views[0].keyframes.size(), 2u);
  EXPECT_EQ(views[0].keyframes[0].time, -0.1);
  EXPECT_EQ(views[0].keyframes[1].camera.position, glm::vec3(0.1f, 0.2f, 0.3f));
  EXPECT_EQ(views[0].keyframes[1].camera.fov, 0.9f);
  EXPECT_EQ(views[1].time, 1.0 / 3);
  EXPECT_EQ(views[1].frame->sequence, "wa\"lk");
  EXPECT_EQ(views[1].frame->number, 4);
}

}  // namespace
}  // namespace lightbench
