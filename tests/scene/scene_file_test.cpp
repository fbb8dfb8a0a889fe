#include "scene/scene_file.h"

#include <cmath>
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

// The scene of one square with more keys beside "entities", and more keys in the entity.
LoadedScene load(const SceneTestFiles& files, const std::string& keys, const std::string& entity_keys = "") {
  files.write("m.obj", kSquareObj);
  return load_scene_collecting(files.write(
      "s.json", R"({"entities": [{"name": "e", "obj": "m.obj")" + entity_keys + "}]" + keys + "}"));
}

std::string problems_of(const std::string& keys, const std::string& entity_keys = "") {
  const SceneTestFiles files;
  return described(load(files, keys, entity_keys), files);
}

// Where the square's corner (1, 0, 0), (1, 1, 0) and so on come to be.
glm::vec3 placed(const std::string& entity_keys, const glm::vec3& p) {
  const SceneTestFiles files;
  const LoadedScene loaded = load(files, "", entity_keys);
  EXPECT_EQ(error_count(loaded), 0u) << described(loaded, files);
  return glm::vec3(loaded.scene.entities.at(0).transform * glm::vec4(p, 1));
}

TEST(SceneFile, LoadsEntitiesOfObjFiles) {
  const SceneTestFiles files;
  const LoadedScene loaded = load(files, R"(, "name": "test")");
  EXPECT_EQ(loaded.scene.name, "test");
  ASSERT_EQ(loaded.scene.entities.size(), 1u);
  EXPECT_EQ(loaded.scene.entities[0].name, "e");
  EXPECT_EQ(loaded.scene.entities[0].transform, glm::mat4(1));
  EXPECT_EQ(triangle_count(loaded.scene), 2u);
}

TEST(SceneFile, TakesItsNameFromTheFileWhereItHasNone) {
  const SceneTestFiles files;
  EXPECT_EQ(load(files, "").scene.name, "s");
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
  EXPECT_EQ(loaded.scene.files,
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

TEST(SceneFile, TurnsZUpModels) {
  EXPECT_EQ(placed(R"(, "up": "z")", {1, 2, 3}), glm::vec3(1, 3, -2));
}

TEST(SceneFile, ScalesThenRotatesAboutXYZThenTranslates) {
  EXPECT_EQ(placed(R"(, "transform": {"scale": 2})", {1, 1, 1}), glm::vec3(2, 2, 2));
  EXPECT_EQ(placed(R"(, "transform": {"rotate": [90, 0, 0]})", {0, 1, 0}), glm::vec3(0, 0, 1));
  EXPECT_EQ(placed(R"(, "transform": {"rotate": [0, 90, 0]})", {1, 0, 0}), glm::vec3(0, 0, -1));
  EXPECT_EQ(placed(R"(, "transform": {"rotate": [0, 0, 90]})", {1, 0, 0}), glm::vec3(0, 1, 0));
  EXPECT_EQ(placed(R"(, "transform": {"translate": [10, 0, 0], "rotate": [90, 90, 0], "scale": [1, 2, 1]})",
                   {0, 1, 0}),
            glm::vec3(12, 0, 0));
}

TEST(SceneFile, ReadsMatricesRowByRow) {
  EXPECT_EQ(placed(R"(, "transform": {"matrix": [0,-1,0,5, 1,0,0,6, 0,0,1,7, 0,0,0,1]})", {1, 0, 0}),
            glm::vec3(5, 7, 7));
}

TEST(SceneFile, FitsAModelIntoASizeOnItsFootprint) {
  // The unit square, z-up, lies on the ground: its extent in y is 0 and stays so.
  const std::string keys = R"(, "up": "z", "size": [4, 1, 6], "transform": {"translate": [100, 5, 0]})";
  EXPECT_EQ(placed(keys, {0, 0, 0}), glm::vec3(98, 5, 3));
  EXPECT_EQ(placed(keys, {1, 1, 0}), glm::vec3(102, 5, -3));
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
  const auto loaded = load(files, R"(, "lights": [
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
  const auto loaded = load(files, R"(, "lights": [
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
  const auto loaded = load(
      files,
      R"(, "credits": [{"piece": "chair", "creator": "A. B.", "license": "CC-BY-3.0"}, {"piece": "x"}])");
  ASSERT_EQ(loaded.scene.credits.size(), 2u);
  EXPECT_EQ(loaded.scene.credits[0].creator, "A. B.");
}

TEST(SceneFile, ListsEveryProblemAtOnce) {
  const SceneTestFiles files;
  const auto loaded = load_scene_collecting(files.write("s.json", R"({
      "entitys": [], "nmae": "x", "near": -1, "background": {"color": [1, 2], "light": true},
      "entities": [{"obj": "gone.obj"}, {"obj": "bad.obj", "transform": {"scale": 0}, "upp": "z"}, {}, 7,
                   {"box": {"min": [0, 0, 0], "max": [1, 0, 1]}}],
      "lights": [{"type": "pint"}, {"type": "point"}, {"type": "spot", "position": [0, 0, 0], "outer": 120, "direction": [0, 0, 0]}]})"));
  const std::string text = described(loaded, files);
  for (const char* part :
       {"$: unknown key 'entitys'", "$: unknown key 'nmae' (did you mean 'name'?)", "$.near: must be",
        "$.background.color: must be a list of 3",
        "$.background: unknown key 'light' (did you mean 'lights'?)", "$.entities[0].obj: there is no file",
        "$.entities[1].transform: the transform is singular",
        "$.entities[1]: unknown key 'upp' (did you mean 'up'?)",
        "$.entities[2]: an entity needs either 'obj' or 'box'", "$.entities[3]: must be an object",
        "$.entities[4].box: the box is empty",
        "$.lights[0].type: must be one of point, directional, spot, area, not 'pint' (did you mean 'point'?)",
        "$.lights[1]: the key 'position' is missing", "$.lights[2].outer: must be between",
        "$.lights[2].direction: a direction must not be zero"})
    EXPECT_THAT(text, HasSubstr(std::string("error s.json: ") + part));
}

struct BadScene {
  const char* name;
  const char* keys;         ///< of the scene
  const char* entity_keys;  ///< of its entity
  const char* problem;
};

void PrintTo(const BadScene& bad, std::ostream* stream) {
  *stream << bad.name;
}

class SceneFileBadInput : public ::testing::TestWithParam<BadScene> {};

TEST_P(SceneFileBadInput, IsListedWithItsPath) {
  EXPECT_THAT(problems_of(GetParam().keys, GetParam().entity_keys), HasSubstr(GetParam().problem));
}

constexpr const char* kSun = R"(, "lights": [{"type": "directional", "direction": [0, -1, 0]}])";

INSTANTIATE_TEST_SUITE_P(
    Keys, SceneFileBadInput,
    ::testing::Values(
        BadScene{"NearBehindFar", R"(, "near": 5, "far": 2)", "",
                 "error s.json: $.far: far must be larger than near"},
        BadScene{"ZeroPower", R"(, "lights": [{"type": "point", "position": [9, 9, 9], "power": 0}])", "",
                 "warning s.json: $.lights[0]: the light 'point' gives no light"},
        BadScene{"NegativePower", R"(, "lights": [{"type": "point", "position": [9, 9, 9], "power": -1}])",
                 "", "error s.json: $.lights[0].power: must be between"},
        BadScene{"NegativeColor",
                 R"(, "lights": [{"type": "point", "position": [9, 9, 9], "color": [1, -1, 0]}])", "",
                 "error s.json: $.lights[0].color: a colour must lie"},
        BadScene{
            "SpotWithTwoAims",
            R"(, "lights": [{"type": "spot", "position": [9, 9, 9], "outer": 9, "direction": [0, 1, 0], "look_at": [0, 0, 0]}])",
            "", "$.lights[0]: a spotlight needs either"},
        BadScene{
            "SpotInnerWiderThanOuter",
            R"(, "lights": [{"type": "spot", "position": [9, 9, 9], "outer": 9, "inner": 10, "direction": [0, 1, 0]}])",
            "", "$.lights[0].inner: the inner angle is larger"},
        BadScene{
            "AreaWithoutArea",
            R"(, "lights": [{"type": "area", "position": [9, 9, 9], "edge_u": [1, 0, 0], "edge_v": [2, 0, 0]}])",
            "", "$.lights[0].edge_v: the area light has no area"},
        BadScene{"TriangleWithoutArea",
                 R"(, "lights": [{"type": "area", "triangle": [[0, 9, 0], [1, 9, 0], [2, 9, 0]]}])", "",
                 "$.lights[0].triangle: the area light has no area"},
        BadScene{"TwoCorners", R"(, "lights": [{"type": "area", "triangle": [[0, 9, 0], [1, 9, 0]]}])", "",
                 "$.lights[0].triangle: must be three corners"},
        BadScene{
            "TriangleWithAPlace",
            R"(, "lights": [{"type": "area", "triangle": [[0, 9, 0], [1, 9, 0], [2, 9, 1]], "position": [0, 0, 0]}])",
            "", "$.lights[0]: unknown key 'position'"},
        BadScene{
            "TooManyPoints",
            R"(, "lights": [{"type": "area", "triangle": [[0, 9, 0], [1, 9, 0], [2, 9, 1]], "points": 65}])",
            "", "$.lights[0].points: must be"},
        BadScene{
            "OneCountForAQuad",
            R"(, "lights": [{"type": "area", "position": [9, 9, 9], "edge_u": [1, 0, 0], "edge_v": [0, 0, 2], "points": [4]}])",
            "", "$.lights[0].points: must be two numbers"},
        BadScene{
            "PointsOfASurface",
            R"(, "lights": [{"type": "area", "triangle": [[0, 9, 0], [1, 9, 0], [2, 9, 1]], "points": 3, "emitter": "lambert"}])",
            "", "$.lights[0]: an emitter 'lambert' is a surface: it has no 'points'"},
        BadScene{
            "AttenuationOfASurface",
            R"(, "lights": [{"type": "area", "triangle": [[0, 9, 0], [1, 9, 0], [2, 9, 1]], "attenuation": {"type": "none"}, "emitter": "lambert"}])",
            "", "$.lights[0]: an emitter 'lambert' is a surface: it has no 'attenuation'"},
        BadScene{
            "AnEmitterOfAnotherKind",
            R"(, "lights": [{"type": "area", "triangle": [[0, 9, 0], [1, 9, 0], [2, 9, 1]], "emitter": "lambrt"}])",
            "", "$.lights[0].emitter: must be one of points, lambert, not 'lambrt'"},
        BadScene{
            "ASurface",
            R"(, "lights": [{"type": "area", "triangle": [[0, 9, 0], [1, 9, 0], [2, 9, 1]], "emitter": "lambert"}])",
            "", "warning s.json: $.lights[0]: light 'area' is an emitting surface: only indirect light"},
        BadScene{
            "AttenuationOfASun",
            R"(, "lights": [{"type": "directional", "direction": [0, -1, 0], "attenuation": {"type": "none"}}])",
            "", "$.lights[0]: unknown key 'attenuation'"},
        BadScene{"FadeWithoutDistance",
                 R"(, "lights": [{"type": "point", "position": [9, 9, 9], "attenuation": {"type": "fade"}}])",
                 "", "$.lights[0].attenuation: the key 'distance' is missing"},
        BadScene{"LightInASurface", R"(, "lights": [{"type": "point", "position": [0.5, 0.5, 0]}])", "",
                 "warning s.json: the light 'point' lies in a surface"},
        BadScene{
            "LightOutOfReach",
            R"(, "lights": [{"type": "point", "position": [9, 9, 9], "attenuation": {"type": "radius", "radius": 2}}])",
            "", "warning s.json: the light 'point' reaches nothing"},
        BadScene{"NoLight", "", "", "warning s.json: the scene has no lights: all of it is black"},
        BadScene{"OnlyBackground", R"(, "background": {"color": [1, 1, 1]})", "",
                 "warning s.json: the scene has no lights; only emission and the background"},
        BadScene{"SingularScale", kSun, R"(, "transform": {"scale": [1, 0, 1]})",
                 "$.entities[0].transform: the transform is singular"},
        BadScene{"SingularMatrix", kSun, R"(, "transform": {"matrix": [1,0,0,0, 1,0,0,0, 0,0,1,0, 0,0,0,1]})",
                 "$.entities[0].transform: the transform is singular"},
        BadScene{"ProjectiveMatrix", kSun,
                 R"(, "transform": {"matrix": [1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,1,1]})",
                 "$.entities[0].transform.matrix: the last row"},
        BadScene{"MatrixAndScale", kSun,
                 R"(, "transform": {"matrix": [1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1], "scale": 2})",
                 "$.entities[0].transform: 'matrix' stands alone"},
        BadScene{"UnknownUp", kSun, R"(, "up": "x")", "$.entities[0].up: must be one of y, z, not 'x'"},
        BadScene{"SizeOfZero", kSun, R"(, "size": [1, 0, 1])",
                 "$.entities[0].size: a size must be larger than 0"},
        BadScene{"HugeCoordinate", kSun, R"(, "transform": {"translate": [1e300, 0, 0]})",
                 "$.entities[0].transform.translate: 1e+300 is too large"},
        BadScene{"MaterialOfAnObj", kSun, R"(, "material": {"diffuse": [1, 1, 1]})",
                 "$.entities[0]: unknown key 'material'"},
        BadScene{"OverbrightMaterial", R"(, "materials": {"default": {"diffuse": [2, 2, 2]}})", "",
                 "1 material (default): a diffuse colour above 1"}),
    [](const auto& test) { return test.param.name; });

TEST(SceneFile, AnEmptySceneIsAnError) {
  const SceneTestFiles files;
  const auto loaded = load_scene_collecting(files.write("s.json", R"({"entities": []})"));
  EXPECT_THAT(described(loaded, files), HasSubstr("error s.json: the scene is empty"));
}

TEST(SceneFile, BrokenJsonIsAnErrorWithItsLine) {
  const SceneTestFiles files;
  const auto loaded = load_scene_collecting(files.write("s.json", "{\n\"entities\": [\n"));
  EXPECT_THAT(described(loaded, files), HasSubstr("error s.json:3: "));
}

TEST(SceneFile, AMissingFileIsAnError) {
  EXPECT_EQ(error_count(load_scene_collecting("/nowhere/s.json")), 1u);
  EXPECT_EQ(error_count(load_scene_collecting("/nowhere/m.obj")), 1u);
  EXPECT_EQ(error_count(load_scene_collecting("/nowhere/m.fbx")), 1u);
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

TEST(SceneFile, AnEntityWithKeyframesStandsWhereItIsAtTimeZero) {
  const std::string keys = R"(, "transform": {"scale": 2}, "keyframes": [
      {"time": -1, "translate": [0, 0, 0]}, {"time": 1, "translate": [6, 0, 0]}])";
  EXPECT_EQ(placed(keys, {1, 0, 0}), glm::vec3(3 + 2, 0, 0));
}

TEST(SceneFile, ABoxMovesToo) {
  const SceneTestFiles files;
  const LoadedScene loaded = load_scene_collecting(
      files.write("s.json", R"({"entities": [{"box": {"min": [0, 0, 0], "max": [1, 1, 1]},
                                  "keyframes": [{"time": 0}, {"time": 1, "rotate": [0, 90, 0], "scale": 2}]}]})"));
  ASSERT_EQ(error_count(loaded), 0u) << described(loaded, files);
  ASSERT_EQ(loaded.scene.entities[0].motion.keys.size(), 2u);
  EXPECT_EQ(loaded.scene.entities[0].motion.keys[1].scale, glm::dvec3(2));
}

TEST(SceneFile, KeyframesThatDoNotRiseAreAProblemOfTheirPlace) {
  EXPECT_THAT(problems_of("", R"(, "keyframes": [{"time": 2}, {"time": 1}])"),
              HasSubstr("error s.json: $.entities[0].keyframes[1].time: the times of keyframes must rise"));
}

TEST(SceneFile, KeyframesThatFlattenTheModelAreAProblem) {
  EXPECT_THAT(problems_of("", R"(, "keyframes": [{"time": 0, "scale": [1, 0, 1]}, {"time": 1}])"),
              HasSubstr("$.entities[0].keyframes[0]: a scale of 0"));
  EXPECT_THAT(problems_of("", R"(, "keyframes": [{"time": 0}, {"time": 1, "scale": [1, -1, 1]}])"),
              HasSubstr("$.entities[0].keyframes[1]: the scale changes its sign"));
}

TEST(SceneFile, AnUnknownKeyOfAKeyframeIsAProblem) {
  EXPECT_THAT(problems_of("", R"(, "keyframes": [{"time": 0}, {"time": 1, "rotates": [0, 0, 0]}])"),
              HasSubstr("did you mean 'rotate'"));
}

}  // namespace
}  // namespace lightbench
