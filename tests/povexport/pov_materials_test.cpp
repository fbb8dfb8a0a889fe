#include "povexport/pov_materials.h"

#include <cmath>
#include <random>

#include <gmock/gmock.h>

#include "base/color.h"
#include "pov_test_scenes.h"

namespace lightbench {
namespace {

constexpr int kSize = 64;

Image8 random_texture(int size) {
  std::mt19937 random(7);
  Image8 image(size, size, 4);
  for (auto& component : image.data) component = std::uint8_t(random() & 255);
  return image;
}

/// The frontal square with material and texture, lit so that it shows its albedo.
Scene textured_scene(const Material& material, const Image8& image, float repeat) {
  Scene scene = scene_of(facing_square(repeat), material);
  scene.textures = {{"texture.png", image}};
  scene.lights = {frontal_light()};
  return scene;
}

int wrapped(int i, int size) {
  return ((i % size) + size) % size;
}

/// GL_LINEAR and GL_REPEAT over decoded texels.
glm::vec3 linear_lookup(const Image8& image, float u, float v) {
  const float x = u * float(image.width) - 0.5f, y = (1 - v) * float(image.height) - 0.5f;
  const int x0 = int(std::floor(x)), y0 = int(std::floor(y));
  const float fx = x - float(x0), fy = y - float(y0);
  glm::vec3 sum(0);
  for (int j = 0; j < 2; ++j)
    for (int i = 0; i < 2; ++i) {
      const auto texel = image.pixel(wrapped(x0 + i, image.width), wrapped(y0 + j, image.height));
      const float weight = (i ? fx : 1 - fx) * (j ? fy : 1 - fy);
      sum += weight * glm::vec3(srgb_decode8(texel[0]), srgb_decode8(texel[1]), srgb_decode8(texel[2]));
    }
  return sum;
}

glm::vec2 uv_at(int x, int y, float repeat) {
  return repeat * glm::vec2((float(x) + 0.5f) / kSize, 1 - (float(y) + 0.5f) / kSize);
}

template <typename Expected>
void expect_pixels(const Image& image, float tolerance, Expected expected) {
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const glm::vec3 wanted = expected(x, y);
      for (int c = 0; c < 3; ++c)
        ASSERT_NEAR(image.pixel(x, y)[std::size_t(c)], wanted[c], tolerance) << x << " " << y;
    }
}

TEST(PovrayMaterials, TexturesAreFilteredAndRepeatedAsInOpenGl) {
  Material material = matte(glm::vec3(1));
  material.diffuse_texture = 0;
  const Image8 texture = random_texture(4);
  const Image image =
      render(textured_scene(material, texture, 2.5f), facing_camera(), direct_options(), kSize, kSize);
  expect_pixels(image, kHalfError, [&](int x, int y) {
    const glm::vec2 uv = uv_at(x, y, 2.5f);
    return linear_lookup(texture, uv.x, uv.y);
  });
}

TEST(PovrayMaterials, AColouredFactorMultipliesTheTexture) {
  Material material = matte({0.5f, 1.25f, 0});
  material.diffuse_texture = 0;
  const Image8 texture = random_texture(4);
  const Image image =
      render(textured_scene(material, texture, 1), facing_camera(), direct_options(), kSize, kSize);
  expect_pixels(image, kHalfError, [&](int x, int y) {
    const glm::vec2 uv = uv_at(x, y, 1);
    return material.diffuse * linear_lookup(texture, uv.x, uv.y);
  });
}

TEST(PovrayMaterials, VertexColoursAreInterpolatedOverATexture) {
  Material material = matte(glm::vec3(1));
  material.diffuse_texture = 0;
  const Image8 texture = random_texture(4);
  Scene scene = textured_scene(material, texture, 1);
  scene.meshes[0].colors = {{1, 0, 0}, {0, 1, 0}, {0, 1, 1}, {1, 0, 1}};  // bilinear: (1-u, u, v)
  const Image image = render(scene, facing_camera(), direct_options(), kSize, kSize);
  expect_pixels(image, kHalfError, [&](int x, int y) {
    const glm::vec2 uv = uv_at(x, y, 1);
    return glm::vec3(1 - uv.x, uv.x, uv.y) * linear_lookup(texture, uv.x, uv.y);
  });
}

/// ks (R.V)^Ns of the frontal light.
float highlight(const Material& material, int x, int y) {
  const glm::vec2 p = 2.0f * uv_at(x, y, 1) - 1.0f;
  return material.specular * std::pow(5 / glm::length(glm::vec3(p, 5)), material.exponent);
}

class PovrayHighlights : public testing::TestWithParam<glm::vec3> {};

TEST_P(PovrayHighlights, AreUntintedWhateverTheSurface) {
  Material material = matte(GetParam());
  material.specular = 0.4f;
  material.exponent = 30;
  material.diffuse_texture = GetParam().x > 0.5f ? 0 : kNoTexture;
  const Image8 grey(1, 1, 4, 188);
  const Image image =
      render(textured_scene(material, grey, 1), facing_camera(), direct_options(), kSize, kSize);
  const float texel = material.diffuse_texture == 0 ? srgb_decode8(188) : 1;
  expect_pixels(image, kHalfError,
                [&](int x, int y) { return material.diffuse * texel + highlight(material, x, y); });
}

INSTANTIATE_TEST_SUITE_P(PovraySurfaces, PovrayHighlights,
                         testing::Values(glm::vec3(0.25f), glm::vec3(0.25f, 0, 0), glm::vec3(0.75f),
                                         glm::vec3(0.75f, 0.5f, 0)));

TEST(PovrayMaterials, EmissionIsAddedToTheLitSurface) {
  Material material = matte({0.5f, 0, 0});
  material.emission = {0.25f, 0.5f, 1.5f};
  Scene scene = scene_of(facing_square(), material);
  scene.lights = {frontal_light()};
  expect_pixels(render(scene, facing_camera()), kHalfError,
                [](int, int) { return glm::vec3(0.75f, 0.5f, 1.5f); });
}

TEST(PovrayMaterials, CutOutsFollowTheNearestTexel) {
  Material material = matte(glm::vec3(1));
  material.cutout_texture = 0;
  const Image8 texture = random_texture(4);
  const Scene scene = textured_scene(material, texture, 2.5f);
  const Image image = render(scene, facing_camera(), direct_options(), kSize, kSize);
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < kSize; ++x) {
      const glm::vec2 uv = uv_at(x, y, 2.5f);
      const int i = wrapped(int(std::floor(uv.x * 4)), 4), j = wrapped(int(std::floor((1 - uv.y) * 4)), 4);
      ASSERT_EQ(image.pixel(x, y)[3], texture.pixel(i, j)[3] >= 128 ? 1 : 0) << x << " " << y;
    }
}

/// A wall behind a quad that is cut out but for its left half.
Scene shadow_scene() {
  Material half = matte(glm::vec3(0));
  half.cutout_texture = 0;
  Scene scene = scene_of(facing_square(), half);
  Image8 mask(2, 1, 4, 255);
  mask.pixel(1, 0)[3] = 0;
  scene.textures = {{"mask.png", mask}};
  scene.materials.push_back(matte(glm::vec3(1)));
  scene.meshes.push_back(quad_mesh({{-2, -2, -1}, {2, -2, -1}, {2, 2, -1}, {-2, 2, -1}}));
  scene.meshes[1].parts[0].material = 1;
  scene.entities.push_back({"wall", 1, glm::mat4(1)});
  scene.lights = {frontal_light()};
  scene.lights[0].direction = glm::normalize(glm::vec3(1, 0, -1));
  return scene;
}

TEST(PovrayMaterials, CutOutsCastCutOutShadows) {
  // The solid half spans x = -1..0 and its shadow on the wall 0..1, seen through the open half.
  const Image image = render(shadow_scene(), {{0, 0, 100}, {0, 0, 0}, {0, 1, 0}, 0.04f});
  EXPECT_EQ(image.pixel(20, 16)[0], 0);
  EXPECT_NEAR(image.pixel(28, 16)[0], std::sqrt(0.5f), kHalfError);
}

TEST(PovrayMaterials, ManyStackedCutOutsStayClear) {
  Material clear = matte(glm::vec3(1));
  clear.cutout_texture = 0;
  Scene scene = textured_scene(clear, Image8(1, 1, 4, 0), 1);
  for (int i = 0; i < 100; ++i) {
    Entity entity{"layer", 0, glm::mat4(1)};
    entity.transform[3][2] = 0.01f * float(i);
    scene.entities.push_back(entity);
  }
  scene.background.color = {0.5f, 0.25f, 1};
  const Image image = render(scene, facing_camera());
  EXPECT_NEAR(image.pixel(16, 16)[1], 0.25f, kHalfError);
  EXPECT_EQ(image.pixel(16, 16)[3], 0);
}

TEST(PovMaterials, TexturesThatNobodyUsesAreNotWritten) {
  Scene scene = scene_of(facing_square());
  scene.textures = {{"unused.png", random_texture(2)}};
  PovMaterials materials(scene);
  materials.texture(0);
  EXPECT_TRUE(materials.take_images().empty());
}

TEST(PovMaterials, OneDeclarationForEachColourOfAMaterial) {
  const Scene scene = scene_of(facing_square());
  PovMaterials materials(scene);
  EXPECT_EQ(materials.texture(0, {1, 0, 0}), 1);
  EXPECT_EQ(materials.texture(0, {0, 1, 0}), 2);
  EXPECT_EQ(materials.texture(0, {1, 0, 0}), 1);
}

}  // namespace
}  // namespace lightbench
