#include "renderer/gbuffer.h"

#include <gtest/gtest.h>

#include "base/color.h"
#include "renderer/frame_context.h"
#include "renderer/gl_context.h"
#include "renderer/gpu_scene.h"
#include "tests/renderer/render_scene.h"

namespace lightbench {
namespace {

using test::add_quad;
using test::floor_scene;
using test::render;
using test::top_view;

std::map<std::string, Image> buffers_of(const Scene& scene, const View& view, std::set<std::string> names) {
  test::RenderSetup setup;
  setup.buffers = std::move(names);
  return render(scene, view, setup).buffers;
}

// Two by two texels: red, green above blue, white.
Texture four_colors() {
  Texture texture;
  texture.pixels = Image8(2, 2, 4);
  texture.pixels.data = {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 255, 255, 255, 255};
  return texture;
}

// A quad that fills the picture of top_view: u to the right, v upwards in the picture.
Scene filling_quad(const View& view) {
  Scene scene;
  scene.materials = {test::matte(glm::vec3(1))};
  const float half_height = std::tan(view.camera.fov / 2) * view.camera.position.y;
  const float half_width = half_height * 64 / 48;
  add_quad(scene, {-half_width, 0, half_height}, {2 * half_width, 0, 0}, {0, 0, -2 * half_height});
  return scene;
}

TEST(GlGBuffer, DepthGivesBackThePositionOfTheFloor) {
  View view = top_view(3);
  view.camera.look_at = {0.5f, 0, -1};
  const Image depth = buffers_of(floor_scene(), view, {"depth"}).at("depth");
  const FrameCamera camera = frame_camera(view.camera, 64.0f / 48.0f, {0.01f, 1.0f});
  for (int y = 0; y < 48; ++y)
    for (int x = 0; x < 64; ++x) {
      const float u = (float(x) + 0.5f) / 64, v = 1 - (float(y) + 0.5f) / 48;
      const glm::vec3 p =
          camera.position + (camera.far_corner + u * camera.far_u + v * camera.far_v) * depth.pixel(x, y)[0];
      ASSERT_NEAR(p.y, 0, 1e-5) << x << "," << y;  // 3 units away, 24 bits: 4e-7 a step
    }
}

TEST(GlGBuffer, TheFirstRowIsTheTopOfThePicture) {
  Scene scene = floor_scene();
  scene.materials.push_back(test::matte({1, 0, 0}));
  // To the left (-x) and the top (-z) of the picture.
  add_quad(scene, {-2, 0.1f, -1}, {1, 0, 0}, {0, 0, -0.5f}, 1);
  const View view = top_view(4);
  const Image albedo = buffers_of(scene, view, {"albedo"}).at("albedo");
  int red = 0;
  for (int y = 0; y < 48; ++y)
    for (int x = 0; x < 64; ++x) {
      if (albedo.pixel(x, y)[1] != 0) continue;
      ++red;
      EXPECT_LT(x, 32);
      EXPECT_LT(y, 24);
    }
  EXPECT_GT(red, 20);
}

TEST(GlGBuffer, TextureRowsStartAtTheTopOfTheImage) {
  const View view = top_view(2);
  Scene scene = filling_quad(view);
  scene.textures = {four_colors()};
  scene.materials[0].diffuse_texture = 0;
  const Image albedo = buffers_of(scene, view, {"albedo"}).at("albedo");
  // At texel centres bilinear lookups give the texel itself.
  const auto color = [&](int x, int y) {
    const auto pixel = albedo.pixel(x, y);
    return glm::vec3(pixel[0], pixel[1], pixel[2]);
  };
  const float near = 0.05f;  // pixel centres lie up to half a pixel, 1/64 of a texel's width, beside
  EXPECT_LT(glm::distance(color(16, 12), glm::vec3(1, 0, 0)), near);
  EXPECT_LT(glm::distance(color(48, 12), glm::vec3(0, 1, 0)), near);
  EXPECT_LT(glm::distance(color(16, 36), glm::vec3(0, 0, 1)), near);
  EXPECT_LT(glm::distance(color(48, 36), glm::vec3(1, 1, 1)), near);
}

TEST(GlGBuffer, AlbedoIsTheProductOfMaterialTextureAndVertexColour) {
  const View view = top_view(2);
  Scene scene = filling_quad(view);
  Texture grey;
  grey.pixels = Image8(1, 1, 4, 188);
  scene.textures = {grey};
  scene.materials[0].diffuse = {0.5f, 1, 0.25f};
  scene.materials[0].diffuse_texture = 0;
  scene.meshes[0].colors.assign(4, {1, 0.5f, 0.5f});
  const Image albedo = buffers_of(scene, view, {"albedo"}).at("albedo");
  const float texel = srgb_decode8(188);
  // Half floats keep 11 bits.
  EXPECT_NEAR(albedo.pixel(5, 5)[0], 0.5f * texel, 3e-4f);
  EXPECT_NEAR(albedo.pixel(5, 5)[1], 0.5f * texel, 3e-4f);
  EXPECT_NEAR(albedo.pixel(5, 5)[2], 0.125f * texel, 3e-4f);
}

TEST(GlGBuffer, CutOutsTakeTheNearestTexel) {
  const View view = top_view(2);
  Scene scene = filling_quad(view);
  Texture mask = four_colors();
  mask.pixels.data[3] = 127;   // upper left: below a half
  mask.pixels.data[15] = 128;  // lower right: not below
  scene.textures = {mask};
  scene.materials[0].cutout_texture = 0;
  const Image image = render(scene, view).image;
  for (int y = 0; y < 48; ++y)
    for (int x = 0; x < 64; ++x)
      ASSERT_EQ(image.pixel(x, y)[3], x < 32 && y < 24 ? 0.0f : 1.0f) << x << "," << y;
}

TEST(GlGBuffer, NormalsFaceTheViewer) {
  Scene scene = floor_scene();
  for (glm::vec3& normal : scene.meshes[0].normals) normal = -normal;
  const Image normal = buffers_of(scene, top_view(3), {"normal"}).at("normal");
  for (std::size_t i = 0; i < normal.data.size(); i += 3) {
    ASSERT_EQ(normal.data[i], 0.0f);
    ASSERT_EQ(normal.data[i + 1], 1.0f);
    ASSERT_EQ(normal.data[i + 2], 0.0f);
  }
}

TEST(GlGBuffer, NormalsTurnWithUnevenlyScaledEntities) {
  Scene scene;
  scene.materials = {test::matte(glm::vec3(1))};
  add_quad(scene, {-1, -1, 1}, {2, 2, 0}, {0, 0, -2});  // normal (-1, 1, 0)
  scene.entities[0].transform[1].y = 3;
  const Image normal = buffers_of(scene, top_view(12), {"normal"}).at("normal");
  const glm::vec3 expected = glm::normalize(glm::vec3(-3, 1, 0));
  const auto centre = normal.pixel(32, 24);
  EXPECT_LT(glm::distance(glm::vec3(centre[0], centre[1], centre[2]), expected), 1e-4f);  // 16 bits
}

TEST(GlGBuffer, BackgroundPixelsAreEmpty) {
  Scene scene;
  scene.materials = {test::matte(glm::vec3(1))};
  add_quad(scene, {-0.2f, 0, 0.2f}, {0.4f, 0, 0}, {0, 0, -0.4f});
  const auto buffers = buffers_of(scene, top_view(3), {"albedo", "normal", "depth", "shadow"});
  EXPECT_EQ(buffers.at("depth").pixel(0, 0)[0], 0.0f);
  EXPECT_EQ(buffers.at("albedo").pixel(0, 0)[0], 0.0f);
  EXPECT_EQ(buffers.at("normal").pixel(0, 0)[1], 0.0f);
  EXPECT_EQ(buffers.at("shadow").pixel(0, 0)[0], 1.0f);
  EXPECT_GT(buffers.at("depth").pixel(32, 24)[0], 2.9f);
}

// Draws one G-buffer with the given options.
class GlGBufferOptions : public testing::Test {
 protected:
  GBuffer draw(const Scene& scene, const View& view, const GBufferOptions& options) {
    request_ = std::make_unique<FrameRequest>(FrameRequest{scene, view, 64, 48, 1, {}});
    gpu_scene_ = std::make_unique<GpuScene>(scene);
    FrameContext frame(*request_, &gpu_, gpu_scene_.get());
    return draw_gbuffer(frame, frame.camera(), 64, 48, options);
  }

  std::unique_ptr<GlContext> context_ = make_gl_context(GlBackend::osmesa);
  GpuState gpu_;
  std::unique_ptr<FrameRequest> request_;
  std::unique_ptr<GpuScene> gpu_scene_;
};

TEST_F(GlGBufferOptions, CullingChangesNothing) {
  Scene scene = floor_scene();
  for (int row = 0; row < 5; ++row)
    for (int column = 0; column < 8; ++column)
      add_quad(scene, {float(column) * 2 - 8, 0.1f * float(8 * row + column), float(row) * 3 - 7},
               {1.5f, 0.3f, 0}, {0, 0.2f, -1.5f});
  View view = top_view(6);
  view.camera.look_at = {3, 0, -4};
  const GBuffer culled = draw(scene, view, {});
  const Image depth = read_back(culled.depth, 1);
  EXPECT_EQ(read_back(draw(scene, view, {.culling = FrustumCulling::off}).depth, 1), depth);
}

TEST_F(GlGBufferOptions, EightBitNormalsFollowThePaper) {
  Scene scene = floor_scene();
  const GBuffer gbuffer = draw(scene, top_view(3), {.normals = NormalFormat::rgb8});
  const auto stored = read_back(gbuffer.normal, 3);
  // n = 2c/255 - 1 has no exact 0: the nearest are c = 127 and 128.
  EXPECT_NEAR(stored.data[0] * 255, 127.5, 0.51);
  EXPECT_EQ(stored.data[1] * 255, 255.0f);
}

TEST_F(GlGBufferOptions, TheRadiationMaskIsInTheAlbedosAlpha) {
  Scene scene = floor_scene();
  scene.materials[0].reflectance = 0.75f;
  const Image albedo = read_back(draw(scene, top_view(3), {}).albedo, 4);
  EXPECT_EQ(albedo.data[3], 0.75f);
}

TEST_F(GlGBufferOptions, TheGeometricNormalIsTheTriangles) {
  Scene scene = floor_scene();
  for (glm::vec3& normal : scene.meshes[0].normals) normal = glm::normalize(glm::vec3(0.5f, 1, 0));
  const Image stored = read_back(draw(scene, top_view(3), {}).geometric_normal, 2);
  // (0, 1, 0) on the octahedron is (0, 1), stored as (p + 1) / 2 of 65534 steps; derivatives are good to
  // 1e-4.
  EXPECT_NEAR(stored.data[0] * 65535 / 32767 - 1, 0, 1e-4);
  EXPECT_NEAR(stored.data[1] * 65535 / 32767 - 1, 1, 1e-4);
}

}  // namespace
}  // namespace lightbench
