#include "povexport/pov_mesh.h"

#include <glm/ext/matrix_transform.hpp>
#include <glm/matrix.hpp>
#include <gmock/gmock.h>

#include "pov_test_scenes.h"

namespace lightbench {
namespace {

using testing::HasSubstr;
using testing::Not;

std::string mesh_text(const Scene& scene) {
  PovMaterials materials(scene);
  return pov_mesh(scene.meshes[0], 1, materials).text();
}

/// The facing square with normals that lean outwards.
Scene domed_scene() {
  Scene scene = scene_of(facing_square());
  for (std::size_t i = 0; i < 4; ++i)
    scene.meshes[0].normals[i] = glm::normalize(scene.meshes[0].positions[i] + glm::vec3(0, 0, 2));
  scene.lights = {frontal_light()};
  return scene;
}

TEST(PovMesh, FlatTrianglesHaveNoNormals) {
  EXPECT_THAT(mesh_text(scene_of(facing_square())), Not(HasSubstr("normal_vectors")));
  EXPECT_THAT(mesh_text(domed_scene()), HasSubstr("normal_vectors"));
}

TEST(PovMesh, UvAreWrittenOnlyForTextures) {
  Scene scene = scene_of(facing_square());
  EXPECT_THAT(mesh_text(scene), Not(HasSubstr("uv_vectors")));
  scene.textures = {{"a.png", Image8(1, 1, 4, 255)}};
  scene.materials[0].diffuse_texture = 0;
  EXPECT_THAT(mesh_text(scene), HasSubstr("uv_vectors"));
}

TEST(PovMesh, ATextureWithoutUvIsLookedUpAtZero) {
  Scene scene = scene_of(facing_square());
  scene.textures = {{"a.png", Image8(1, 1, 4, 255)}};
  scene.materials[0].diffuse_texture = 0;
  scene.meshes[0].uvs.clear();
  EXPECT_THAT(mesh_text(scene), HasSubstr("uv_vectors{1\n<0,0>\n}"));
}

TEST(PovMesh, EqualPositionsAreWrittenOnce) {
  Scene scene = scene_of(facing_square());
  Mesh& mesh = scene.meshes[0];
  mesh.positions.push_back(mesh.positions[0]);
  mesh.normals.push_back(mesh.normals[0]);
  mesh.triangles[1].x = 4;
  EXPECT_THAT(mesh_text(scene), HasSubstr("vertex_vectors{4\n"));
}

TEST(PovMesh, OneSmoothTriangleGivesAllTheirNormals) {
  Scene scene = scene_of(facing_square());
  scene.meshes[0].normals[3] = {0, 1, 0};
  EXPECT_THAT(mesh_text(scene), HasSubstr("normal_vectors{2\n<0,0,1>\n<0,1,0>\n}"));
  EXPECT_THAT(mesh_text(scene), HasSubstr("normal_indices{2\n<0,0,0>\n<0,0,1>\n}"));
}

TEST(PovMesh, OneIndexStandsForAllVectorsWhereThatIsShorter) {
  EXPECT_THAT(mesh_text(domed_scene()), Not(HasSubstr("normal_indices")));
  Scene scene = domed_scene();
  scene.textures = {{"a.png", Image8(1, 1, 4, 255)}};
  scene.materials[0].diffuse_texture = 0;
  scene.meshes[0].uvs[2] = scene.meshes[0].uvs[0];
  EXPECT_THAT(mesh_text(scene), HasSubstr("uv_vectors{4\n<0,0>\n<1,0>\n<0,0>\n<0,1>\n}"));
  EXPECT_THAT(mesh_text(scene), Not(HasSubstr("uv_indices")));
}

TEST(PovMesh, DigitsThatCannotBeSeenAreLeftOut) {
  Scene scene = scene_of(facing_square());
  scene.meshes[0].positions[0].x = -0.99999994f;
  EXPECT_THAT(mesh_text(scene), HasSubstr("<-0.9999999,-1,0>"));
  scene.meshes[0].normals[0] = {0.6f, 0.80000007f, 0};
  EXPECT_THAT(mesh_text(scene), HasSubstr("<0.6,0.8,0>"));
}

TEST(PovMesh, AMeshWithoutTrianglesIsNothing) {
  Scene scene = scene_of(Mesh{});
  EXPECT_EQ(mesh_text(scene), "");
}

/// The point that a pixel of a 32 x 32 image sees on the facing square.
glm::vec3 seen_point(int x, int y) {
  return {(float(x) + 0.5f) / 16 - 1, 1 - (float(y) + 0.5f) / 16, 0};
}

TEST(PovrayMesh, SmoothNormalsAreInterpolated) {
  const Scene scene = domed_scene();
  const Image image = render(scene, facing_camera());
  const auto& n = scene.meshes[0].normals;
  for (const int x : {2, 9, 20, 29}) {
    const int y = 31 - x;  // the diagonal, where both triangles agree with the bilinear normal
    const float t = seen_point(x, y).x / 2 + 0.5f;
    EXPECT_NEAR(image.pixel(x, y)[0], glm::normalize(glm::mix(n[0], n[2], t)).z, kHalfError);
  }
}

TEST(PovrayMesh, BothSidesAreLit) {
  Scene scene = scene_of(facing_square());
  scene.lights = {frontal_light()};
  scene.entities[0].transform = glm::rotate(glm::mat4(1), 3.14159265f, glm::vec3(0, 1, 0));
  EXPECT_NEAR(render(scene, facing_camera()).pixel(16, 16)[0], 1, kHalfError);
}

class PovrayScale : public testing::TestWithParam<float> {};

TEST_P(PovrayScale, MakesNoDifference) {
  Scene scene = domed_scene();
  scene.meshes.push_back(
      quad_mesh({{-0.5f, 0.3f, 0.01f}, {0.5f, 0.3f, 0.01f}, {0.5f, 0.3f, 1}, {-0.5f, 0.3f, 1}}));
  scene.entities.push_back({"shelf", 1, glm::mat4(1)});
  scene.lights[0].direction = glm::normalize(glm::vec3(0.1f, -0.3f, -1));
  const Image wanted = render(scene, facing_camera());
  Camera camera = facing_camera();
  camera.position *= GetParam();
  for (Mesh& mesh : scene.meshes)
    for (glm::vec3& position : mesh.positions) position *= GetParam();
  const Image image = render(scene, camera);
  std::size_t different = 0;
  for (std::size_t i = 0; i < image.data.size(); ++i)
    different += std::abs(image.data[i] - wanted.data[i]) > kHalfError;
  EXPECT_LE(different, 8u);  // two pixels on the shadow's edge, in four components
}

INSTANTIATE_TEST_SUITE_P(Povray, PovrayScale, testing::Values(1e-5f, 0.003f, 700.0f, 1e6f));

TEST(PovrayMesh, InstancesAreScaledThenTurnedThenMoved) {
  Scene scene = scene_of(facing_square());
  glm::mat4& m = scene.entities[0].transform;
  m = glm::translate(glm::mat4(1), glm::vec3(0.5f, 0, 0));
  m = glm::rotate(m, 3.14159265f / 2, glm::vec3(0, 0, 1));
  m = glm::scale(m, glm::vec3(0.75f, 0.25f, 1));
  const Image image = render(scene, facing_camera());
  const glm::mat4 back = glm::inverse(m);
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 32; ++x) {
      const glm::vec4 p = back * glm::vec4(seen_point(x, y), 1);
      const bool inside = std::abs(p.x) < 1 && std::abs(p.y) < 1;
      ASSERT_EQ(image.pixel(x, y)[3], inside ? 1 : 0) << x << " " << y;
    }
}

TEST(PovrayMesh, NormalsOfInstancesAreTransformedByTheInverseTranspose) {
  Scene scene = domed_scene();
  scene.entities[0].transform = glm::scale(glm::mat4(1), glm::vec3(1, 1, 0.5f));
  const auto& n = scene.meshes[0].normals;
  const glm::vec3 local = glm::mix(n[0], n[2], seen_point(24, 7).x / 2 + 0.5f);
  const float wanted = glm::normalize(local * glm::vec3(1, 1, 2)).z;
  EXPECT_NEAR(render(scene, facing_camera()).pixel(24, 7)[0], wanted, kHalfError);
}

}  // namespace
}  // namespace lightbench
