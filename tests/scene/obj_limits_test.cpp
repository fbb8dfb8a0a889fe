#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "base/error.h"
#include "scene/light_points.h"
#include "scene/mtl_loader.h"
#include "scene/obj_parser.h"
#include "scene_test_files.h"

/// Files that would take more time or memory than they are worth.
namespace lightbench {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

std::string error_of(const std::string& text, const ObjLimits& limits) {
  const SceneTestFiles files;
  ProblemList problems;
  try {
    parse_obj(files.write("m.obj", text), problems, limits);
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

TEST(ObjLimits, APolygonHasAMostOfCorners) {
  const ObjLimits limits{.polygon_corners = 4};
  EXPECT_EQ(error_of(std::string(kSquareObj), limits), "no error");
  EXPECT_THAT(error_of(std::string(kSquareObj) + "f 1 2 3 4 1\n", limits),
              HasSubstr("m.obj:6: a face has more than 4 corners"));
}

TEST(ObjLimits, AllFacesTogetherHaveAMostOfCorners) {
  const std::string text = std::string(kSquareObj) + "f 1 2 3\n";
  EXPECT_EQ(error_of(text, {.corners = 7}), "no error");
  EXPECT_THAT(error_of(text, {.corners = 6}),
              HasSubstr("m.obj:6: the file has more than 6 corners of faces"));
}

TEST(ObjLimits, AllFacesTogetherHaveAMostOfTriangles) {
  const std::string text = std::string(kSquareObj) + "f 1 2 3\n";
  EXPECT_EQ(error_of(text, {.triangles = 3}), "no error");
  EXPECT_THAT(error_of(text, {.triangles = 2}), HasSubstr("m.obj:6: the file has more than 2 triangles"));
}

TEST(ObjLimits, VerticesAreCountedByTheirKind) {
  const std::string text = std::string(kSquareObj) + "vt 0 0\nvt 1 1\nvn 0 0 1\nvn 0 0 1\n";
  EXPECT_EQ(error_of(text, {.vertices = 4}), "no error");
  EXPECT_THAT(error_of(text, {.vertices = 3}), HasSubstr("m.obj:4: the file has more than 3 vertices"));
  EXPECT_THAT(error_of("vt 0 0\nvt 1 1\n", {.vertices = 1}),
              HasSubstr("m.obj:2: the file has more than 1 tex"));
  EXPECT_THAT(error_of("vn 0 0 1\nvn 0 0 1\n", {.vertices = 1}),
              HasSubstr("m.obj:2: the file has more than 1 nor"));
}

TEST(ObjLimits, ALineHasAMostOfBytes) {
  EXPECT_THAT(error_of("v 0 0 0\n# " + std::string(100, 'x') + "\n", {.line_bytes = 100}),
              HasSubstr("m.obj:2: the line has 102 bytes, and at most 100 bytes are read"));
  EXPECT_THAT(error_of("v 0 0 0\nf 1 \\\n1 \\\n1 \\\n1\n", {.line_bytes = 10}),
              HasSubstr("m.obj:2: the line has"));
}

TEST(ObjLimits, NamesAreCounted) {
  EXPECT_THAT(error_of("o a\ng b\nusemtl c\nmtllib d\n", {.names = 3}),
              HasSubstr("m.obj:4: the file has more than 3"));
}

TEST(ObjLimits, LibrariesAndSmoothingGroupsAreCounted) {
  EXPECT_THAT(error_of("mtllib a\nmtllib b\n", {.libraries = 1}),
              HasSubstr("m.obj:2: the file has more than 1 statements mtllib"));
  EXPECT_EQ(error_of("s 1\ns 2\ns 1\ns 2\n", {.names = 2}), "no error");
  EXPECT_THAT(error_of("s 1\ns 2\ns 3\n", {.names = 2}),
              HasSubstr("m.obj:3: the file has more than 2 smoothing groups"));
}

TEST(ObjLimits, ANameHasAMostOfBytes) {
  for (const char* keyword : {"o", "g", "usemtl", "mtllib"}) {
    const std::string text = std::string(kSquareObj) + keyword + " " + std::string(10, 'x') + " \n";
    EXPECT_EQ(error_of(text, {.name_bytes = 10}), "no error");
    EXPECT_THAT(error_of(text, {.name_bytes = 9}),
                HasSubstr("m.obj:6: the name has 10 bytes, and at most 9 bytes are read"));
  }
}

TEST(ObjLimits, NoMoreNamesOfShapesAreKeptThanThereAreMeshes) {
  std::string text(kSquareObj);
  for (std::size_t i = 0; i < kMostMeshes + 100; ++i) text += "g " + std::to_string(i) + "\nf 1 2 3\n";
  const SceneTestFiles files;
  ProblemList problems;
  const ObjData data = parse_obj(files.write("m.obj", text), problems);
  EXPECT_EQ(data.shapes.size(), kMostMeshes + 1);
  EXPECT_EQ(data.faces.size(), kMostMeshes + 101);
}

TEST(ObjLimits, AFileHasAMostOfBytes) {
  EXPECT_THAT(error_of(std::string(kSquareObj), {.file_bytes = 10}), HasSubstr("at most 10 bytes are read"));
}

TEST(ObjLimits, AnMtlFileHasAMostOfMaterials) {
  const SceneTestFiles files;
  const auto file = files.write("m.mtl", "newmtl a\nnewmtl b\nnewmtl c\n");
  ProblemList problems;
  EXPECT_EQ(load_mtl(file, problems, 3).size(), 3u);
  EXPECT_THAT([&] { load_mtl(file, problems, 2); },
              ::testing::ThrowsMessage<Error>(HasSubstr("m.mtl:3: the file has more than 2 materials")));
}

TEST(SceneLimits, AFifoInThePlaceOfAnyFileIsAProblem) {
  const SceneTestFiles files;
  for (const char* name : {"fifo.obj", "fifo.mtl", "fifo.json"})
    ASSERT_EQ(::mkfifo(files.path(name).c_str(), 0600), 0);
  files.write("m.obj", "mtllib fifo.mtl\n" + std::string(kSquareObj));
  const auto problems = [&](const std::string& text) {
    return described(load_scene_collecting(files.write("s.json", text)), files);
  };
  EXPECT_THAT(problems(R"({"entities": [{"obj": "fifo.obj"}]})"),
              HasSubstr("error fifo.obj: is not a regular file"));
  EXPECT_THAT(problems(R"({"entities": [{"obj": "m.obj"}]})"),
              HasSubstr("error m.obj:1: the material library 'fifo.mtl' is not a regular file"));
  EXPECT_THAT(described(load_scene_collecting(files.path("fifo.json")), files),
              HasSubstr("error fifo.json: is not a regular file"));
}

TEST(SceneLimits, AModelThatCannotBeReadIsReadOnce) {
  const SceneTestFiles files;
  std::filesystem::create_directory(files.path("m.obj"));
  const auto loaded = load_scene_collecting(
      files.write("s.json", R"({"entities": [{"obj": "m.obj"}, {"obj": "m.obj"}, {"obj": "m.obj"}]})"));
  const std::string text = described(loaded, files);
  const std::string message = "is a folder, not a file";
  ASSERT_THAT(text, HasSubstr(message));
  EXPECT_EQ(text.find(message), text.rfind(message)) << text;
}

TEST(SceneLimits, TheLightsHaveAMostOfPoints) {
  const SceneTestFiles files;
  const std::string light = R"({"type": "area", "position": [0, 0, 9], "edge_u": [1, 0, 0],
                                "edge_v": [0, 1, 0], "points": [64, 64]})";
  const auto problems = [&](int count) {
    std::string list = light;
    for (int i = 1; i < count; ++i) list += ", " + light;
    return described(load_square(files, R"(, "lights": [)" + list + "]"), files);
  };
  ASSERT_LE(24u * 64 * 64, kMostLightPoints);
  EXPECT_THAT(problems(24), Not(HasSubstr("error")));
  const std::string text = problems(30);
  const std::string message = "error s.json: $.lights[24]: the lights have more than 100000 points in all";
  ASSERT_THAT(text, HasSubstr(message));
  EXPECT_EQ(text.find("in all"), text.rfind("in all")) << text;
}

TEST(SceneLimits, TheRestOfAListWithAThousandErrorsIsNotRead) {
  const SceneTestFiles files;
  std::string list = "7";
  for (int i = 0; i < 2000; ++i) list += ", 7";
  const auto loaded = load_scene_collecting(files.write("s.json", R"({"entities": [)" + list + "]}"));
  EXPECT_LT(error_count(loaded), 1100u);
  EXPECT_THAT(described(loaded, files), HasSubstr("$.entities: there are too many errors"));
}

}  // namespace
}  // namespace lightbench
