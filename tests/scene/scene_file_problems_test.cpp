#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scene/scene_file.h"
#include "scene_test_files.h"

/// What is wrong with a scene file, and where.
namespace lightbench {
namespace {

using ::testing::HasSubstr;

std::string problems_of(const std::string& keys, const std::string& entity_keys = "") {
  const SceneTestFiles files;
  return described(load_square(files, keys, entity_keys), files);
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
        BadScene{"HugeScale", kSun, R"(, "transform": {"scale": 1e100})",
                 "$.entities[0].transform.scale: must be between"},
        BadScene{"SizeAndScaleBeyondFloats", kSun,
                 R"(, "size": [1e15, 1e15, 1e15], "transform": {"scale": 1e15})",
                 "error s.json: entity 'e' is made too large or too small for 32-bit floats"},
        BadScene{"SizeAndScaleBelowFloats", kSun,
                 R"(, "size": [1e-15, 1e-15, 1e-15], "transform": {"scale": 1e-12})",
                 "error s.json: entity 'e' is made too large or too small for 32-bit floats"},
        BadScene{"KeyframeBeyondFloats", kSun,
                 R"(, "transform": {"scale": 1e12}, "keyframes": [{"time": 0}, {"time": 1, "scale": 1e12}])",
                 "error s.json: entity 'e' is made too large or too small for 32-bit floats"},
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

TEST(SceneFile, WarnsOfManyShadowMaps) {
  const auto problems = [](const std::string& points) {
    return problems_of(R"(, "lights": [{"type": "area", "position": [0, 0, 9], "edge_u": [1, 0, 0],
                           "edge_v": [0, 1, 0], "points": )" +
                       points + "}]");
  };
  EXPECT_THAT(problems("[64, 64]"),
              HasSubstr("warning s.json: the lights have 4096 points: where OpenGL draws"));
  EXPECT_THAT(problems("[16, 16]"), ::testing::Not(HasSubstr("points")));
}

TEST(SceneFile, ManyLightsWithOneFaultAreListedInShort) {
  std::string lights;
  for (int i = 0; i < 100; ++i) lights += R"({"type": "point", "position": [0.5, 0.5, 0]}, )";
  lights += R"({"type": "directional", "direction": [0, 0, -1]})";
  EXPECT_THAT(problems_of(R"(, "lights": [)" + lights + "]"),
              HasSubstr("warning s.json: 95 more lights that lie in a surface\n"));
}

TEST(SceneFile, ManyEntitiesWithOneFaultAreListedInShort) {
  const SceneTestFiles files;
  files.write("m.obj", kSquareObj);
  const std::string huge = R"({"obj": "m.obj", "transform": {"scale": 1e15}, "size": [1e15, 1e15, 1]})";
  std::string entities = huge;
  for (int i = 1; i < 100; ++i) entities += ", " + huge;
  EXPECT_THAT(
      described(load_scene_collecting(files.write("s.json", R"({"entities": [)" + entities + "]}")), files),
      HasSubstr("error s.json: 95 more entities that are made too large or too small"));
}

}  // namespace
}  // namespace lightbench
