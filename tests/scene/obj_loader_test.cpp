#include "scene/obj_loader.h"

#include <cmath>

#include <glm/geometric.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "obj_test_files.h"

namespace lightbench {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

TEST(ObjLoader, ReadsASquare) {
  const auto [model, textures, problems] = load_obj_text(kSquareObj);
  ASSERT_EQ(model.meshes.size(), 1u);
  const Mesh& mesh = model.meshes[0];
  EXPECT_EQ(mesh.triangles, (std::vector<glm::uvec3>{{0, 1, 2}, {0, 2, 3}}));
  EXPECT_EQ(mesh.positions.size(), 4u);
  for (const glm::vec3& n : mesh.normals) EXPECT_EQ(n, glm::vec3(0, 0, 1));
  EXPECT_TRUE(mesh.uvs.empty());
  EXPECT_TRUE(mesh.colors.empty());
}

TEST(ObjLoader, GivesFacesWithoutAMaterialAGreyOneAndSaysSo) {
  const auto [model, textures, problems] = load_obj_text(kSquareObj);
  ASSERT_EQ(model.materials.size(), 1u);
  EXPECT_EQ(model.materials[0].diffuse, glm::vec3(0.8f));
  EXPECT_THAT(problems, HasSubstr("note m.obj: faces without a material"));
}

TEST(ObjLoader, MakesAMeshOfEachObjectAndGroup) {
  const auto loaded = load_obj_text(
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
      "o table top\nf 1 2 3\ng leg\nf 1 2 4\no table top\nf 1 3 4\n");
  ASSERT_EQ(loaded.model.meshes.size(), 2u);
  EXPECT_EQ(loaded.model.meshes[0].name, "table top");
  EXPECT_EQ(loaded.model.meshes[0].triangles.size(), 2u)
      << "an object that is taken up again is the same object";
  EXPECT_EQ(loaded.model.meshes[1].name, "table top/leg");
}

TEST(ObjLoader, MergesObjectsWhereThereAreTooMany) {
  std::string text = "v 0 0 0\nv 1 0 0\n";
  for (std::size_t i = 0; i <= kMostMeshes; ++i)
    text += "o " + std::to_string(i) + "\nv 0 " + std::to_string(i + 1) + " 0\nf 1 2 -1\n";
  const auto loaded = load_obj_text(text);
  ASSERT_EQ(loaded.model.meshes.size(), 1u);
  EXPECT_EQ(loaded.model.meshes[0].triangles.size(), kMostMeshes + 1);
}

TEST(ObjLoader, ResolvesRelativeIndices) {
  const auto loaded = load_obj_text("v 9 9 9\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 5 0 0\nf -1 2 4\n");
  EXPECT_EQ(triangle_count(loaded.model), 2u);
  EXPECT_EQ(loaded.model.meshes[0].positions[0], glm::vec3(0, 0, 0));
}

TEST(ObjLoader, AcceptsVerticesThatAreDefinedLater) {
  const auto loaded = load_obj_text("f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\n");
  EXPECT_EQ(triangle_count(loaded.model), 1u);
  EXPECT_THAT(loaded.problems, Not(HasSubstr("error")));
}

TEST(ObjLoader, TriangulatesConcavePolygons) {
  const auto loaded = load_obj_text("v 0 0 0\nv 2 1 0\nv 0 2 0\nv 0.5 1 0\nf 1 2 3 4\n");
  const Mesh& mesh = loaded.model.meshes[0];
  float area = 0;
  for (const glm::uvec3& t : mesh.triangles)
    area +=
        0.5f *
        glm::cross(mesh.positions[t.y] - mesh.positions[t.x], mesh.positions[t.z] - mesh.positions[t.x]).z;
  EXPECT_FLOAT_EQ(area, 1.5f);
}

TEST(ObjLoader, KeepsGivenNormalsAtUnitLength) {
  const auto loaded = load_obj_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 3 4\nf 1//1 2//1 3//1\n");
  for (const glm::vec3& n : loaded.model.meshes[0].normals)
    EXPECT_LT(glm::length(n - glm::vec3(0, 0.6f, 0.8f)), 1e-6f);
}

TEST(ObjLoader, ComputesNormalsThatAreZeroOrNan) {
  const auto loaded = load_obj_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 0\nvn nan 0 1\nf 1//1 2//2 3//1\n");
  for (const glm::vec3& n : loaded.model.meshes[0].normals) EXPECT_EQ(n, glm::vec3(0, 0, 1));
  EXPECT_THAT(loaded.problems, HasSubstr("3 corners have a normal of zero length"));
}

// A roof of two faces whose edge has vertices of its own on either side, as exporters write it.
constexpr std::string_view kSplitRoof =
    "v 0 0 0\nv 0 1 0\nv -1 0 0\n"
    "v 0 0 0\nv 0 1 0\nv 1 0 -0.5\n"
    "f 1 2 3\nf 4 6 5\n";

TEST(ObjLoader, SmoothsAcrossVerticesOfOnePosition) {
  const auto loaded = load_obj_text(kSplitRoof);
  const Mesh& mesh = loaded.model.meshes[0];
  EXPECT_EQ(mesh.normals[mesh.triangles[0].x], mesh.normals[mesh.triangles[1].x]);
  EXPECT_GT(mesh.normals[mesh.triangles[0].x].x, 0.1f);
}

TEST(ObjLoader, SmoothsAcrossMaterialsAndObjects) {
  std::string text(kSplitRoof);
  text.insert(text.find("f 4"), "o other\n");
  const auto loaded = load_obj_text(text);
  ASSERT_EQ(loaded.model.meshes.size(), 2u);
  EXPECT_EQ(loaded.model.meshes[0].normals[0], loaded.model.meshes[1].normals[0]);
}

TEST(ObjLoader, KeepsCreases) {
  const auto loaded = load_obj_text(kSplitRoof, {.crease_angle = 0.2f});
  EXPECT_EQ(loaded.model.meshes[0].normals[0], glm::vec3(0, 0, 1));
}

TEST(ObjLoader, DropsAndCountsDegenerateTriangles) {
  const auto loaded =
      load_obj_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 2 0 0\nv 0 0 0\nf 1 2 3\nf 1 2 4\nf 1 2 2\nf 1 5 3\n");
  EXPECT_EQ(triangle_count(loaded.model), 1u);
  EXPECT_THAT(loaded.problems, HasSubstr("note m.obj: 3 triangles without area are left out"));
}

TEST(ObjLoader, DropsAndCountsTrianglesThatStandTwiceInAnyOrder) {
  const auto loaded =
      load_obj_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 1 0\nf 1 2 3\nf 2 3 1\nf 3 2 1\nf 1 2 4\n");
  EXPECT_EQ(triangle_count(loaded.model), 1u);
  EXPECT_THAT(loaded.problems, HasSubstr("3 triangles that stand twice are left out"));
  EXPECT_EQ(loaded.model.meshes[0].normals[0], glm::vec3(0, 0, 1)) << "the first one stays";
}

TEST(ObjLoader, ReadsVertexColorsAsTheyStandWhereTheyAreLinear) {
  const auto loaded = load_obj_text("v 0 0 0 1 0 0\nv 1 0 0 0 0.5 0\nv 0 1 0\nf 1 2 3\n",
                                    {.vertex_colors = VertexColors::linear});
  EXPECT_EQ(loaded.model.meshes[0].colors, (std::vector<glm::vec3>{{1, 0, 0}, {0, 0.5f, 0}, {1, 1, 1}}));
}

TEST(ObjLoader, DecodesVertexColorsFromSrgb) {
  const auto loaded = load_obj_text("v 0 0 0 0.5 0.5 1\nv 1 0 0 0 0 0\nv 0 1 0\nf 1 2 3\n");
  const auto& colors = loaded.model.meshes[0].colors;
  // ((0.5 + 0.055) / 1.055)^2.4, in floats.
  EXPECT_NEAR(colors[0].x, 0.21404f, 1e-5f);
  EXPECT_EQ(colors[0].z, 1.0f);
  EXPECT_EQ(colors[1], glm::vec3(0));
  EXPECT_EQ(colors[2], glm::vec3(1)) << "a vertex without a colour is white";
}

TEST(ObjLoader, TakesVertexColorsAboveOneAsBytesAndSaysSo) {
  const auto loaded = load_obj_text("v 0 0 0 255 0 0\nv 1 0 0 0 51 0\nv 0 1 0 0 0 0\nf 1 2 3\n",
                                    {.vertex_colors = VertexColors::linear});
  EXPECT_EQ(loaded.model.meshes[0].colors[0], glm::vec3(1, 0, 0));
  EXPECT_FLOAT_EQ(loaded.model.meshes[0].colors[1].y, 0.2f);
  EXPECT_THAT(loaded.problems, HasSubstr("warning m.obj: vertex colours above 2"));
}

TEST(ObjLoader, AVertexWithoutAColorIsWhiteAmongBytesToo) {
  const auto loaded = load_obj_text("v 0 0 0\nv 1 0 0 0 255 0\nv 0 1 0\nf 1 2 3\n");
  EXPECT_EQ(loaded.model.meshes[0].colors, (std::vector<glm::vec3>{{1, 1, 1}, {0, 1, 0}, {1, 1, 1}}));
}

TEST(ObjLoader, AColorALittleAboveOneIsOne) {
  const auto loaded = load_obj_text("v 0 0 0 1.0001 1 0\nv 1 0 0 0 1 0\nv 0 1 0 1 1 1\nf 1 2 3\n");
  EXPECT_EQ(loaded.model.meshes[0].colors[0], glm::vec3(1, 1, 0));
  EXPECT_EQ(loaded.model.meshes[0].colors[1], glm::vec3(0, 1, 0));
}

TEST(ObjLoader, AColorThatIsNotFiniteIsLeftOutAndItsVertexStays) {
  const auto loaded = load_obj_text("v 0 0 0 nan nan nan\nv 1 0 0 1 1 -1.#IND\nv 0 1 0 0 1 0\nf 1 2 3\n");
  EXPECT_EQ(triangle_count(loaded.model), 1u);
  EXPECT_EQ(loaded.model.meshes[0].colors, (std::vector<glm::vec3>{{1, 1, 1}, {1, 1, 1}, {0, 1, 0}}));
  EXPECT_THAT(loaded.problems, HasSubstr("warning m.obj:1: a vertex colour with 'nan' is left out"));
}

TEST(ObjLoader, AThirdTextureCoordinateDoesNotMatter) {
  const auto loaded = load_obj_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0.25 0.75 1.#QNAN\nf 1/1 2/1 3/1\n");
  EXPECT_EQ(loaded.model.meshes[0].uvs[0], glm::vec2(0.25f, 0.75f));
}

TEST(ObjLoader, AFanOfManyVerticesInOnePlaceTakesNoLongerThanOthers) {
  constexpr int kTriangles =
      200'000;  // comparing each corner with all others in its place would take a minute
  std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  for (int i = 0; i < kTriangles; ++i)
    text += "vt 0." + std::to_string(1'000'000 + i) + " 0\nf 1/-1 2/-1 3/-1\n";
  EXPECT_EQ(load_obj_text(text).model.meshes.size(), 1u);
}

TEST(ObjLoader, ReadsTextureCoordinates) {
  const auto loaded =
      load_obj_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0.25 0.5\nvt 2 -1 0\nvt 0.5\nf 1/1 2/2 3/3\n");
  EXPECT_EQ(loaded.model.meshes[0].uvs, (std::vector<glm::vec2>{{0.25f, 0.5f}, {2, -1}, {0.5f, 0}}));
}

TEST(ObjLoader, SplitsVerticesWhereTextureCoordinatesDiffer) {
  const auto loaded =
      load_obj_text("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nf 1/1 2/1 3/1\nf 1/1 3/2 4/1\n");
  EXPECT_EQ(loaded.model.meshes[0].positions.size(), 5u);
}

TEST(ObjLoader, JoinsContinuedLinesAndKeepsLineNumbers) {
  const auto loaded = load_obj_text("v 0 0 0\nv 1 \\\n0 0\nv 0 1 0\nf 1 \\\r\n 2 3\nf 1 2 9\n");
  EXPECT_EQ(triangle_count(loaded.model), 1u);
  EXPECT_THAT(loaded.problems, HasSubstr("error m.obj:7: index out of range: 9//"));
}

TEST(ObjLoader, ReadsFilesWithCrlfTabsAndAByteOrderMark) {
  const auto loaded =
      load_obj_text("\xEF\xBB\xBFv 0 0 0\r\nv\t1\t0\t0\r\n\tv 0 1 0 \r\nf 1/ 2/ 3// # done\r\n");
  EXPECT_EQ(triangle_count(loaded.model), 1u);
  EXPECT_THAT(loaded.problems, Not(HasSubstr("error")));
}

struct BadObj {
  const char* name;
  const char* text;
  const char* problem;
};

void PrintTo(const BadObj& bad, std::ostream* stream) {
  *stream << bad.name;
}

class ObjLoaderBadInput : public ::testing::TestWithParam<BadObj> {};

TEST_P(ObjLoaderBadInput, IsAnErrorWithItsLine) {
  EXPECT_THAT(load_obj_text(GetParam().text).problems, HasSubstr(GetParam().problem));
}

INSTANTIATE_TEST_SUITE_P(
    Files, ObjLoaderBadInput,
    ::testing::Values(
        BadObj{"Empty", "", "error m.obj: has no faces"},
        BadObj{"OnlyVertices", "v 0 0 0\nv 1 0 0\nv 0 1 0\n", "error m.obj: has no faces"},
        BadObj{"OnlyDegenerateFaces", "v 0 0 0\nf 1 1 1\n", "error m.obj: all of its faces are without area"},
        BadObj{"NanVertex", "v 0 0 0\nv nan 0 0\nv 0 1 0\nf 1 2 3\n",
               "error m.obj:2: a vertex has 'nan', which is no finite number"},
        BadObj{"InfiniteVertex", "v 0 0 0\nv 0 1e999 0\nv 0 1 0\nf 1 2 3\n",
               "error m.obj:2: a vertex has '1e999', which is no finite number"},
        BadObj{"NotANumber", "v 0 0 0\nv 1 x 0\nv 0 1 0\nf 1 2 3\n", "error m.obj:2: 'x' is not a number"},
        BadObj{"DecimalCommas", "v 0,5 0 0\n", "error m.obj:1: '0,5' is not a number"},
        BadObj{"ShortVertex", "v 0 0\n", "error m.obj:1: 2 numbers where 3 are needed"},
        BadObj{"IndexTooLarge", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n\nf 1 2 4\n",
               "error m.obj:6: index out of range: 4//"},
        BadObj{"RelativeIndexTooFar", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -1 -2 -4\n",
               "error m.obj:4: index out of range: -4//"},
        BadObj{"IndexZero", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 0 1 2\n", "error m.obj:4: index out of range: 0//"},
        BadObj{"HugeIndex", "v 0 0 0\nf 99999999999 1 1\n", "error m.obj:2: '99999999999' is not a corner"},
        BadObj{"MalformedCorner", "v 0 0 0\nf 1/a 1 1\n", "error m.obj:2: '1/a' is not a corner"},
        BadObj{"CutInAFace", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2",
               "error m.obj:5: a face of 2 corners; the file ends in the middle of this line"},
        BadObj{"CutInAVertex", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nv 1.5 -",
               "error m.obj:5: '-' is not a number; the file ends in the middle"},
        BadObj{"MissingLibrary", "v 0 0 0\nmtllib gone.mtl\n", "error m.obj:2: the material library"}),
    [](const auto& test) { return test.param.name; });

TEST(ObjLoader, AMaterialThatTheLibraryLacksIsGreyWithAWarning) {
  const auto loaded = load_obj_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl gone\nf 1 2 3\n");
  EXPECT_EQ(loaded.model.materials.at(0).diffuse, glm::vec3(0.8f));
  EXPECT_THAT(loaded.problems, HasSubstr("warning m.obj:4: no material library has the material 'gone'"));
}

TEST(ObjLoader, RefusesBinaryFiles) {
  EXPECT_THAT(load_obj_text(std::string_view("v 0 0 0\0\1\2", 10)).problems,
              HasSubstr("error m.obj: is not a text file"));
}

TEST(ObjLoader, ListsTheFirstOfManyErrorsAndCountsTheRest) {
  std::string text = "v 0 0 0\n";
  for (int i = 0; i < 100; ++i) text += "f 1 2 3\n";
  const auto loaded = load_obj_text(text);
  EXPECT_THAT(loaded.problems, HasSubstr("error m.obj:6: index out of range"));
  EXPECT_THAT(loaded.problems, Not(HasSubstr("m.obj:7:")));
  EXPECT_THAT(loaded.problems, HasSubstr("error m.obj: 95 more faces with an index out of range"));
}

TEST(ObjLoader, WarnsAboutWhatIsNoPolygon) {
  const auto loaded =
      load_obj_text(std::string(kSquareObj) + "l 1 2\np 1\nsurf 0 1 0 1 1 2 3\nwhatever 1\nf 1 2\n");
  EXPECT_THAT(loaded.problems, HasSubstr("2 lines and points are not shown"));
  EXPECT_THAT(loaded.problems, HasSubstr("free-form"));
  EXPECT_THAT(loaded.problems, HasSubstr("warning m.obj:9: unknown statement 'whatever'"));
  EXPECT_THAT(loaded.problems, HasSubstr("1 faces of fewer than 3 corners"));
  EXPECT_EQ(triangle_count(loaded.model), 2u);
}

TEST(ObjLoader, AMissingFileIsAnError) {
  ProblemList problems;
  TextureLoader textures(problems);
  EXPECT_THROW(load_obj("/nowhere/m.obj", {}, textures, problems), Error);
}

}  // namespace
}  // namespace lightbench
