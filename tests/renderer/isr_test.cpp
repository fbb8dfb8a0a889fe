#include "renderer/techniques/isr.h"

#include <cmath>
#include <numbers>

#include <glm/gtc/matrix_transform.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/color.h"
#include "base/error.h"
#include "renderer/frame_camera.h"
#include "renderer/techniques/isr_params.h"
#include "tests/renderer/isr_scenes.h"

namespace lightbench {
namespace {

using namespace test;

constexpr double kPi = std::numbers::pi;

/// A lit corner of three walls with a box-like step, background all round: all stages have work.
Scene corner_scene() {
  Scene scene;
  scene.name = "corner";
  scene.materials = {matte({0.7f, 0.6f, 0.5f}), matte({0.6f, 0.1f, 0.1f}), glowing(2)};
  add_quad(scene, {-1, 0, 1}, {2, 0, 0}, {0, 0, -2}, 0);
  add_quad(scene, {-1, 0, -1}, {2, 0, 0}, {0, 1.5f, 0}, 0);
  add_quad(scene, {-1, 0, 1}, {0, 0, -2}, {0, 1.5f, 0}, 1);
  add_quad(scene, {0.2f, 0.4f, 0.5f}, {0.5f, 0, 0}, {0, 0, -0.5f}, 1);
  add_quad(scene, {0.2f, 0, 0.5f}, {0.5f, 0, 0}, {0, 0.4f, 0}, 0);
  add_quad(scene, {-0.5f, 0.9f, -0.99f}, {0.2f, 0, 0}, {0, 0.2f, 0}, 2);
  scene.lights = {point_light({0.3f, 1.2f, 0.4f})};
  scene.background.color = {0.1f, 0.2f, 0.3f};
  return scene;
}
View corner_view() {
  return view_from({1.6f, 1.2f, 2.4f}, {-0.2f, 0.4f, 0}, 0.8f);
}

/// Mean over the pixels that `use` accepts (by indirect value and index) of a component.
template <typename Use>
double mean_where(const Image& image, Use use) {
  double sum = 0;
  int count = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      if (use(x, y)) sum += image.pixel(x, y)[0], ++count;
  EXPECT_GT(count, 0);
  return sum / count;
}

TEST(GlIsr, FacingPlatesSeeEachOtherByTheirFormFactor) {
  // 2 %: pixels that the plates' rims cut, and the rounding of areas to coarse pixels.
  EXPECT_NEAR(plates_ratio({{"samples", 800LL}}), 1, 0.02);
}

TEST(GlIsr, FewSamplesHaveNoBias) {
  // A hit of one of 24 samples counts twice what is expected of all, so that the mean over 2400 coarse pixels
  // is within 3 % of it: 10 % are more than three standard deviations.
  const std::map<std::string, ParamValue> independent{{"rotation", "random"}, {"far_block", 1LL}};
  for (const long long samples : {24, 48}) {
    std::map<std::string, ParamValue> params = independent;
    params["samples"] = samples;
    EXPECT_NEAR(plates_ratio(params, 384), 1, 0.1) << samples;
  }
}

TEST(GlIsr, LargerBlocksFarOffKeepTheEnergy) {
  // 3 %: larger blocks know their position to half a block.
  const double fine = plates_ratio({{"samples", 200LL}, {"far_block", 1LL}});
  EXPECT_NEAR(plates_ratio({{"samples", 200LL}, {"far_block", 4LL}}) / fine, 1, 0.03);
}

TEST(GlIsr, EnergyDoesNotDependOnTheResolution) {
  // 4 %: at a quarter of the size the plate is 25 coarse pixels wide and its rim is a larger share.
  const double fine = plates_ratio({{"resolution", 1LL}});
  EXPECT_NEAR(plates_ratio({{"resolution", 4LL}}) / fine, 1, 0.04);
}

TEST(GlIsr, DiscWeightsLoseLight) {
  EXPECT_LT(plates_ratio({{"form_factor", "disc"}, {"samples", 24LL}, {"far_block", 1LL}}), 0.97);
}

TEST(GlIsr, AWallLightsTheFloorBesideIt) {
  Scene scene;
  scene.name = "step";
  scene.materials = {matte(glm::vec3(1)), glowing(1)};
  add_quad(scene, {-2, 0, 1}, {4, 0, 0}, {0, 0, -1}, 0);
  add_quad(scene, {-2, 0, 0}, {4, 0, 0}, {0, 1, 0}, 1);
  const View view = view_from({0, 1.2f, 3.5f}, {0, 0.4f, 0}, 0.8f);
  const FrameResult result = render_isr(scene, view, {{"samples", 400LL}, {"blur", "none"}}, 256, 192);
  // On the middle of the floor: half the view factor of two perpendicular strips of width 4 seen from their
  // plane of symmetry, (1/pi) (atan(x/z) - z/sqrt(z^2+1) atan(x/sqrt(z^2+1))) with x = 2.
  const auto form_factor = [](double z) {
    const double w = std::sqrt(z * z + 1);
    return (std::atan(2 / z) - z / w * std::atan(2 / w)) / kPi;
  };
  const FrameCamera camera = frame_camera(view.camera, 256.0f / 192, {0.1f, 10});
  for (const double z : {0.2, 0.4, 0.7}) {
    const glm::dvec4 clip = camera.clip_from_world * glm::dvec4(0, 0, z, 1);
    const int x = int((clip.x / clip.w * 0.5 + 0.5) * 256);
    const int y = int((0.5 - clip.y / clip.w * 0.5) * 192);
    // 4 %: a pixel is 0.03 deep there; what is left is the noise of a single coarse pixel.
    EXPECT_NEAR(result.buffers.at("indirect").pixel(x, y)[0] / form_factor(z), 1, 0.04) << z;
  }
}

TEST(GlIsr, GathersNoMoreThanAFullHemisphere) {
  Scene scene;  // a closed white box that glows: every point sees radiance 1 everywhere
  scene.name = "furnace";
  Material wall = matte(glm::vec3(1));
  wall.emission = glm::vec3(1);
  scene.materials = {wall};
  add_quad(scene, {-1, -1, 1}, {2, 0, 0}, {0, 0, -2});
  add_quad(scene, {-1, 1, -1}, {2, 0, 0}, {0, 0, 2});
  add_quad(scene, {-1, -1, -1}, {2, 0, 0}, {0, 2, 0});
  add_quad(scene, {-1, -1, 1}, {0, 0, -2}, {0, 2, 0});
  add_quad(scene, {1, -1, -1}, {0, 0, 2}, {0, 2, 0});
  const View view = view_from({0, 0, 0.9f}, {0, 0, 0}, 1.8f);
  const Image indirect = render_isr(scene, view, {{"samples", 16LL}}).buffers.at("indirect");
  for (const float value : indirect.data) EXPECT_LE(value, 1.001f) << "half floats";
  EXPECT_GT(mean_where(indirect, [](int, int) { return true; }), 0.6) << "most of the box is in sight";
}

TEST(GlIsr, WithoutItsFactorsItIsDirectLight) {
  const Scene scene = corner_scene();
  const Image direct = render(scene, corner_view(), {.width = 64, .height = 48}).image;
  const Image isr =
      render(scene, corner_view(),
             {.technique = "isr", .params = {{"k_isr", 0.0}, {"k_ssao", 0.0}}, .width = 64, .height = 48})
          .image;
  EXPECT_EQ(isr, direct);
}

TEST(GlIsr, LeavesTheBackgroundAlone) {
  const Scene scene = corner_scene();
  for (const char* weighting : {"area", "paper"}) {
    const Image image = render_isr(scene, corner_view(), {{"weighting", weighting}, {"k_ssao", 0.5}}).image;
    int background = 0;
    for (std::size_t i = 0; i < image.pixel_count(); ++i) {
      if (image.data[4 * i + 3] > 0) continue;
      ++background;
      EXPECT_EQ(image.data[4 * i], 0.1f);
      EXPECT_EQ(image.data[4 * i + 2], 0.3f);
    }
    EXPECT_GT(background, 100);
  }
}

TEST(GlIsr, IsFiniteAndNotNegativeAtAnySize) {
  const Scene scene = corner_scene();
  for (const auto& [width, height] : {std::pair{1, 1}, {2, 1}, {3, 5}, {37, 23}, {64, 63}})
    for (const long long resolution : {1, 2, 3, 8}) {
      const FrameResult result =
          render_isr(scene, corner_view(), {{"resolution", resolution}, {"k_ssao", 1.0}}, width, height);
      const Image& indirect = result.buffers.at("indirect");
      EXPECT_EQ(indirect.width, width);
      for (const Image* image : {&result.image, &indirect, &result.buffers.at("occlusion")}) {
        EXPECT_EQ(first_non_finite(*image), -1) << width << "x" << height << " at " << resolution;
        EXPECT_GE(*std::min_element(image->data.begin(), image->data.end()), 0);
      }
    }
}

TEST(GlIsr, AveragedDepthsAndNormalsAreFiniteAtAnySize) {
  const Scene scene = corner_scene();
  for (const auto& [width, height] : {std::pair{1, 1}, {3, 5}, {37, 23}})
    for (const long long resolution : {1, 2, 8}) {
      const Params params{{"downsampling", "mean"}, {"upsampling", "depth"}, {"resolution", resolution}};
      const Image indirect = render_isr(scene, corner_view(), params, width, height).buffers.at("indirect");
      EXPECT_EQ(first_non_finite(indirect), -1) << width << "x" << height << " at " << resolution;
      EXPECT_GE(*std::min_element(indirect.data.begin(), indirect.data.end()), 0);
    }
}

TEST(GlIsr, EveryPresetRendersALitCorner) {
  const Technique technique = isr_technique();
  Renderer renderer(GlBackend::osmesa);
  const Scene scene = corner_scene();
  const View view = corner_view();
  for (const ParamPreset& preset : technique.presets) {
    const ParamValues params =
        resolve_params(technique.params, technique.presets, preset.name, {{"shadow_size", 256LL}}, "test");
    const Image image = renderer.render(technique, params, {scene, view, 40, 30, 1, {}}).image;
    EXPECT_EQ(first_non_finite(image), -1) << preset.name;
    EXPECT_GT(mean_where(image, [](int, int) { return true; }), 0) << preset.name;
  }
}

TEST(GlIsr, IsTheSameEveryTime) {
  const Scene scene = corner_scene();
  for (const char* rotation : {"none", "random", "tiled"}) {
    const std::map<std::string, ParamValue> params{{"rotation", rotation}};
    EXPECT_EQ(render_isr(scene, corner_view(), params).image, render_isr(scene, corner_view(), params).image);
  }
}

TEST(GlIsr, AskingForBuffersDoesNotChangeTheImage) {
  const Scene scene = corner_scene();
  const RenderSetup plain{.technique = "isr", .params = {}, .width = 128, .height = 96};
  EXPECT_EQ(render(scene, corner_view(), plain).image, render_isr(scene, corner_view()).image);
}

TEST(GlIsr, ImageIsDirectLightAndTheIndirectBuffer) {
  const Scene scene = corner_scene();
  const Image direct = render(scene, corner_view(), {.width = 128, .height = 96}).image;
  const FrameResult isr = render_isr(scene, corner_view());
  for (std::size_t i = 0; i < direct.pixel_count(); ++i)
    for (std::size_t c = 0; c < 3; ++c)
      EXPECT_NEAR(isr.image.data[4 * i + c],
                  direct.data[4 * i + c] + isr.buffers.at("indirect").data[3 * i + c],
                  1e-6f * (1 + direct.data[4 * i + c]));
}

TEST(GlIsr, AloneItShowsTheIndirectBufferOverBlack) {
  const FrameResult result = render_isr(corner_scene(), corner_view(), {{"direct", false}});
  EXPECT_EQ(first_channels(result.image, 3), result.buffers.at("indirect"));
  EXPECT_GT(mean_where(result.image, [](int, int) { return true; }), 0.01);
}

TEST(GlIsr, IndirectLightGrowsWithItsFactor) {
  const Image one = render_isr(corner_scene(), corner_view()).buffers.at("indirect");
  const Image half = render_isr(corner_scene(), corner_view(), {{"k_isr", 0.5}}).buffers.at("indirect");
  for (std::size_t i = 0; i < one.data.size(); ++i) EXPECT_FLOAT_EQ(half.data[i], 0.5f * one.data[i]);
}

TEST(GlIsr, TheMaskScalesWhatASurfaceReceives) {
  Scene scene = corner_scene();
  const Image all = render_isr(scene, corner_view()).buffers.at("indirect");
  for (Material& material : scene.materials) material.reflectance = 0.25f;
  const Image quarter = render_isr(scene, corner_view()).buffers.at("indirect");
  for (std::size_t i = 0; i < all.data.size(); ++i) EXPECT_NEAR(quarter.data[i], 0.25f * all.data[i], 1e-6f);
}

TEST(GlIsr, LightDoesNotLeakOverEdgesInDepth) {
  Scene scene;  // a card before a wall that a glowing side wall lights; the card itself sees none of it
  scene.name = "card";
  scene.materials = {matte(glm::vec3(1)), glowing(5)};
  add_quad(scene, {-0.4f, -0.4f, 1}, {0.8f, 0, 0}, {0, 0.8f, 0}, 0);
  add_quad(scene, {-2, -2, 0}, {4, 0, 0}, {0, 4, 0}, 0);
  add_quad(scene, {-1.2f, -2, 0.9f}, {0, 0, -0.9f}, {0, 4, 0}, 1);
  const View view = view_from({0, 0, 4}, {0, 0, 0}, 0.8f);
  const FrameResult result =
      render(scene, view, {.technique = "isr", .width = 129, .height = 97, .buffers = {"indirect", "depth"}});
  const auto on_card = [&](int x, int y) {
    return std::abs(result.buffers.at("depth").pixel(x, y)[0] - 3) < 0.01f;
  };
  const auto on_wall = [&](int x, int y) {
    return std::abs(result.buffers.at("depth").pixel(x, y)[0] - 4) < 0.01f;
  };
  EXPECT_GT(mean_where(result.buffers.at("indirect"), on_wall), 0.01);
  EXPECT_EQ(mean_where(result.buffers.at("indirect"), on_card), 0);
}

TEST(GlIsr, AFlatFloorNeitherLightsNorOccludesItself) {
  Scene scene = floor_scene();
  scene.lights = {directional_light({0.2f, -1, 0.1f})};
  const FrameResult result = render_isr(scene, top_view(5), {{"k_ssao", 1.0}});
  const auto everywhere = [](int, int) { return true; };
  // Normals and positions are rounded: 1e-3 of full occlusion and of white.
  EXPECT_NEAR(mean_where(result.buffers.at("occlusion"), everywhere), 1, 1e-3);
  EXPECT_NEAR(mean_where(result.buffers.at("indirect"), everywhere), 0, 1e-3);
}

TEST(GlIsr, OcclusionDarkensCornersAndDirectLightOnly) {
  const Scene scene = corner_scene();
  const std::map<std::string, ParamValue> params{{"k_ssao", 1.0}, {"k_isr", 0.0}, {"occluder_radius", 4.0}};
  const Image direct = render(scene, corner_view(), {.width = 128, .height = 96}).image;
  const FrameResult result = render_isr(scene, corner_view(), params);
  const Image& openness = result.buffers.at("occlusion");
  EXPECT_LT(*std::min_element(openness.data.begin(), openness.data.end()), 0.95f);
  EXPECT_LE(*std::max_element(openness.data.begin(), openness.data.end()), 1.0f);
  for (std::size_t i = 0; i < direct.data.size(); ++i)
    EXPECT_LE(result.image.data[i], direct.data[i] + 1e-6f);
}

TEST(GlIsr, OcclusionLeavesEmissionAlone) {
  Scene scene = corner_scene();
  scene.lights.clear();
  const Image direct = render(scene, corner_view(), {.width = 128, .height = 96}).image;
  EXPECT_EQ(render_isr(scene, corner_view(), {{"k_ssao", 1.0}, {"k_isr", 0.0}}).image, direct);
}

TEST(GlIsr, SupersamplingKeepsTheEnergy) {
  RenderSetup setup{.technique = "isr", .params = {}, .width = 128, .height = 96, .samples = 2};
  setup.buffers = {"indirect"};
  const Image twice = render(corner_scene(), corner_view(), setup).buffers.at("indirect");
  const Image once = render_isr(corner_scene(), corner_view()).buffers.at("indirect");
  const auto everywhere = [](int, int) { return true; };
  // 5 %: edges are drawn finer, and the blur reaches half as far.
  EXPECT_NEAR(mean_where(twice, everywhere) / mean_where(once, everywhere), 1, 0.05);
}

TEST(GlIsr, TheUnitOfLengthDoesNotMatter) {
  const Scene metres = corner_scene();
  const Image expected = render_isr(metres, corner_view()).buffers.at("indirect");
  for (const float factor : {1e-3f, 1e4f}) {
    Scene scaled = metres;
    for (Entity& entity : scaled.entities) entity.transform = glm::scale(glm::mat4(1), glm::vec3(factor));
    scaled.lights[0].position *= factor;
    View view = corner_view();
    view.camera.position *= factor;
    view.camera.look_at *= factor;
    const Image indirect = render_isr(scaled, view).buffers.at("indirect");
    double difference = 0;
    for (std::size_t i = 0; i < indirect.data.size(); ++i)
      difference += std::abs(indirect.data[i] - expected.data[i]);
    // Rounding moves single pixels over edges.
    EXPECT_LT(difference / double(indirect.data.size()), 1e-3) << factor;
  }
}

/// What a floor below the horizon receives of a white background that it sees on the screen.
double background_light(Scene scene, std::map<std::string, ParamValue> params = {}) {
  scene.background.color = glm::vec3(1);
  scene.materials[0].diffuse = glm::vec3(1);
  const View view = view_from({0, 0.5f, 5}, {0, 1.5f, 0}, 1.0f);
  const Image indirect = render_isr(scene, view, std::move(params)).buffers.at("indirect");
  return indirect.pixel(indirect.width / 2, indirect.height - 2)[0];
}

TEST(GlIsr, GathersTheBackgroundThatIsSeen) {
  const Scene scene = floor_scene();
  // The cosine-weighted solid angle, over pi, of the rows of the picture above the far rim of the floor.
  double expected = 0;
  const double tan_half = std::tan(0.5);
  const double tilt = std::atan2(1.0, 5.0);
  const double rim = std::atan2(-0.5, 15.0) - tilt;
  const int n = 400;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const double x = tan_half * 4 / 3 * ((i + 0.5) / n * 2 - 1);
      const double y = tan_half * ((j + 0.5) / n * 2 - 1);
      if (y < std::tan(rim)) continue;
      const double length = std::sqrt(1 + x * x + y * y);
      const double up = (std::sin(tilt) + y * std::cos(tilt)) / length;
      const double area = tan_half * tan_half * 16 / 3 / (double(n) * n);
      expected += std::max(up, 0.0) * area / (length * length * length) / kPi;
    }
  // 4 %: the rim falls within a coarse pixel, and the corners of the picture are sparsely sampled.
  EXPECT_NEAR(background_light(scene, {{"samples", 800LL}}) / expected, 1, 0.04);
}

TEST(GlIsr, ABackgroundThatDoesNotLightIsNotGathered) {
  Scene scene = floor_scene();
  EXPECT_EQ(background_light(scene, {{"background", false}}), 0);
  scene.background.lights = false;
  EXPECT_EQ(background_light(scene), 0);
}

TEST(GlIsr, HighlightsAreGatheredOnlyIfAskedFor) {
  Scene scene = corner_scene();
  const Image matte_walls = render_isr(scene, corner_view(), {{"source", "diffuse"}}).buffers.at("indirect");
  for (Material& material : scene.materials) material.specular = 1, material.exponent = 2;
  EXPECT_EQ(render_isr(scene, corner_view(), {{"source", "diffuse"}}).buffers.at("indirect"), matte_walls);
  const Image lit = render_isr(scene, corner_view(), {{"source", "lit"}}).buffers.at("indirect");
  const auto everywhere = [](int, int) { return true; };
  EXPECT_GT(mean_where(lit, everywhere), 1.01 * mean_where(matte_walls, everywhere));
}

TEST(GlIsr, PaperGathersUnlitColour) {
  Scene scene = corner_scene();
  const Image lit =
      render_isr(scene, corner_view(), {{"weighting", "paper"}, {"source", "albedo"}}).buffers.at("indirect");
  scene.lights.clear();
  EXPECT_EQ(
      render_isr(scene, corner_view(), {{"weighting", "paper"}, {"source", "albedo"}}).buffers.at("indirect"),
      lit);
  EXPECT_GT(mean_where(lit, [](int, int) { return true; }), 0);
}

TEST(GlIsr, AGridMustBeFilled) {
  EXPECT_THROW(render_isr(corner_scene(), corner_view(), {{"pattern", "grid"}, {"samples", 47LL}}), Error);
  EXPECT_NO_THROW(render_isr(corner_scene(), corner_view(), {{"pattern", "grid"}, {"samples", 48LL}}));
}

TEST(GlIsr, AJitteredKernelHasNoBias) {
  // 2 %: as for the spiral.
  EXPECT_NEAR(plates_ratio({{"samples", 800LL}, {"pattern", "jittered"}}), 1, 0.02);
}

// 3 %: kernels of other sizes are other samples of the same sum.
TEST(GlIsr, SamplesByDepthKeepTheEnergy) {
  const double alike = plates_ratio({{"samples", 120LL}});
  EXPECT_NEAR(plates_ratio({{"samples", 120LL}, {"samples_by_depth", 1.0}}) / alike, 1, 0.03);
}

TEST(GlIsr, SamplesByDepthHaveTheirLimits) {
  const auto rendering = [](long long samples, const char* pattern) {
    return render_isr(corner_scene(), corner_view(),
                      {{"samples", samples}, {"pattern", pattern}, {"samples_by_depth", 1.0}});
  };
  EXPECT_THROW(rendering(129, "spiral"), Error);
  EXPECT_THROW(rendering(48, "grid"), Error);
  EXPECT_NO_THROW(rendering(128, "jittered"));
}

TEST(GlIsr, TimesEachPass) {
  std::vector<std::string> names;
  for (const PassTime& pass : render_isr(corner_scene(), corner_view()).passes) names.push_back(pass.name);
  EXPECT_THAT(names,
              ::testing::IsSupersetOf({"direct", "downsample", "gather", "blur", "upsample and light"}));
}

TEST(Isr, DefinesFollowTheChoices) {
  const ParamValues params = resolve_params(isr_params(), isr_presets(), "paper", {}, "test");
  EXPECT_THAT(isr_defines(params),
              ::testing::IsSupersetOf({"WEIGHTING_PAPER", "SOURCE_ALBEDO", "BLUR_GAUSSIAN",
                                       "DOWNSAMPLING_MEAN", "UPSAMPLING_DEPTH"}));
}

TEST(Isr, PresetsOfTheThesisAreThere) {
  std::vector<std::string> names;
  for (const ParamPreset& preset : isr_presets()) names.push_back(preset.name);
  EXPECT_THAT(names, ::testing::IsSupersetOf({"area", "paper", "alone", "esm", "area-24", "area-48",
                                              "area-80", "paper-24", "paper-48", "paper-80"}));
}

}  // namespace
}  // namespace lightbench
