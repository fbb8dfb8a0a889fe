#include "scene/scene_file.h"

#include <cstdlib>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "base/image_io.h"
#include "scene_test_files.h"

namespace lightbench {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

TEST(SceneFile, LoadsEntitiesOfObjFiles) {
  const SceneTestFiles files;
  const LoadedScene loaded = load_square(files, R"(, "name": "test")");
  EXPECT_EQ(loaded.scene.name, "test");
  ASSERT_EQ(loaded.scene.entities.size(), 1u);
  EXPECT_EQ(loaded.scene.entities[0].name, "e");
  EXPECT_EQ(loaded.scene.entities[0].transform, glm::mat4(1));
  EXPECT_EQ(triangle_count(loaded.scene), 2u);
}

TEST(SceneFile, TakesItsNameFromTheFileWhereItHasNone) {
  const SceneTestFiles files;
  EXPECT_EQ(load_square(files, "").scene.name, "s");
}

TEST(SceneFile, LoadsAnObjOnceHoweverManyEntitiesNameIt) {
  const SceneTestFiles files;
  files.write("m.obj", kSquareObj);
  const auto loaded = load_scene_collecting(
      files.write("s.json", R"({"entities": [{"obj": "m.obj"}, {"obj": "./m.obj", "transform": {"scale": 2}},
                                 {"obj": "m.obj", "up": "z"}, {"obj": "m.obj", "crease_angle": 10}]})"));
  EXPECT_EQ(loaded.scene.entities.size(), 4u);
  EXPECT_EQ(loaded.scene.meshes.size(), 2u) << "another crease angle gives other normals";
  EXPECT_EQ(loaded.scene.files.size(), 2u);
}

TEST(SceneFile, AnEntitySaysWhetherItsVertexColorsAreLinear) {
  const SceneTestFiles files;
  files.write("m.obj", "v 0 0 0 0.5 0.5 0.5\nv 1 0 0 0.5 0.5 0.5\nv 0 1 0 0.5 0.5 0.5\nf 1 2 3\n");
  const auto loaded = load_scene_collecting(
      files.write("s.json", R"({"entities": [{"obj": "m.obj"}, {"obj": "m.obj", "vertex_colors": "linear"},
                                 {"obj": "m.obj", "vertex_colors": "srgb"}]})"));
  ASSERT_EQ(loaded.scene.meshes.size(), 2u) << described(loaded, files);
  EXPECT_NEAR(loaded.scene.meshes[0].colors[0].x, 0.21404f, 1e-5f) << "the sRGB transfer function in floats";
  EXPECT_EQ(loaded.scene.meshes[1].colors[0].x, 0.5f);
  EXPECT_EQ(loaded.scene.entities[2].mesh, 0);
}

TEST(SceneFile, WarnsWhereKdMakesATextureBlackUnlessTheSceneFileChangesIt) {
  const SceneTestFiles files;
  write_png(files.path("t.png"), Image8(1, 1, 3));
  files.write("m.mtl", "newmtl a\nKd 0 0 0\nmap_Kd t.png\n");
  files.write("m.obj", "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nusemtl a\nf 1/1 2/1 3/1\n");
  const auto problems = [&](const std::string& more) {
    return described(
        load_scene_collecting(files.write("s.json", R"({"entities": [{"obj": "m.obj"}])" + more + "}")),
        files);
  };
  EXPECT_THAT(problems(""),
              HasSubstr("warning s.json: 1 material (a): map_Kd is multiplied by Kd, which is 0"));
  EXPECT_THAT(problems(R"(, "materials": {"a": {"diffuse": [1, 1, 1]}})"), Not(HasSubstr("multiplied")));
}

TEST(SceneFile, NamesEntitiesOfSeveralMeshesAfterBoth) {
  const SceneTestFiles files;
  files.write("m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\no a\nf 1 2 3\no b\nf 1 2 4\n");
  const auto loaded = load_scene_collecting(files.write("s.json", R"({"entities": [{"obj": "m.obj"}]})"));
  ASSERT_EQ(loaded.scene.entities.size(), 2u);
  EXPECT_EQ(loaded.scene.entities[0].name, "m/a");
  EXPECT_EQ(loaded.scene.entities[1].name, "m/b");
}

TEST(SceneFile, ListsEverythingThatWasRead) {
  const SceneTestFiles files;
  write_png(files.path("t.png"), Image8(1, 1, 3));
  files.write("m.mtl", "newmtl a\nmap_Kd t.png\n");
  files.write("m.obj", "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nusemtl a\nf 1/1 2/1 3/1\n");
  const auto loaded = load_scene_collecting(files.write("s.json", R"({"entities": [{"obj": "m.obj"}]})"));
  EXPECT_EQ(file_paths(loaded.scene),
            (std::vector<std::filesystem::path>{files.path("s.json"), files.path("m.obj"),
                                                files.path("m.mtl"), files.path("t.png")}));
}

TEST(SceneFile, ResolvesVariables) {
  const SceneTestFiles files;
  files.write("models/m.obj", kSquareObj);
  ::setenv("LIGHTBENCH_TEST_MODELS", files.path("models").c_str(), 1);
  const auto loaded = load_scene_collecting(
      files.write("s.json", R"({"entities": [{"obj": "${LIGHTBENCH_TEST_MODELS}/m.obj"}]})"));
  ::unsetenv("LIGHTBENCH_TEST_MODELS");
  EXPECT_EQ(triangle_count(loaded.scene), 2u);
}

TEST(SceneFile, AnUnsetVariableIsAnErrorOfItsKey) {
  const SceneTestFiles files;
  const auto loaded = load_scene_collecting(
      files.write("s.json", R"({"entities": [{"obj": "${LIGHTBENCH_UNSET_X}/m.obj"}]})"));
  EXPECT_THAT(described(loaded, files),
              AllOf(HasSubstr("error s.json: $.entities[0].obj"), HasSubstr("LIGHTBENCH_UNSET_X")));
}

TEST(SceneFile, MakesBoxesWithTheirMaterial) {
  const SceneTestFiles files;
  const auto loaded = load_scene_collecting(
      files.write("s.json", R"({"entities": [{"name": "wall", "box": {"min": [0, 0, 0], "max": [1, 2, 3]},
                   "material": {"diffuse": [0.1, 0.2, 0.3], "specular": 0.5, "exponent": 9,
                                "emission": [1, 2, 3], "reflectance": 0.25}}]})"));
  EXPECT_EQ(error_count(loaded), 0u) << described(loaded, files);
  EXPECT_EQ(world_bounds(loaded.scene).max, glm::vec3(1, 2, 3));
  const Material& m = loaded.scene.materials.at(0);
  EXPECT_EQ(m.name, "wall");
  EXPECT_EQ(m.diffuse, glm::vec3(0.1f, 0.2f, 0.3f));
  EXPECT_EQ(m.specular, 0.5f);
  EXPECT_EQ(m.exponent, 9.0f);
  EXPECT_EQ(m.emission, glm::vec3(1, 2, 3));
  EXPECT_EQ(m.reflectance, 0.25f);
}

LoadedScene load_overridden(const SceneTestFiles& files, const std::string& overrides) {
  files.write("m.mtl", "newmtl wood1\nKd 1 1 1\nnewmtl wood2\nKd 1 1 1\nnewmtl a*b\nnewmtl spare\n");
  files.write("m.obj",
              "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
              "usemtl wood1\nf 1 2 3\nusemtl wood2\nf 1 2 4\nusemtl a*b\nf 1 3 4\n");
  return load_scene_collecting(files.write(
      "s.json",
      R"({"entities": [{"obj": "m.obj"}], "lights": [{"type": "directional", "direction": [0, -1, 0]}],
                   "materials": )" +
          overrides + "}"));
}

TEST(SceneFile, OverridesMaterialsByName) {
  const SceneTestFiles files;
  const auto loaded = load_overridden(files, R"({"wood1": {"emission": [5, 5, 5]}})");
  EXPECT_EQ(loaded.scene.materials[0].emission, glm::vec3(5));
  EXPECT_EQ(loaded.scene.materials[0].diffuse, glm::vec3(1)) << "what is not named stays";
  EXPECT_EQ(loaded.scene.materials[1].emission, glm::vec3(0));
}

TEST(SceneFile, OverridesMaterialsByPattern) {
  const SceneTestFiles files;
  const auto loaded = load_overridden(files, R"({"wood?": {"specular": 0.5}, "a*b": {"reflectance": 0.5}})");
  EXPECT_EQ(loaded.scene.materials[0].specular, 0.5f);
  EXPECT_EQ(loaded.scene.materials[1].specular, 0.5f);
  EXPECT_EQ(loaded.scene.materials[2].reflectance, 0.5f) << "a name with a star in it is a name first";
}

TEST(SceneFile, AnOverrideOfNothingIsAProblem) {
  const SceneTestFiles files;
  const auto loaded = load_overridden(
      files,
      R"({"wod1": {"specular": 0}, "x*": {"specular": 0}, "spare": {"specular": 0}, "wood1": {"specula": 0}})");
  EXPECT_THAT(
      described(loaded, files),
      AllOf(HasSubstr(
                "error s.json: $.materials.wod1: no model has the material 'wod1' (did you mean 'wood1'?)"),
            HasSubstr("warning s.json: $.materials[\"x*\"]: no material matches 'x*'"),
            HasSubstr("note s.json: $.materials.spare: no face has the material 'spare'"),
            HasSubstr("error s.json: $.materials.wood1: unknown key 'specula' (did you mean 'specular'?)")));
}

TEST(SceneFile, ReadsAllKindsOfLights) {
  const SceneTestFiles files;
  const auto loaded = load_square(files, R"(, "lights": [
      {"name": "p", "type": "point", "position": [1, 2, 3], "color": [0.5, 1, 2], "power": 3,
       "attenuation": {"type": "fade", "distance": 4, "power": 1.5}},
      {"type": "directional", "direction": [0, -2, 0]},
      {"type": "spot", "position": [0, 5, 0], "look_at": [0, 0, 5], "inner": 20, "outer": 30,
       "attenuation": {"type": "radius", "radius": 20}},
      {"type": "area", "position": [0, 3, 0], "edge_u": [1, 0, 0], "edge_v": [0, 0, 2],
       "points": [3, 64], "attenuation": {"type": "inverse_square"}},
      {"type": "area", "triangle": [[1, 2, 3], [2, 2, 3], [1, 2, 5]], "points": 6},
      {"type": "area", "triangle": [[1, 2, 3], [2, 2, 3], [1, 2, 5]], "emitter": "points"}]
      // a comment
      , "background": {"color": [0.1, 0.2, 0.3], "lights": false}, "near": 0.5, "far": 50)");
  EXPECT_EQ(error_count(loaded), 0u) << described(loaded, files);
  const auto& lights = loaded.scene.lights;
  ASSERT_EQ(lights.size(), 6u);
  EXPECT_EQ(lights[0].name, "p");
  EXPECT_EQ(lights[0].color, glm::vec3(0.5f, 1, 2));
  EXPECT_EQ(lights[0].power, 3.0f);
  EXPECT_EQ(lights[0].attenuation.kind, Attenuation::Kind::fade);
  EXPECT_EQ(lights[0].attenuation.distance, 4.0f);
  EXPECT_EQ(lights[0].attenuation.power, 1.5f);
  EXPECT_EQ(lights[1].kind, LightKind::directional);
  EXPECT_EQ(lights[1].direction, glm::vec3(0, -1, 0));
  EXPECT_EQ(lights[2].kind, LightKind::spot);
  EXPECT_LT(glm::length(lights[2].direction - glm::normalize(glm::vec3(0, -1, 1))), 1e-6f);
  EXPECT_FLOAT_EQ(lights[2].inner_angle, glm::radians(20.0f));
  EXPECT_FLOAT_EQ(lights[2].outer_angle, glm::radians(30.0f));
  EXPECT_EQ(lights[2].attenuation.radius, 20.0f);
  EXPECT_EQ(lights[3].kind, LightKind::area);
  EXPECT_EQ(lights[3].edge_v, glm::vec3(0, 0, 2));
  EXPECT_EQ(lights[3].points, glm::ivec2(3, 64));
  EXPECT_EQ(lights[3].attenuation.kind, Attenuation::Kind::inverse_square);
  EXPECT_EQ(lights[4].shape, AreaShape::triangle);
  EXPECT_EQ(lights[4].position, glm::vec3(1, 2, 3));
  EXPECT_EQ(lights[4].edge_u, glm::vec3(1, 0, 0));
  EXPECT_EQ(lights[4].edge_v, glm::vec3(0, 0, 2));
  EXPECT_EQ(lights[4].points.x, 6);
  EXPECT_EQ(lights[5].points.x, 4);
  EXPECT_EQ(loaded.scene.background.color, glm::vec3(0.1f, 0.2f, 0.3f));
  EXPECT_FALSE(loaded.scene.background.lights);
  EXPECT_EQ(loaded.scene.near, 0.5f);
  EXPECT_EQ(loaded.scene.far, 50.0f);
}

TEST(SceneFile, ALambertEmitterIsASurfaceOfTheScene) {
  const SceneTestFiles files;
  const auto loaded = load_square(files, R"(, "lights": [
      {"type": "area", "name": "panel", "position": [0, 9, 0], "edge_u": [2, 0, 0], "edge_v": [0, 0, 4],
       "color": [1, 0.5, 0], "power": 3, "emitter": "lambert"}])");
  EXPECT_EQ(error_count(loaded), 0u) << described(loaded, files);
  EXPECT_THAT(loaded.scene.lights, testing::IsEmpty());
  const Entity& entity = loaded.scene.entities.back();
  const Mesh& mesh = loaded.scene.meshes[std::size_t(entity.mesh)];
  EXPECT_EQ(entity.name, "panel");
  EXPECT_THAT(mesh.positions, testing::UnorderedElementsAre(glm::vec3(-1, 9, -2), glm::vec3(1, 9, -2),
                                                            glm::vec3(-1, 9, 2), glm::vec3(1, 9, 2)));
  const Material& material = loaded.scene.materials[std::size_t(mesh.parts[0].material)];
  EXPECT_EQ(material.name, "panel");
  EXPECT_EQ(material.diffuse, glm::vec3(0));
  EXPECT_EQ(material.emission, glm::vec3(3, 1.5f, 0));
}

TEST(SceneFile, ReadsCredits) {
  const SceneTestFiles files;
  const auto loaded = load_square(
      files,
      R"(, "credits": [{"piece": "chair", "creator": "A. B.", "license": "CC-BY-3.0"}, {"piece": "x"}])");
  ASSERT_EQ(loaded.scene.credits.size(), 2u);
  EXPECT_EQ(loaded.scene.credits[0].creator, "A. B.");
}

TEST(BareObj, GetsADefaultLightAndSaysSo) {
  const SceneTestFiles files;
  const auto loaded = load_scene_collecting(files.write("m.OBJ", kSquareObj));
  ASSERT_EQ(loaded.scene.lights.size(), 1u);
  EXPECT_EQ(loaded.scene.lights[0].kind, LightKind::directional);
  EXPECT_NEAR(glm::length(loaded.scene.lights[0].direction), 1.0f, 1e-6f);
  EXPECT_EQ(loaded.scene.background.color, glm::vec3(0.3f));
  EXPECT_THAT(described(loaded, files), HasSubstr("note m.OBJ: a bare OBJ is lit by a default light"));
}

TEST(LoadScene, ThrowsTheFirstError) {
  const SceneTestFiles files;
  const auto file = files.write("m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 4\n");
  try {
    load_scene(file);
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.where(), file.string() + ":5");
  }
}

TEST(LoadScene, KeepsTheWarnings) {
  const SceneTestFiles files;
  const Scene scene = load_scene(files.write("m.obj", std::string(kSquareObj) + "l 1 2\n"));
  ASSERT_EQ(scene.warnings.size(), 1u);
  EXPECT_THAT(scene.warnings[0], HasSubstr("lines and points are not shown"));
}

TEST(LoadScene, LoadsTheProjectsOwnScene) {
  const Scene scene = load_scene(std::filesystem::path(LIGHTBENCH_SOURCE_DIR) / "jobs/scenes/cornell.json");
  EXPECT_TRUE(scene.warnings.empty());
  EXPECT_GE(triangle_count(scene), 30u);
}

}  // namespace
}  // namespace lightbench
