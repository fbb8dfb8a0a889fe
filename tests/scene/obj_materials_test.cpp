#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/image_io.h"
#include "obj_material_files.h"

namespace lightbench {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

TEST(ObjMaterials, ReadsColorsHighlightsAndEmission) {
  const SceneTestFiles files;
  const auto loaded =
      load_materials(files, {"a"}, "newmtl a\nKd 0.1 0.2 0.3\nKs 0.5 0.5 0.5\nNs 40\nKe 2 3 4\n");
  const Material& m = loaded.material("a");
  EXPECT_EQ(m.diffuse, glm::vec3(0.1f, 0.2f, 0.3f));
  EXPECT_EQ(m.specular, 0.5f);
  EXPECT_EQ(m.exponent, 40.0f);
  EXPECT_EQ(m.emission, glm::vec3(2, 3, 4));
  EXPECT_EQ(loaded.problems, "");
}

TEST(ObjMaterials, TakesTheMeanOfAColoredHighlightAndWarns) {
  const SceneTestFiles files;
  const auto loaded = load_materials(files, {"a"}, "newmtl a\nKs 0.3 0.6 0.9\n");
  EXPECT_FLOAT_EQ(loaded.material("a").specular, 0.6f);
  EXPECT_THAT(loaded.problems, HasSubstr("the colour of Ks (its mean is used) of 1 material (a)"));
}

TEST(ObjMaterials, AnExponentBelowOneCountsAsOne) {
  const SceneTestFiles files;
  const auto loaded = load_materials(files, {"a", "b"}, "newmtl a\nKs 1 1 1\nNs 0\nnewmtl b\nNs 0\n");
  EXPECT_EQ(loaded.material("a").exponent, 1.0f);
  EXPECT_EQ(loaded.problems, "warning m.mtl: not shown: an Ns below 1 (1 is used) of 1 material (a)\n");
}

TEST(ObjMaterials, AColorOfOneNumberIsGrey) {
  const SceneTestFiles files;
  EXPECT_EQ(load_materials(files, {"a"}, "newmtl a\nKd 0.25\n").material("a").diffuse, glm::vec3(0.25f));
}

TEST(ObjMaterials, ReadsNamesWithBlanksUnicodeAndOddCharacters) {
  const SceneTestFiles files;
  const auto loaded =
      load_materials(files, {"a b  c", "\xC3\xA4\xE2\x82\xAC", "#x;\"{}", "d"},
                     "newmtl  a b  c \r\nKd 1 0 0\r\nnewmtl \xC3\xA4\xE2\x82\xAC\r\nKd 0 1 0\r\n"
                     "newmtl #x;\"{}\r\nKd 0 0 1\r\nNEWMTL d\r\n\tkd\t1\t1\t0\r\n");
  EXPECT_EQ(loaded.material("a b  c").diffuse, glm::vec3(1, 0, 0));
  EXPECT_EQ(loaded.material("\xC3\xA4\xE2\x82\xAC").diffuse, glm::vec3(0, 1, 0));
  EXPECT_EQ(loaded.material("#x;\"{}").diffuse, glm::vec3(0, 0, 1));
  EXPECT_EQ(loaded.material("d").diffuse, glm::vec3(1, 1, 0));
  EXPECT_EQ(loaded.problems, "");
}

TEST(ObjMaterials, WarnsOnceForEachKindThatIsNotShown) {
  const SceneTestFiles files;
  std::string mtl;
  std::vector<std::string> names;
  for (int i = 0; i < 40; ++i) {
    names.push_back("m" + std::to_string(i));
    mtl += "newmtl " + names.back() + "\nmap_Bump gone.png\nd 0.5\nmap_Ks x.png\nmap_Ke y.png\n";
  }
  const auto loaded = load_materials(files, names, mtl);
  EXPECT_THAT(
      loaded.problems,
      AllOf(HasSubstr("not shown: map_Bump of 40 materials (m0, m1, m2, m3 and 36 more)"),
            HasSubstr("not shown: map_Ks of 40 materials"), HasSubstr("not shown: map_Ke of 40 materials"),
            HasSubstr("not shown: transparency (d or Tr) of 40 materials")));
  EXPECT_EQ(std::count(loaded.problems.begin(), loaded.problems.end(), '\n'), 4);
}

TEST(ObjMaterials, SaysNothingAboutMaterialsThatNoFaceUses) {
  const SceneTestFiles files;
  const auto loaded =
      load_materials(files, {"a"}, "newmtl a\nnewmtl b\nmap_Kd gone.png\nd 0.1\nbump x.png\n");
  EXPECT_EQ(loaded.problems, "");
  EXPECT_EQ(loaded.model.materials.size(), 1u);
  EXPECT_EQ(loaded.model.unused_materials, std::vector<std::string>{"b"});
}

TEST(ObjMaterials, OpaqueMaterialsAreNotTransparent) {
  const SceneTestFiles files;
  const auto loaded = load_materials(files, {"a", "b"}, "newmtl a\nd 1\nnewmtl b\nTr 0\n");
  EXPECT_EQ(loaded.problems, "");
}

TEST(ObjMaterials, AnErrorInAMaterialThatNoFaceUsesIsAWarning) {
  const SceneTestFiles files;
  for (const char* wrong : {"Kd spectral a.rfl", "Kd 1 -1 0", "Ns", "map_Kd"}) {
    const auto loaded = load_materials(files, {"a"}, std::string("newmtl a\nnewmtl b\n") + wrong + "\n");
    EXPECT_THAT(loaded.problems,
                AllOf(HasSubstr("warning m.mtl:3: "), HasSubstr("no face uses this material"),
                      ::testing::Not(HasSubstr("error"))))
        << wrong;
  }
}

TEST(ObjMaterials, AMaterialThatUsemtlNamesForNoFaceIsUnused) {
  const SceneTestFiles files;
  files.write("m.mtl", "newmtl a\nnewmtl b\nmap_Kd gone.png\n");
  files.write("m.obj", "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl b\nusemtl a\nf 1 2 3\nusemtl b\n");
  const auto loaded = load(files, "m.obj");
  EXPECT_EQ(loaded.problems, "");
  EXPECT_EQ(loaded.model.materials.size(), 1u);
  EXPECT_EQ(loaded.model.unused_materials, std::vector<std::string>{"b"});
}

TEST(ObjMaterials, ReadsSeveralLibrariesAndNamesWithBlanks) {
  const SceneTestFiles files;
  files.write("a.mtl", "newmtl a\nKd 1 0 0\n");
  files.write("b.mtl", "newmtl b\nKd 0 1 0\n");
  files.write("c d.mtl", "newmtl c\nKd 0 0 1\n");
  files.write("m.obj",
              "mtllib a.mtl b.mtl\nmtllib c d.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
              "usemtl a\nf 1 2 3\nusemtl b\nf 1 2 4\nusemtl c\nf 1 3 4\n");
  const auto loaded = load(files, "m.obj");
  EXPECT_EQ(loaded.problems, "");
  EXPECT_EQ(loaded.material("b").diffuse, glm::vec3(0, 1, 0));
  EXPECT_EQ(loaded.material("c").diffuse, glm::vec3(0, 0, 1));
  EXPECT_EQ(loaded.model.files.size(), 4u);
}

TEST(ObjMaterials, TheFirstOfTwoMaterialsOfOneNameCounts) {
  const SceneTestFiles files;
  const auto loaded = load_materials(files, {"a"}, "newmtl a\nKd 1 0 0\nnewmtl a\nKd 0 1 0\n");
  EXPECT_EQ(loaded.material("a").diffuse, glm::vec3(1, 0, 0));
  EXPECT_THAT(loaded.problems, HasSubstr("warning m.mtl:3: material 'a' stands in line 1 too"));
}

struct BadMtl {
  const char* name;
  const char* text;
  const char* problem;
};

void PrintTo(const BadMtl& bad, std::ostream* stream) {
  *stream << bad.name;
}

class ObjMaterialsBadInput : public ::testing::TestWithParam<BadMtl> {};

TEST_P(ObjMaterialsBadInput, IsListedWithItsLine) {
  const SceneTestFiles files;
  files.write("cut.png", encode_png(rgb(1, 2, 3)).substr(0, 50));
  files.write("text.png", "no image at all");
  files.write("huge.ppm", "P6\n100000 100000\n255\nxxxx");
  EXPECT_THAT(load_materials(files, {"a"}, GetParam().text).problems, HasSubstr(GetParam().problem));
}

INSTANTIATE_TEST_SUITE_P(
    Files, ObjMaterialsBadInput,
    ::testing::Values(
        BadMtl{"NanColor", "newmtl a\nKd nan 0 0\n",
               "error m.mtl:2: Kd has 'nan', which is no finite number"},
        BadMtl{"WordAsColor", "newmtl a\nKd red\n", "error m.mtl:2: Kd has 'red'"},
        BadMtl{"NegativeColor", "newmtl a\nKd 1 -1 0\n", "error m.mtl:2: Kd is negative"},
        BadMtl{"TwoNumbers", "newmtl a\nKd 1 1\n", "error m.mtl:2: Kd has 2 numbers where 3 are needed"},
        BadMtl{"Spectral", "newmtl a\nKd spectral x.rfl\n", "error m.mtl:2: Kd is given as 'spectral'"},
        BadMtl{"CutInAColor", "newmtl a\nKd 0.5 0.",
               "error m.mtl:2: Kd has 2 numbers where 3 are needed; the file ends in the middle"},
        BadMtl{"NoExponent", "newmtl a\nNs\n", "error m.mtl:2: Ns without a number"},
        BadMtl{"NoName", "newmtl a\nnewmtl\nKd 1 0 0\n", "warning m.mtl:2: newmtl without a name"},
        BadMtl{"BeforeNewmtl", "Kd 1 1 1\nnewmtl a\n", "warning m.mtl:1: 'Kd' before the first newmtl"},
        BadMtl{"Unknown", "newmtl a\nKq 1\n", "warning m.mtl:2: unknown statement 'Kq'"},
        BadMtl{"MissingTexture", "newmtl a\nmap_Kd gone.png\n",
               "error m.mtl:2: the texture 'gone.png' is missing"},
        BadMtl{"NoTexture", "newmtl a\nmap_Kd\n", "error m.mtl:2: map_Kd without a file"},
        BadMtl{"TruncatedTexture", "newmtl a\nmap_Kd cut.png\n", "error m.mtl:2: the texture 'cut.png': "},
        BadMtl{"TextAsTexture", "newmtl a\nmap_Kd text.png\n", "error m.mtl:2: the texture 'text.png': "},
        BadMtl{"HugeTexture", "newmtl a\nmap_Kd huge.ppm\n", "100000 x 100000 pixels is too large"},
        BadMtl{"FolderAsTexture", "newmtl a\nmap_Kd .\n",
               "error m.mtl:2: the texture '' is not a regular file"},
        BadMtl{"Misspelt", "newmtl aa\n", "no material library has the material 'a'"}),
    [](const auto& test) { return test.param.name; });

TEST(ObjMaterials, OfManyMaterialsOfOneNameTheFirstAreListed) {
  const SceneTestFiles files;
  std::string mtl;
  for (int i = 0; i < 50; ++i) mtl += "newmtl a\n";
  EXPECT_THAT(load_materials(files, {"a"}, mtl).problems,
              HasSubstr("warning m.mtl: 44 more materials that stand in the file twice"));
}

TEST(ObjMaterials, OfManyUnknownMaterialsAndLibrariesTheFirstAreListed) {
  const SceneTestFiles files;
  std::string obj(kSquareObj);
  std::string lost = obj;
  for (int i = 0; i < 50; ++i) {
    obj += "usemtl paint" + std::to_string(i) + "\nf 1 2 3\n";
    lost += "mtllib lost" + std::to_string(i) + ".mtl\n";
  }
  files.write("m.mtl", "newmtl pain7\n");
  files.write("m.obj", "mtllib m.mtl\n" + obj);
  files.write("n.obj", lost);
  EXPECT_THAT(load(files, "m.obj").problems, AllOf(HasSubstr("the material 'paint0' (did you mean 'pain7'?)"),
                                                   HasSubstr("45 more materials that no library has")));
  EXPECT_THAT(load(files, "n.obj").problems, HasSubstr("45 more material libraries that cannot be read"));
}

}  // namespace
}  // namespace lightbench
