#include "renderer/techniques/surface_radiance.h"

#include <cmath>
#include <functional>

#include <gmock/gmock.h>

#include "base/color.h"
#include "base/files.h"
#include "renderer/path_tracer.h"
#include "renderer/radiance/object_bake.h"
#include "renderer/radiance/pca_encoder.h"
#include "renderer/radiance/piecewise_encoder.h"
#include "renderer/radiance/piecewise_file.h"
#include "renderer/radiance/radiance_codecs.h"
#include "renderer/radiance/radiance_file.h"
#include "scene/box_mesh.h"
#include "tests/renderer/room_scenes.h"

namespace lightbench {
namespace {

using namespace test;

ParamValues values_of(const std::map<std::string, ParamValue>& given) {
  const Technique technique = surface_radiance_technique();
  return resolve_params(technique.params, technique.presets, "", given, "");
}

/// Writes the files of an object whose texels are where `counts` has a 1.
using Keep = std::function<void(const HalfStack& stack, std::span<const std::uint8_t> counts,
                                const std::filesystem::path& stem)>;

/// Bakes and keeps all objects of a scene and draws them.
Image drawn_from(const Keep& keep, const Scene& scene, const View& view, const ParamValues& params,
                 int width = 64, int height = 48) {
  const TemporaryFolder folder;
  const ObjectBaker baker(scene);
  for (const std::size_t entity : objects_to_bake(scene)) {
    const HalfStack stack = baker.bake(entity, bake_settings(params)).stack;
    keep(stack, counting_places(object_atlas(scene, entity, bake_settings(params)), stack.height),
         folder.path() / object_file_stem(scene, entity));
  }
  FrameRequest request{scene, view, width, height, 1, {}, folder.path()};
  return Renderer(GlBackend::osmesa).render(surface_radiance_technique(), params, request).image;
}

/// Kept by the codec that the parameters name.
Image drawn(const Scene& scene, const View& view, const std::map<std::string, ParamValue>& given,
            int width = 64, int height = 48) {
  const ParamValues params = values_of(given);
  const auto keep = [&](const HalfStack& stack, std::span<const std::uint8_t> counts,
                        const std::filesystem::path& stem) {
    if (const auto compress = radiance_codec(params).compress)
      compress(stack, counts, params, stem);
    else
      write_radiance(stem.string() + ".mtex", stack);
  };
  return drawn_from(keep, scene, view, params, width, height);
}

/// What the path tracer makes of it, without noise.
Image traced(const Scene& scene, const View& view, int width = 64, int height = 48) {
  PathTracerOptions options;
  options.bounces = 0;
  return trace_paths(scene, view, width, height, 1, options).image;
}

double mean_difference(const Image& a, const Image& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.data.size(); ++i) sum += std::abs(double(a.data[i]) - double(b.data[i]));
  return sum / double(a.data.size());
}

TEST(GlSurfaceRadiance, ShowsWhatThePathTracerShowsOfMatteSurfaces) {
  const Scene scene = room();
  // Texels of a fiftieth of the room: what is left are the shadow's edges and the corners.
  EXPECT_LT(mean_difference(drawn(scene, inside_view(), {{"texels", 2e5}, {"thetas", 2LL}, {"phis", 1LL}}),
                            traced(scene, inside_view())),
            0.004);
}

TEST(GlSurfaceRadiance, ShowsHighlights) {
  Scene scene = floor_scene();
  scene.materials[0].specular = 0.5f;
  scene.materials[0].exponent = 10;
  scene.lights = {point_light({1, 2, -2})};
  View view = inside_view();
  view.camera.position = {0, 2, 3};
  view.camera.look_at = {0, 0, 0};
  const Image image = drawn(scene, view, {{"texels", 4e4}, {"thetas", 20LL}, {"phis", 20LL}});
  const Image exact = traced(scene, view);
  // Measured for such an exponent: 0.7 to 1 of 255 from 20 x 20 directions, in sRGB; here linear.
  EXPECT_LT(mean_difference(image, exact), 0.004);
  EXPECT_GT(mean_difference(drawn(scene, view, {{"texels", 4e4}, {"thetas", 3LL}, {"phis", 3LL}}), exact),
            0.01)
      << "with few directions it is far off";
}

TEST(GlSurfaceRadiance, GlossyObjectsHaveMoreDirections) {
  Scene scene = floor_scene();
  scene.materials[0].specular = 0.5f;
  scene.materials[0].exponent = 40;
  scene.materials.emplace_back();
  scene.meshes.push_back(box_mesh("box", {{-3, 0, -6}, {-1, 2, -4}}, int(scene.materials.size()) - 1));
  scene.entities.push_back({"box", int(scene.meshes.size()) - 1});
  scene.lights = {point_light({1, 2, -2})};
  View view = inside_view();
  view.camera.position = {0, 2, 3};
  view.camera.look_at = {0, 0, 0};
  const Image exact = traced(scene, view);
  const auto error = [&](double gloss_exponent, const char* codec) {
    return mean_difference(drawn(scene, view,
                                 {{"texels", 1e4},
                                  {"thetas", 8LL},
                                  {"phis", 8LL},
                                  {"gloss_exponent", gloss_exponent},
                                  {"bound", 3LL},  // of pca, which may drop highlights without
                                  {"codec", std::string(codec)}}),
                           exact);
  };
  // 15 x 16 directions instead of 8 x 8: errors of linear interpolation fall with the square of the step.
  for (const char* codec : {"raw", "piecewise", "pca"})
    EXPECT_LT(error(10, codec), 0.5 * error(0, codec)) << codec;
}

TEST(GlSurfaceRadiance, TheOrderOfLayersChangesNothing) {
  Scene scene = floor_scene();
  scene.materials[0].specular = 0.5f;
  scene.materials[0].exponent = 5;
  scene.lights = {point_light({1, 2, -2})};
  View view = inside_view();
  const std::map<std::string, ParamValue> given{{"texels", 1e4}, {"thetas", 6LL}, {"phis", 8LL}};
  const auto with_order = [&](const char* order) {
    auto params = given;
    params["order"] = std::string(order);
    return drawn(scene, view, params).data;
  };
  const auto serpentine = with_order("phi_serpentine");
  EXPECT_EQ(with_order("theta_major"), serpentine);
  EXPECT_EQ(with_order("phi_major"), serpentine);
}

/// A shiny floor under a lamp, seen from the side.
struct Shiny {
  Scene scene = floor_scene();
  View view = inside_view();
  std::map<std::string, ParamValue> given{{"texels", 4e3}, {"thetas", 12LL}, {"phis", 14LL}};

  Shiny() {
    scene.materials[0].specular = 0.4f;
    scene.materials[0].exponent = 8;
    scene.lights = {point_light({1, 2, -2})};
    scene.lights[0].power = 0.7f;
    view.camera.position = {0, 2, 3};
    view.camera.look_at = {0, 0, 0};
  }
  std::map<std::string, ParamValue> completed(std::map<std::string, ParamValue> params) const {
    params.insert(given.begin(), given.end());
    return params;
  }
  Image with(const std::map<std::string, ParamValue>& more) const {
    return drawn(scene, view, completed(more));
  }
};

TEST(GlSurfaceRadiance, PiecewiseWithoutLossIsTheRoundedRadiance) {
  const Shiny shiny;
  // Rounding to 8 bits: up to half a step of sRGB, which is 0.0045 of linear light at most, and 0.001 on
  // average.
  EXPECT_LT(
      mean_difference(shiny.with({{"codec", std::string("piecewise")}, {"threshold", 0LL}}), shiny.with({})),
      0.001);
}

TEST(GlSurfaceRadiance, AllSearchesFindTheSame) {
  const Shiny shiny;
  for (const LayerOrderName& order : layer_orders()) {
    const auto with_search = [&](const char* search) {
      return shiny
          .with({{"codec", std::string("piecewise")},
                 {"threshold", 9LL},
                 {"order", std::string(order.name)},
                 {"search", std::string(search)}})
          .data;
    };
    const auto once = with_search("once");
    EXPECT_EQ(with_search("binary"), once) << order.name;
    EXPECT_EQ(with_search("linear"), once) << order.name;
  }
}

TEST(GlSurfaceRadiance, ComponentsComeAsNearAsTheyWereAskedTo) {
  const Shiny shiny;
  const Image raw = shiny.with({});
  const auto error_of = [&](double error) {
    return mean_difference(
        shiny.with({{"codec", std::string("pca")}, {"mean_error", error}, {"error_99", 6 * error}}), raw);
  };
  // One step of sRGB is 0.009 of linear light at most; here most is darker, and alpha has no error.
  EXPECT_LT(error_of(0.5), 0.5 * 0.009);
  EXPECT_LT(error_of(0.5), error_of(4));
}

/// The largest of any component of any pixel, in steps of sRGB.
double largest_difference(const Image& a, const Image& b) {
  double most = 0;
  for (std::size_t i = 0; i < a.data.size(); ++i)
    most = std::max(most, 255 * std::abs(double(srgb_encode(a.data[i])) - double(srgb_encode(b.data[i]))));
  return most;
}

std::map<std::string, ParamValue> bounded(long long bound) {
  return {{"codec", std::string("pca")}, {"bound", bound}, {"coefficients", 12LL}};
}
std::map<std::string, ParamValue> lossless() {
  return {{"codec", std::string("piecewise")}, {"threshold", 0LL}};
}

TEST(GlSurfaceRadiance, ABoundHoldsInThePicture) {
  const Shiny shiny;
  const Image exact = shiny.with(lossless());
  for (const long long bound : {6, 24}) {
    const double difference = largest_difference(shiny.with(bounded(bound)), exact);
    // An error of whole steps is below the bound; mixing in linear light makes it larger only near black,
    // where sRGB is bent.
    EXPECT_LT(difference, double(bound - 1) + 1e-3);
    EXPECT_GT(difference, 0.9) << "it is not without loss";
  }
}

TEST(GlSurfaceRadiance, BoundedComponentsAreThoseOfTheDecoder) {
  const auto keep_decoded = [](const HalfStack& stack, std::span<const std::uint8_t> counts,
                               const std::filesystem::path& stem) {
    PcaOptions options;
    options.max_coefficients = 12, options.threshold = 6;
    const PcaStack pca = encode_pca(stack, counts, options);
    EXPECT_FALSE(pca.corrections.empty());
    write_piecewise(stem, encode_piecewise(decode_pca(pca), SampleRule::greedy, 0));
  };
  Shiny shiny;
  for (const LayerOrderName& order : layer_orders()) {
    shiny.given["order"] = std::string(order.name);
    const Image decoded =
        drawn_from(keep_decoded, shiny.scene, shiny.view, values_of(shiny.completed(lossless())));
    // What is left is the order in which floats are mixed.
    EXPECT_LT(largest_difference(shiny.with(bounded(6)), decoded), 1e-3) << order.name;
  }
}

TEST(GlSurfaceRadiance, ABoundOfOneIsLossless) {
  const Shiny shiny;
  const Image exact = shiny.with(lossless());
  for (const char* bits : {"8", "16"}) {
    auto params = bounded(1);
    params["first_bits"] = std::string(bits);
    EXPECT_LT(largest_difference(shiny.with(params), exact), 1e-3) << bits;
  }
}

TEST(GlSurfaceRadiance, MatteObjectsNeedNoCorrections) {
  const Scene scene = room();
  const auto with = [&](std::map<std::string, ParamValue> params) {
    params.insert({{"texels", 2e4}, {"thetas", 4LL}, {"phis", 5LL}});
    return drawn(scene, inside_view(), params);
  };
  EXPECT_LT(largest_difference(with(bounded(6)), with(lossless())), 1e-3);
}

TEST(GlSurfaceRadiance, ComponentsOfMatteObjectsHaveOneDirection) {
  const Scene scene = room();
  const std::map<std::string, ParamValue> given{{"texels", 2e4}, {"thetas", 4LL}, {"phis", 5LL}};
  auto compressed = given;
  compressed["codec"] = std::string("pca");
  EXPECT_LT(mean_difference(drawn(scene, inside_view(), compressed), drawn(scene, inside_view(), given)),
            0.002)
      << "rounded to 8 bits";
}

TEST(GlSurfaceRadiance, BothSidesAreLitEachByItself) {
  Scene scene = floor_scene();
  scene.lights = {point_light({0, -1, 0})};
  View view = top_view(3);
  const std::map<std::string, ParamValue> given{{"texels", 1e4}, {"thetas", 2LL}, {"phis", 1LL}};
  EXPECT_EQ(drawn(scene, view, given).pixel(32, 24)[0], 0);
  view.camera.position.y = -3;
  EXPECT_NEAR(drawn(scene, view, given).pixel(32, 24)[0], 0.5f, 0.01f);
}

TEST(GlSurfaceRadiance, OnTheBackgroundNothingIsDrawn) {
  Scene scene = floor_scene();
  scene.background.color = {0.1f, 0.2f, 0.3f};
  View view = top_view(3);
  view.camera.look_at = {0, 6, 0};
  const Image image = drawn(scene, view, {{"texels", 100.0}, {"thetas", 2LL}, {"phis", 1LL}});
  EXPECT_EQ(image.pixel(5, 5)[1], 0.2f);
  EXPECT_EQ(image.pixel(5, 5)[3], 0);
}

TEST(GlSurfaceRadiance, SaysWhatIsMissing) {
  const Scene scene = floor_scene();
  const View view = top_view(3);
  Renderer renderer(GlBackend::osmesa);
  const auto message = [&](const std::filesystem::path& baked) {
    try {
      renderer.render(surface_radiance_technique(), values_of({}), {scene, view, 8, 8, 1, {}, baked});
    } catch (const std::exception& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_THAT(message({}), ::testing::HasSubstr("no folder of baked objects"));
  EXPECT_THAT(message("/nowhere"), ::testing::HasSubstr("0000-quad.mtex"));
}

}  // namespace
}  // namespace lightbench
