#include "renderer/techniques/surface_radiance.h"

#include <cmath>

#include <gmock/gmock.h>

#include "base/files.h"
#include "renderer/path_tracer.h"
#include "renderer/radiance/object_bake.h"
#include "renderer/radiance/radiance_file.h"
#include "tests/renderer/room_scenes.h"

namespace lightbench {
namespace {

using namespace test;

ParamValues values_of(const std::map<std::string, ParamValue>& given) {
  const Technique technique = surface_radiance_technique();
  return resolve_params(technique.params, technique.presets, "", given, "");
}

/// Bakes all objects of a scene and draws them.
Image drawn(const Scene& scene, const View& view, const std::map<std::string, ParamValue>& given,
            int width = 64, int height = 48) {
  const ParamValues params = values_of(given);
  const TemporaryFolder folder;
  const ObjectBaker baker(scene);
  for (const std::size_t entity : objects_to_bake(scene))
    write_radiance(folder.path() / (object_file_stem(scene, entity) + ".mtex"),
                   baker.bake(entity, bake_settings(params)).stack);
  FrameRequest request{scene, view, width, height, 1, {}, folder.path()};
  return Renderer(GlBackend::osmesa).render(surface_radiance_technique(), params, request).image;
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
