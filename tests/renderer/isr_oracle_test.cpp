#include "renderer/techniques/isr_oracle.h"

#include <numbers>

#include <gmock/gmock.h>

#include "renderer/path_tracer.h"
#include "renderer/paths/sight.h"
#include "renderer/shader_source.h"
#include "tests/renderer/isr_scenes.h"
#include "tests/renderer/room_scenes.h"

namespace lightbench {
namespace {

using test::add_quad;
using test::box_scene;
using test::floor_scene;
using test::glowing;
using test::inside_view;
using test::matte;
using test::room;
using test::top_view;
using test::view_from;
using testing::HasSubstr;

using Given = std::map<std::string, ParamValue>;

constexpr int kWidth = 16;
constexpr int kHeight = 12;

FrameResult gathered(const Scene& scene, const View& view, Given params) {
  params.try_emplace("samples", 64LL);
  return test::render(scene, view,
                      {.technique = "isr_oracle",
                       .params = std::move(params),
                       .width = kWidth,
                       .height = kHeight,
                       .buffers = {"indirect", "unknown"}});
}

Image traced(const Scene& scene, const View& view, int bounces) {
  PathTracerOptions options;
  options.bounces = bounces;
  options.samples = 64;
  options.seed = default_seed(PathTracedUse::variant);
  return trace_paths(scene, view, kWidth, kHeight, 1, options).image;
}

double mean_of(const Image& image, int channel = 0) {
  double sum = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) sum += double(image.pixel(x, y)[std::size_t(channel)]);
  return sum / double(image.pixel_count());
}

const Given kEverything{
    {"cameras", std::string("cube")}, {"layers", 8LL}, {"layer_faces", std::string("all")}};

Given with(Given params, const Given& more) {
  for (const auto& [name, value] : more) params[name] = value;
  return params;
}

TEST(IsrOracle, WithEverythingInItsPicturesItIsThePathTracer) {
  for (const long long bounces : {1, 2, 4}) {
    const FrameResult result = gathered(room(), inside_view(), with(kEverything, {{"bounces", bounces}}));
    EXPECT_EQ(result.image.data, traced(room(), inside_view(), int(bounces)).data) << "the same paths";
    EXPECT_EQ(mean_of(result.buffers.at("unknown")), 0);
  }
}

/// The share of the light of a white sky above a wall of the box that would come through what the frame
/// shows, by a midpoint rule over the points of the unit disc that directions project to.
double share_in_frame(const View& view, const glm::vec3& point, const glm::vec3& normal) {
  const CameraFrame frame = camera_frame(view.camera);
  const float half_y = std::tan(view.camera.fov / 2);
  const float half_x = half_y * float(kWidth) / float(kHeight);
  const glm::vec3 tangent = glm::abs(normal.x) > 0.5f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
  const glm::vec3 other = glm::cross(normal, tangent);
  constexpr int kSteps = 200;
  int inside = 0;
  int all = 0;
  for (int i = 0; i < kSteps; ++i)
    for (int j = 0; j < kSteps; ++j) {
      const float u = (2 * (float(i) + 0.5f)) / kSteps - 1;
      const float v = (2 * (float(j) + 0.5f)) / kSteps - 1;
      if (u * u + v * v >= 1) continue;
      ++all;
      const glm::vec3 direction = u * tangent + v * other + std::sqrt(1 - u * u - v * v) * normal;
      float t = 1e9f;  // to the box's walls at -2 and 2
      for (int axis = 0; axis < 3; ++axis) {
        const float to_wall = ((direction[axis] > 0 ? 2.0f : -2.0f) - point[axis]) / direction[axis];
        if (std::abs(direction[axis]) > 1e-6f && to_wall > 1e-4f) t = std::min(t, to_wall);
      }
      const glm::vec3 way = point + t * direction - view.camera.position;
      const float forward = glm::dot(way, frame.forward);
      if (forward > 0 && std::abs(glm::dot(way, frame.right)) < half_x * forward &&
          std::abs(glm::dot(way, frame.up)) < half_y * forward)
        ++inside;
    }
  return double(inside) / all;
}

TEST(IsrOracle, WhatLiesOutsideTheFrameIsUnknown) {
  View view = view_from({0, 0, 1.5f}, {0, 0, -1}, 1.6f);
  const FrameResult result =
      gathered(box_scene(matte(glm::vec3(0.5f))), view, {{"samples", 4096LL}, {"guard", 1.0}});
  // The pixel beside the middle of the back wall, and one on the floor.
  const float pixel = 2 * std::tan(0.8f) / kHeight;
  const glm::vec3 on_wall{0.5f * pixel * 3.5f, -0.5f * pixel * 3.5f, -2};
  const double wall = 1 - share_in_frame(view, on_wall, {0, 0, 1});
  EXPECT_NEAR(result.buffers.at("unknown").pixel(kWidth / 2, kHeight / 2)[0], wall, 0.01)
      << "4096 well spread rays";
  const float down = 5.5f * pixel;
  const glm::vec3 on_floor{0.5f * pixel * 2 / down, -2, 1.5f - 2 / down};
  ASSERT_GT(on_floor.z, -2);
  const double floor = 1 - share_in_frame(view, on_floor, {0, 1, 0});
  EXPECT_NEAR(result.buffers.at("unknown").pixel(kWidth / 2, kHeight - 1)[0], floor, 0.01);
  EXPECT_GT(std::abs(wall - floor), 0.05) << "they can be told apart";
}

TEST(IsrOracle, AWiderPictureLeavesLessUnknown) {
  double before = 1;
  for (const double guard : {1.0, 2.0, 4.0}) {
    const FrameResult result = gathered(room(), inside_view(), {{"guard", guard}});
    const double unknown = mean_of(result.buffers.at("unknown"));
    EXPECT_LT(unknown, before - 0.02);
    before = unknown;
  }
}

/// A black plate in front of the camera, behind it a glowing one that it hides, and a wall behind both that
/// the glowing one lights: `turned` turns its normal away from the camera.
Scene hidden_lamp(bool turned) {
  Scene scene;
  scene.name = "hidden lamp";
  scene.materials = {matte(glm::vec3(0)), glowing(1), matte(glm::vec3(1))};
  add_quad(scene, {-1, -1, -2}, {2, 0, 0}, {0, 2, 0}, 0);
  if (turned)
    add_quad(scene, {-1, -1, -3}, {0, 2, 0}, {2, 0, 0}, 1);
  else
    add_quad(scene, {-1, -1, -3}, {2, 0, 0}, {0, 2, 0}, 1);
  add_quad(scene, {-20, -20, -6}, {40, 0, 0}, {0, 40, 0}, 2);
  return scene;
}

/// The light that the wall shows, as a share of what it gets.
double light_of_lamp(const Scene& scene, long long layers, const char* faces) {
  const View view = view_from({0, 0, 0}, {0, 0, -1}, 1.6f);
  const Given params{{"layers", layers}, {"layer_faces", std::string(faces)}};
  return mean_of(gathered(scene, view, params).buffers.at("indirect")) / mean_of(traced(scene, view, 1));
}

TEST(IsrOracle, ASecondLayerShowsWhatStandsBehindTheFirst) {
  EXPECT_EQ(light_of_lamp(hidden_lamp(false), 1, "front"), 0);
  EXPECT_FLOAT_EQ(float(light_of_lamp(hidden_lamp(false), 2, "front")), 1) << "the same rays";
}

TEST(IsrOracle, LayersOfFrontFacesLeaveOutWhatIsTurnedAway) {
  EXPECT_EQ(light_of_lamp(hidden_lamp(true), 8, "front"), 0);
  EXPECT_FLOAT_EQ(float(light_of_lamp(hidden_lamp(true), 2, "all")), 1);
}

TEST(IsrOracle, WhatIsLeftOutTakesNoLayer) {
  Scene scene = hidden_lamp(false);
  add_quad(scene, {-1, -1, -2.5f}, {0, 2, 0}, {2, 0, 0}, 0);  // turned away, between the two
  EXPECT_FLOAT_EQ(float(light_of_lamp(scene, 2, "front")), 1);
  EXPECT_EQ(light_of_lamp(scene, 2, "all"), 0);
  EXPECT_FLOAT_EQ(float(light_of_lamp(scene, 3, "all")), 1);
}

/// In a room that glows evenly the mean of what is known is what the rest brings.
TEST(IsrOracle, UnknownLightTakesTheMeanOfTheKnown) {
  Material material = matte(glm::vec3(0.5f));
  material.emission = glm::vec3(0.25f);
  const Scene scene = box_scene(material);
  double expected = 0.25;
  for (long long bounces = 1; bounces <= 3; ++bounces) {
    expected += 0.25 * std::pow(0.5, bounces);
    const Given params{{"guard", 2.0}, {"bounces", bounces}, {"samples", 512LL}};
    const auto image_with = [&](const char* unknown) {
      return gathered(scene, inside_view(), with(params, {{"unknown", std::string(unknown)}})).image;
    };
    EXPECT_NEAR(mean_of(image_with("ambient")), expected, 0.01 * expected)
        << "bounces " << bounces << "; 98304 paths, and what 16 tries did not find";
    EXPECT_LT(mean_of(image_with("black")), 0.95 * expected) << "much is unknown";
  }
}

TEST(IsrOracle, TheBackgroundIsKnownWhereThePicturesReach) {
  Scene scene = floor_scene();
  scene.background.color = {0.2f, 0.4f, 1.0f};
  const FrameResult below = gathered(scene, top_view(3), {{"guard", 4.0}});
  EXPECT_EQ(mean_of(below.buffers.at("unknown")), 1) << "the camera looks down";
  EXPECT_EQ(mean_of(below.buffers.at("indirect"), 2), 0);
  const FrameResult around = gathered(scene, top_view(3), {{"cameras", std::string("cube")}});
  EXPECT_EQ(mean_of(around.buffers.at("unknown")), 0);
  EXPECT_NEAR(mean_of(around.buffers.at("indirect"), 2), 0.5, 1e-5) << "albedo; no noise";
  const FrameResult without =
      gathered(scene, top_view(3), {{"cameras", std::string("cube")}, {"background", false}});
  EXPECT_EQ(mean_of(without.buffers.at("unknown")), 0);
  EXPECT_EQ(mean_of(without.buffers.at("indirect"), 2), 0);
}

TEST(IsrOracle, IsTheSameEachTime) {
  const Given params{{"unknown", std::string("ambient")}, {"bounces", 2LL}};
  EXPECT_EQ(gathered(room(), inside_view(), params).image.data,
            gathered(room(), inside_view(), params).image.data);
}

TEST(Sight, TellsLayersApartAsTheShaderDoes) {
  EXPECT_EQ(kBehindShare, 1e-3f);
  EXPECT_THAT(shader_source("shaders/surface.frag.glsl"), HasSubstr("const float kBehind = 1e-3;"));
}

}  // namespace
}  // namespace lightbench
