#include "povexport/pov_lights.h"

#include <cmath>

#include <glm/trigonometric.hpp>
#include <gmock/gmock.h>

#include "base/color.h"
#include "pov_test_scenes.h"
#include "scene/light_points.h"
#include "tests/radius_attenuation.h"

namespace lightbench {
namespace {

constexpr int kSize = 33;  // odd: one pixel looks straight at the origin

/// The value of a white wall at z = 0 under one light; pixel (x, y) sees the point `wall_point(x, y)`.
Image lit_wall(const Light& light) {
  Scene scene = scene_of(facing_square());
  scene.lights = {light};
  return render(scene, facing_camera(), direct_options(), kSize, kSize);
}

glm::vec3 wall_point(int x, int y) {
  return {2 * (float(x) + 0.5f) / kSize - 1, 1 - 2 * (float(y) + 0.5f) / kSize, 0};
}

Light point_light(const Attenuation& attenuation) {
  Light light;
  light.position = {0.3f, -0.2f, 0.8f};
  light.color = {1, 0.5f, 0.25f};
  light.power = 1.5f;
  light.attenuation = attenuation;
  return light;
}

float lambert(const Light& light, const glm::vec3& point) {
  return std::max(glm::normalize(light.position - point).z, 0.0f);
}

class PovrayAttenuation : public testing::TestWithParam<Attenuation> {};

TEST_P(PovrayAttenuation, IsThatOfTheLightingModel) {
  const Light light = point_light(GetParam());
  const Image image = lit_wall(light);
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < kSize; ++x) {
      const glm::vec3 p = wall_point(x, y);
      const float wanted =
          1.5f * lambert(light, p) * attenuation_factor(GetParam(), glm::length(light.position - p));
      ASSERT_NEAR(image.pixel(x, y)[0], wanted, kHalfError * std::max(wanted, 1.0f)) << x << " " << y;
      ASSERT_NEAR(image.pixel(x, y)[1], wanted / 2, kHalfError * std::max(wanted, 1.0f)) << x << " " << y;
    }
}

INSTANTIATE_TEST_SUITE_P(PovrayKinds, PovrayAttenuation,
                         testing::Values(Attenuation{}, Attenuation{Attenuation::Kind::fade, 1.2f, 2, 1},
                                         Attenuation{Attenuation::Kind::fade, 0.7f, 3.5f, 1},
                                         Attenuation{Attenuation::Kind::inverse_square, 1, 2, 1}));

float smoothstep(float low, float high, float x) {
  const float t = std::clamp((x - low) / (high - low), 0.0f, 1.0f);
  return t * t * (3 - 2 * t);
}

TEST(PovrayLights, SpotsEndInASmoothstepOfTheCosine) {
  Light light = point_light({});
  light.kind = LightKind::spot;
  light.direction = glm::normalize(glm::vec3(-0.2f, 0.1f, -1));
  light.inner_angle = glm::radians(15.0f);
  light.outer_angle = glm::radians(35.0f);
  const Image image = lit_wall(light);
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < kSize; ++x) {
      const glm::vec3 p = wall_point(x, y);
      const float cosine = glm::dot(glm::normalize(p - light.position), light.direction);
      const float cone = smoothstep(std::cos(light.outer_angle), std::cos(light.inner_angle), cosine);
      ASSERT_NEAR(image.pixel(x, y)[0], 1.5f * cone * lambert(light, p), 2 * kHalfError) << x << " " << y;
    }
}

TEST(PovrayLights, SpotsMayEndAtOnce) {
  Light light = point_light({});
  light.kind = LightKind::spot;
  light.position = {0, 0, 1};
  light.direction = {0, 0, -1};
  light.inner_angle = light.outer_angle = glm::radians(30.0f);
  const Image image = lit_wall(light);
  EXPECT_NEAR(image.pixel(16, 16)[0], 1.5f, 2 * kHalfError);
  EXPECT_GT(image.pixel(24, 16)[0], 1.1f);  // 0.515 from the axis, inside of tan 30 = 0.577
  EXPECT_EQ(image.pixel(26, 16)[0], 0);     // 0.636
}

TEST(PovrayLights, DirectionalLightsIgnoreDistance) {
  Light light = frontal_light();
  light.direction = glm::normalize(glm::vec3(1, -2, -3));
  light.attenuation = {Attenuation::Kind::inverse_square, 1, 2, 1};
  const Image image = lit_wall(light);
  for (const int x : {0, 16, 32}) EXPECT_NEAR(image.pixel(x, 5)[0], 3 / std::sqrt(14.0f), kHalfError);
}

Light panel(AreaShape shape) {
  Light light = point_light({Attenuation::Kind::fade, 1.2f, 2, 1});
  light.kind = LightKind::area;
  light.shape = shape;
  light.edge_u = {0.8f, 0.1f, 0};
  light.edge_v = {0, 0.5f, 0.4f};
  light.points = {3, 2};
  return light;
}

class PovrayAreaLights : public testing::TestWithParam<AreaShape> {};

TEST_P(PovrayAreaLights, AreTheMeanOfTheirPoints) {
  const Light light = panel(GetParam());
  const Image image = lit_wall(light);
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < kSize; ++x) {
      const glm::vec3 p = wall_point(x, y);
      float wanted = 0;
      for (const Light& point : light_points(light))
        wanted += point.power * lambert(point, p) *
                  attenuation_factor(light.attenuation, glm::length(point.position - p));
      ASSERT_NEAR(image.pixel(x, y)[0], wanted, kHalfError * std::max(wanted, 1.0f)) << x << " " << y;
    }
}

INSTANTIATE_TEST_SUITE_P(PovrayShapes, PovrayAreaLights,
                         testing::Values(AreaShape::quad, AreaShape::triangle));

TEST(PovAreaLights, AreWrittenAsTheirPoints) {
  const PovSpace space{{glm::vec3(-1), glm::vec3(1)}, 256};
  const Light light = panel(AreaShape::triangle);
  std::string points;
  for (const Light& point : light_points(light)) points += pov_light(point, space).text();
  EXPECT_EQ(pov_light(light, space).text(), points);
}

TEST(PovrayPenumbra, OfAnAreaLightHasEvenSteps) {
  Scene scene = scene_of(facing_square());
  scene.meshes.push_back(quad_mesh({{0, -3, 1}, {3, -3, 1}, {3, 3, 1}, {0, 3, 1}}));
  scene.entities.push_back({"screen", 1, glm::mat4(1)});
  Light light = panel(AreaShape::quad);
  light.attenuation = {};
  light.position = {0, 0, 2};
  light.edge_u = {1, 0, 0};
  light.edge_v = {0, 0.001f, 0};
  light.points = {4, 1};
  scene.lights = {light};
  // Points at x = -3/8, -1/8, 1/8, 3/8 and an edge half way to the wall: the shadow of each begins at -x.
  Camera camera = facing_camera();
  camera.position.z = 0.9f;  // before the screen
  camera.fov = 2 * std::atan(1 / 0.9f);
  const Image image = render(scene, camera, direct_options(), kSize, kSize);
  for (int x = 0; x < kSize; ++x) {
    const glm::vec3 p = wall_point(x, kSize / 2);
    float wanted = 0;
    for (const Light& point : light_points(light))
      if (p.x < -point.position.x) wanted += point.power * lambert(point, p);
    EXPECT_NEAR(image.pixel(x, kSize / 2)[0], wanted, 2 * kHalfError) << p.x;
  }
}

TEST(PovrayLights, InverseSquareHoldsInSmallScenes) {
  const float scale = 1e-4f;
  Light light = point_light({Attenuation::Kind::inverse_square, 1, 2, 1});
  const float wanted = 1.5f * lambert(light, {}) / glm::dot(light.position, light.position);
  light.position *= scale;
  light.power *= scale * scale;
  Scene scene = scene_of(facing_square());
  for (glm::vec3& position : scene.meshes[0].positions) position *= scale;
  scene.lights = {light};
  Camera camera = facing_camera();
  camera.position *= scale;
  EXPECT_NEAR(render(scene, camera, direct_options(), kSize, kSize).pixel(16, 16)[0], wanted,
              kHalfError * wanted);
}

TEST(PovrayLights, WithoutShadowsNothingIsInTheWay) {
  Scene scene = scene_of(facing_square());
  scene.entities.push_back({"screen", 0, glm::mat4(1)});
  scene.entities[1].transform[3][2] = 6;  // behind the camera, before the light
  scene.lights = {frontal_light()};
  EXPECT_EQ(render(scene, facing_camera()).pixel(16, 16)[0], 0);
  PovOptions options = direct_options();
  options.shadowless = true;
  EXPECT_NEAR(render(scene, facing_camera(), options).pixel(16, 16)[0], 1, kHalfError);
}

TEST(PovLights, TheSumOfFadesIsTheRadiusAttenuationAtKnownDistances) {
  for (const auto& [part, factor] : test::kRadiusFactors)
    EXPECT_NEAR(radius_attenuation_by_fades(part), double(factor), radius_attenuation_error()) << part;
}

// In 8-bit sRGB, where darkness shows more of an error than in linear light. From near the light to where
// nothing of it may be left.
TEST(PovLights, TheSumOfFadesIsWithinHalfALevelOfTheRadiusAttenuation) {
  for (int i = -40000; i <= 40000; ++i) {
    const float d = std::pow(10.0f, 0.0001f * float(i));
    const auto fades = float(radius_attenuation_by_fades(double(d)));
    ASSERT_NEAR(255 * srgb_encode(fades), 255 * srgb_encode(std::max(1 - d * d, 0.0f)), 0.5f) << d;
  }
}

TEST(PovLights, TheErrorOfTheSumOfFadesIsTheLargestAnywhere) {
  const double error = radius_attenuation_error();
  EXPECT_LT(error, 0.01);
  double largest = 0;
  for (int i = -100000; i <= 100000; ++i) {
    const double d = std::pow(10.0, 0.00004 * double(i));
    largest = std::max(largest, std::abs(radius_attenuation_by_fades(d) - std::max(1 - d * d, 0.0)));
  }
  EXPECT_NEAR(error, largest, 1e-5);
}

TEST(PovrayLights, AttenuationByRadiusAtKnownDistances) {
  const glm::vec3 place = wall_point(16, 16);
  for (const auto& [part, factor] : test::kRadiusFactors) {
    Light light = point_light({Attenuation::Kind::radius, 1, 2, test::radius_for(0.8f, part)});
    light.position = place + glm::vec3(0, 0, 0.8f);
    light.power = 1;
    EXPECT_NEAR(lit_wall(light).pixel(16, 16)[0], factor, float(radius_attenuation_error()) + kHalfError)
        << part;
  }
}

TEST(PovrayLights, AttenuationByRadiusEnds) {
  const Light light = point_light({Attenuation::Kind::radius, 1, 2, 1.5f});
  const Image image = lit_wall(light);
  for (const int x : {0, 8, 16, 24, 32}) {
    const glm::vec3 p = wall_point(x, 10);
    const float factor = attenuation_factor(light.attenuation, glm::length(light.position - p));
    EXPECT_NEAR(image.pixel(x, 10)[0], light.power * lambert(light, p) * factor,
                light.power * float(radius_attenuation_error()) + kHalfError)
        << x;
  }
}

}  // namespace
}  // namespace lightbench
