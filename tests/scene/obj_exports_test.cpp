#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "obj_test_files.h"

/// What exporters write, and other tools read.
namespace lightbench {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr const char* kSquareVertices = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

std::string with_square(const std::string& rest) {
  return kSquareVertices + rest;
}

// A bent quad, front and back, which are cut along different diagonals.
TEST(ObjExports, FacesInOnePlaceAreComparedBeforeTheyAreCut) {
  const std::string vertices = "v 0 0 0\nv 1 0 0\nv 1 1 1\nv 0 1 0\nv 1 1 1\nv 0 1 0\n";
  for (const char* back : {"f 4 3 2 1", "f 2 3 4 1", "f 3 4 1 2", "f 1 6 5 2", "f 3 3 2 1 4 4"}) {
    const auto loaded = load_obj_text(vertices + "f 1 2 3 4\n" + back + "\n");
    EXPECT_EQ(triangle_count(loaded.model), 2u) << back;
    EXPECT_THAT(loaded.problems, HasSubstr("triangles that stand twice are left out")) << back;
  }
  const auto crossed = load_obj_text(vertices + "f 1 2 3 4\nf 1 3 2 4\n");
  EXPECT_GT(triangle_count(crossed.model), 2u) << "the same corners in another order are another face";
}

TEST(ObjExports, OfFacesInOnePlaceTheFirstOneStays) {
  const SceneTestFiles files;
  files.write("m.mtl", "newmtl front\nKd 1 0 0\nnewmtl back\nKd 0 0 1\n");
  files.write("m.obj",
              "mtllib m.mtl\n" + with_square("o a\nusemtl front\nf 1 2 3 4\no b\nusemtl back\nf 4 3 2 1\n"));
  const auto loaded = load_obj_file(files, "m.obj");
  ASSERT_EQ(loaded.model.meshes.size(), 1u);
  EXPECT_EQ(loaded.model.materials[std::size_t(loaded.model.meshes[0].parts[0].material)].name, "front");
}

TEST(ObjExports, APolygonThatTouchesItselfHasItsArea) {
  const auto loaded = load_obj_text("v 0 0 0\nv 1 1 0\nv 2 0 0\nv 2 2 0\nv 1 1 0\nv 0 2 0\nf 1 2 3 4 5 6\n");
  EXPECT_EQ(triangle_count(loaded.model), 2u);
  EXPECT_THAT(loaded.problems, HasSubstr("note m.obj: 2 triangles without area are left out"));
}

TEST(ObjExports, AFaceWhoseEdgesCrossIsCounted) {
  const auto loaded = load_obj_text("v 0 0 0\nv 2 2 0\nv 2 0 0\nv 0 1 0\nv -1 1.5 0\nf 1 2 3 4 5\n");
  EXPECT_THAT(loaded.problems, HasSubstr("note m.obj: 1 faces have edges that cross, seen flat"));
}

// Six walls of a prism with sharp edges, without normals.
std::string prism(const std::string& smoothing) {
  std::string text;
  for (const char* z : {"0", "1"})
    for (const char* xy :
         {"1 0", "0.5 0.8660254", "-0.5 0.8660254", "-1 0", "-0.5 -0.8660254", "0.5 -0.8660254"})
      text += std::string("v ") + xy + " " + z + "\n";
  text += smoothing;
  return text + "f 1 2 8 7\nf 2 3 9 8\nf 3 4 10 9\nf 4 5 11 10\nf 5 6 12 11\nf 6 1 7 12\n";
}

TEST(ObjExports, ASmoothingGroupIsSmoothOverSharpEdges) {
  for (const char* group : {"s 1\n", "s on\n", "S 7 # walls\n"}) {
    const Mesh mesh = load_obj_text(prism(group)).model.meshes.at(0);
    EXPECT_EQ(mesh.positions.size(), 12u);
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
      const glm::vec3 outwards(mesh.positions[i].x, mesh.positions[i].y, 0);
      // The corners are given with seven digits.
      EXPECT_LT(glm::length(mesh.normals[i] - outwards), 1e-6f) << group << i;
    }
  }
}

TEST(ObjExports, SmoothingThatIsOffIsFlat) {
  for (const char* off : {"s off\n", "s 0\n", "s\n", "s OFF\n"})
    for (const float crease : {0.1f, 3.0f})
      EXPECT_EQ(load_obj_text(prism(off), {.crease_angle = crease}).model.meshes.at(0).positions.size(), 24u)
          << off;
}

TEST(ObjExports, WithoutSmoothingGroupsTheCreaseAngleDecides) {
  EXPECT_EQ(load_obj_text(prism(""), {.crease_angle = 0.1f}).model.meshes.at(0).positions.size(), 24u);
  EXPECT_EQ(load_obj_text(prism(""), {.crease_angle = 3.0f}).model.meshes.at(0).positions.size(), 12u);
}

TEST(ObjExports, GivenNormalsCountMoreThanSmoothingGroups) {
  const auto loaded = load_obj_text(with_square("vn 0 1 0\ns 1\nf 1//1 2//1 3//1 4//1\n"));
  for (const glm::vec3& n : loaded.model.meshes.at(0).normals) EXPECT_EQ(n, glm::vec3(0, 1, 0));
}

TEST(ObjExports, NormalsAndTextureCoordinatesThatAreNotThereAreAWarning) {
  for (const char* face : {"f 1/9/9 2/9/9 3/9/9 4/9/9", "f 1/-5/-5 2/-5/-5 3/-5/-5 4/-5/-5",
                           "f 1/0/0 2/0/0 3/0/0 4/0/0", "f 1/99999999999/99999999999 2/9/9 3/9/9 4/9/9"}) {
    const auto loaded = load_obj_text(with_square("vt 0.5 0.5\nvn 1 0 0\n") + face + "\n");
    ASSERT_EQ(triangle_count(loaded.model), 2u) << face;
    EXPECT_EQ(loaded.model.meshes[0].normals[0], glm::vec3(0, 0, 1));
    EXPECT_TRUE(loaded.model.meshes[0].uvs.empty());
    EXPECT_THAT(
        loaded.problems,
        AllOf(Not(HasSubstr("error")),
              HasSubstr("warning m.obj:7: 4 corners of faces name a normal that the file does not have"),
              HasSubstr("warning m.obj:7: 4 corners of faces name a texture coordinate that")));
  }
}

TEST(ObjExports, NormalsMayBeDefinedLater) {
  const auto loaded = load_obj_text(with_square("f 1//1 2//1 3//1 4//1\nvn 0 1 0\n"));
  EXPECT_EQ(loaded.model.meshes.at(0).normals.at(0), glm::vec3(0, 1, 0));
  EXPECT_THAT(loaded.problems, Not(HasSubstr("warning")));
}

TEST(ObjExports, NormalsThatOldCLibrariesPrintAsNanAreComputed) {
  for (const char* normal : {"-1.#IND -1.#IND -1.#IND", "1.#QNAN 0 1", "1.#INF 0 0", "nan nan nan"}) {
    const auto loaded =
        load_obj_text(with_square(std::string("vn ") + normal + " # none\nf 1//1 2//1 3//1 4//1\n"));
    EXPECT_EQ(loaded.model.meshes.at(0).normals.at(0), glm::vec3(0, 0, 1)) << normal;
    EXPECT_THAT(loaded.problems, AllOf(Not(HasSubstr("error")), HasSubstr("or one that is not finite")));
  }
}

TEST(ObjExports, UsemtlWithoutANameIsGreyWithANote) {
  const SceneTestFiles files;
  files.write("m.mtl", "newmtl red\nKd 1 0 0\n");
  files.write("m.obj", "mtllib m.mtl\n" + with_square("usemtl red\nf 1 2 3\nusemtl\nf 1 3 4\n"));
  const auto loaded = load_obj_file(files, "m.obj");
  const auto& parts = loaded.model.meshes.at(0).parts;
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_EQ(loaded.model.materials[std::size_t(parts[0].material)].diffuse, glm::vec3(0.8f));
  EXPECT_EQ(loaded.model.materials[std::size_t(parts[1].material)].diffuse, glm::vec3(1, 0, 0));
  EXPECT_THAT(loaded.problems, HasSubstr("note m.obj:8: usemtl without a name"));
}

TEST(ObjExports, AMissingLibraryIsNamedAloneAndTheOthersAreRead) {
  const SceneTestFiles files;
  files.write("red.mtl", "newmtl red\nKd 1 0 0\n");
  files.write("m.obj", "mtllib gone.mtl red.mtl\n" + with_square("usemtl red\nf 1 2 3 4\n"));
  const auto loaded = load_obj_file(files, "m.obj");
  EXPECT_THAT(loaded.problems, HasSubstr("error m.obj:1: the material library 'gone.mtl' is missing"));
  EXPECT_EQ(loaded.model.materials.at(0).diffuse, glm::vec3(1, 0, 0));
}

TEST(ObjExports, OfAMaterialInTwoLibrariesTheFirstOneCountsWithAWarning) {
  const SceneTestFiles files;
  files.write("a.mtl", "newmtl m\nKd 1 0 0\nnewmtl unused\n");
  files.write("b.mtl", "newmtl unused\nnewmtl m\nKd 0 0 1\n");
  files.write("m.obj",
              "mtllib a.mtl\n" + with_square("usemtl m\nf 1 2 3\nmtllib b.mtl\nusemtl m\nf 1 3 4\n"));
  const auto loaded = load_obj_file(files, "m.obj");
  EXPECT_EQ(
      loaded.problems,
      "warning b.mtl:2: material 'm' stands in 'a.mtl' too, which was read first and counts for all faces\n");
  EXPECT_EQ(loaded.model.materials.at(0).diffuse, glm::vec3(1, 0, 0));
}

TEST(ObjExports, FarTextureCoordinatesKeepTheirFractions) {
  const auto loaded = load_obj_text(with_square(
      "vt 100000.26 -70000.24\nvt 100001.26 -70000.24\nvt 100001.26 -69999.24\nvt 100000.26 -69999.24\n"
      "f 1/1 2/2 3/3 4/4\n"));
  EXPECT_EQ(loaded.model.meshes.at(0).uvs.at(0).x, float(100000.26 - 100000));
  EXPECT_EQ(loaded.model.meshes.at(0).uvs.at(0).y, float(70001 - 70000.24));
  EXPECT_EQ(loaded.model.meshes.at(0).uvs.at(2).x, float(100001.26 - 100000));
}

TEST(ObjExports, NearTextureCoordinatesStayWhereTheyAre) {
  const auto loaded = load_obj_text(with_square("vt 4000.25 0.5\nvt -3 1\nf 1/1 2/2 3/2 4/2\n"));
  EXPECT_EQ(loaded.model.meshes.at(0).uvs.at(0), glm::vec2(4000.25f, 0.5f));
}

TEST(ObjExports, AModelFarFromItsOriginKeepsItsShape) {
  const auto loaded = load_obj_text(
      "v 500000.0 0 5400000.0\nv 500000.1 0 5400000.0\nv 500000.1 0.1 5400000.1\nv 9 9 9\nf 1 2 3\n");
  const Mesh& mesh = loaded.model.meshes.at(0);
  // The coordinates are given with a tenth of a unit, and doubles hold them to a millionth of that.
  EXPECT_NEAR(mesh.positions[1].x - mesh.positions[0].x, 0.1, 1e-6);
  EXPECT_NEAR(mesh.positions[2].z - mesh.positions[0].z, 0.1, 1e-6);
  EXPECT_NEAR(double(mesh.positions[0].x) + loaded.model.origin.x, 500000.0, 1e-6);
  EXPECT_NEAR(double(mesh.positions[0].z) + loaded.model.origin.z, 5400000.0, 1e-6);
}

TEST(ObjExports, AModelNearItsOriginHasItsOwnCoordinates) {
  const auto loaded = load_obj_text("v 30 0 0\nv 31 0 0\nv 30 1 0\nf 1 2 3\n");
  EXPECT_EQ(loaded.model.origin, glm::dvec3(0));
  EXPECT_EQ(loaded.model.meshes.at(0).positions.at(1), glm::vec3(31, 0, 0));
}

TEST(ObjExports, KeywordsMayBeInUpperCase) {
  const auto loaded =
      load_obj_text("V 0 0 0\nV 1 0 0\nV 0 1 0\nVT 0 0\nVN 0 1 0\nG a\nF 1/1/1 2/1/1 3/1/1\n");
  EXPECT_EQ(loaded.model.meshes.at(0).name, "a");
  EXPECT_EQ(loaded.model.meshes.at(0).normals.at(0), glm::vec3(0, 1, 0));
}

TEST(ObjExports, AGroupWithoutANameEndsTheOneBefore) {
  const auto loaded = load_obj_text(with_square("o box\ng lid\nf 1 2 3\ng\nf 1 3 4\n"));
  ASSERT_EQ(loaded.model.meshes.size(), 2u);
  EXPECT_EQ(loaded.model.meshes[0].name, "box");
  EXPECT_EQ(loaded.model.meshes[1].name, "box/lid");
}

TEST(ObjExports, FacesOfOneCornerAreLeftOut) {
  const auto loaded = load_obj_text(with_square("f 1\nf 1 2\nf\nf 1 2 3 4\n"));
  EXPECT_EQ(triangle_count(loaded.model), 2u);
  EXPECT_THAT(loaded.problems, HasSubstr("note m.obj: 3 faces of fewer than 3 corners are left out"));
}

}  // namespace
}  // namespace lightbench
