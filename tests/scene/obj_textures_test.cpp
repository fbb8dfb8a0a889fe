#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/image_io.h"
#include "obj_material_files.h"

namespace lightbench {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

TEST(ObjTextures, WithoutKdIsWhiteUnderATextureElseGrey) {
  const SceneTestFiles files;
  write_png(files.path("t.png"), rgb(1, 2, 3));
  const auto loaded = load_materials(files, {"a", "b"}, "newmtl a\nmap_Kd t.png\nnewmtl b\n");
  EXPECT_EQ(loaded.material("a").diffuse, glm::vec3(1));
  EXPECT_EQ(loaded.material("b").diffuse, glm::vec3(0.8f));
}

TEST(ObjTextures, KeepsTextureBytesAsStored) {
  const SceneTestFiles files;
  Image8 image(2, 2, 4);
  for (std::size_t i = 0; i < image.data.size(); ++i) image.data[i] = std::uint8_t(17 * i);
  write_png(files.path("t.png"), image);
  const auto loaded = load_materials(files, {"a"}, "newmtl a\nmap_Kd t.png\n");
  EXPECT_EQ(loaded.textures.at(0).pixels, image) << "colour is not multiplied by alpha";
}

TEST(ObjTextures, FindsTexturesWithBackslashesBlanksAndOptions) {
  const SceneTestFiles files;
  write_png(files.path("sub folder/t 1.png"), rgb(9, 8, 7));
  const auto loaded = load_materials(files, {"a"}, "newmtl a\nmap_Kd -blendu on sub folder\\t 1.png\n");
  ASSERT_EQ(loaded.textures.size(), 1u);
  EXPECT_EQ(loaded.textures[0].pixels.data[0], 9);
  EXPECT_EQ(loaded.problems, "");
}

TEST(ObjTextures, FindsTexturesThatDifferInCaseAndSaysSo) {
  const SceneTestFiles files;
  write_png(files.path("tex/Wood.PNG"), rgb(1, 1, 1));
  const auto loaded = load_materials(files, {"a"}, "newmtl a\nmap_Kd TEX/wood.png\n");
  EXPECT_EQ(loaded.material("a").diffuse_texture, 0);
  EXPECT_THAT(loaded.problems, HasSubstr("warning m.mtl:2: there is no texture 'TEX/wood.png'"));
}

TEST(ObjTextures, FindsTexturesOfAnotherMachinesPathsBesideTheFile) {
  const SceneTestFiles files;
  write_png(files.path("wood.png"), rgb(1, 1, 1));
  const auto loaded = load_materials(files, {"a"}, "newmtl a\nmap_Kd C:\\Users\\me\\wood.png\n");
  EXPECT_EQ(loaded.material("a").diffuse_texture, 0);
}

TEST(ObjTextures, SharesATextureBetweenMaterials) {
  const SceneTestFiles files;
  write_png(files.path("t.png"), rgb(1, 1, 1));
  const auto loaded = load_materials(files, {"a", "b"}, "newmtl a\nmap_Kd t.png\nnewmtl b\nmap_Kd ./t.png\n");
  EXPECT_EQ(loaded.textures.size(), 1u);
}

TEST(ObjTextures, CutsOutByAlphaWhereTheFileHasOne) {
  const SceneTestFiles files;
  Image8 leaf(1, 1, 4, 255);
  leaf.data[3] = 0;
  write_png(files.path("leaf.png"), leaf);
  const auto loaded = load_materials(files, {"a"}, "newmtl a\nmap_Kd leaf.png\nmap_d leaf.png\n");
  EXPECT_EQ(loaded.material("a").cutout_texture, 0);
  EXPECT_EQ(loaded.material("a").diffuse_texture, 0);
  EXPECT_EQ(loaded.textures.size(), 1u);
}

TEST(ObjTextures, CutsOutByRedWhereTheFileHasNoAlpha) {
  const SceneTestFiles files;
  write_png(files.path("mask.png"), rgb(30, 30, 30));
  write_png(files.path("t.png"), rgb(1, 1, 1));
  const auto loaded = load_materials(files, {"a"}, "newmtl a\nmap_Kd t.png\nmap_d mask.png\n");
  const TextureIndex cutout = loaded.material("a").cutout_texture;
  ASSERT_NE(cutout, kNoTexture);
  EXPECT_EQ(loaded.textures[std::size_t(cutout)].pixels.data[3], 30);
}

TEST(ObjTextures, AColorTextureWithoutAlphaIsNoMask) {
  const SceneTestFiles files;
  write_png(files.path("t.png"), rgb(10, 10, 10));
  const auto loaded = load_materials(files, {"a"}, "newmtl a\nmap_Kd t.png\nmap_d t.png\n");
  EXPECT_EQ(loaded.material("a").cutout_texture, kNoTexture);
  EXPECT_THAT(loaded.problems,
              HasSubstr("not shown: map_d (the file of map_Kd, which has no alpha) of 1 material (a)"));
}

TEST(ObjTextures, KeepsCoincidentTrianglesOfWhichOneIsCutOut) {
  const SceneTestFiles files;
  Image8 leaf(1, 1, 4, 255);
  leaf.data[3] = 0;
  write_png(files.path("leaf.png"), leaf);
  files.write("m.mtl", "newmtl leaf\nmap_d leaf.png\nnewmtl wall\nnewmtl other\n");
  files.write("m.obj",
              "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\n"
              "usemtl leaf\nf 1/1 2/1 3/1\nusemtl wall\nf 1/1 2/1 3/1\nusemtl other\nf 3/1 2/1 1/1\n");
  EXPECT_EQ(load(files, "m.obj").model.meshes[0].triangles.size(), 2u);
}

TEST(ObjTextures, PlacesTexturesAsTheirOptionsSay) {
  const SceneTestFiles files;
  write_png(files.path("t.png"), rgb(1, 1, 1));
  files.write("m.mtl", "newmtl a\nmap_Kd -s 2 3 1 -o 0.5 0.25 0 t.png\nnewmtl b\nmap_Kd t.png\n");
  files.write("m.obj",
              "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
              "usemtl a\nf 1/1 2/2 3/3\nusemtl b\nf 1/1 3/3 4/4\n");
  const auto loaded = load(files, "m.obj");
  EXPECT_EQ(loaded.problems, "");
  const Mesh& mesh = loaded.model.meshes.at(0);
  EXPECT_EQ(mesh.uvs.at(mesh.triangles[0].x), glm::vec2(0.5f, 0.25f));
  EXPECT_EQ(mesh.uvs.at(mesh.triangles[0].z), glm::vec2(2.5f, 3.25f));
  EXPECT_EQ(mesh.uvs.at(mesh.triangles[1].y), glm::vec2(1, 1)) << "of the other material";
}

TEST(ObjTextures, BothTexturesOfAMaterialLieAsMapKdSays) {
  const SceneTestFiles files;
  write_png(files.path("t.png"), rgb(1, 1, 1));
  write_png(files.path("mask.png"), rgb(200, 200, 200));
  const std::string same = "newmtl a\nmap_Kd -s 2 2 t.png\nmap_d -s 2 2 mask.png\n";
  EXPECT_EQ(load_materials(files, {"a"}, same).problems, "");
  EXPECT_THAT(load_materials(files, {"a"}, "newmtl a\nmap_Kd -s 2 2 t.png\nmap_d mask.png\n").problems,
              HasSubstr("not shown: -s and -o of map_d (those of map_Kd are used) of 1 material (a)"));
}

TEST(ObjTextures, WarnsAboutTextureOptionsThatAreNotShown) {
  const SceneTestFiles files;
  write_png(files.path("t.png"), rgb(1, 1, 1));
  const auto loaded = load_materials(files, {"a"}, "newmtl a\nmap_Kd -clamp on -mm 0 2 t.png\n");
  EXPECT_THAT(loaded.problems, AllOf(HasSubstr("not shown: the texture option -clamp of 1 material (a)"),
                                     HasSubstr("not shown: the texture option -mm of 1 material (a)")));
  EXPECT_EQ(loaded.material("a").diffuse_texture, 0);
}

TEST(ObjTextures, WarnsAboutAnAmbientTextureOfItsOwn) {
  const SceneTestFiles files;
  write_png(files.path("t.png"), rgb(1, 1, 1));
  EXPECT_EQ(load_materials(files, {"a"}, "newmtl a\nmap_Ka t.png\nmap_Kd t.png\n").problems, "");
  EXPECT_THAT(load_materials(files, {"a"}, "newmtl a\nmap_Ka t.png\n").problems,
              HasSubstr("not shown: map_Ka of 1 material (a)"));
}

TEST(ObjTextures, WarnsAboutATextureThatStandsTwice) {
  const SceneTestFiles files;
  write_png(files.path("t.png"), rgb(1, 1, 1));
  write_png(files.path("u.png"), rgb(2, 2, 2));
  const auto loaded = load_materials(files, {"a"}, "newmtl a\nmap_Kd t.png\nmap_Kd u.png\n");
  EXPECT_THAT(loaded.problems, HasSubstr("warning m.mtl:3: map_Kd stands twice in material 'a'"));
  EXPECT_EQ(loaded.textures.at(0).pixels.data[0], 2);
}

TEST(ObjTextures, WarnsWhereATextureHasNoCoordinates) {
  const SceneTestFiles files;
  write_png(files.path("t.png"), rgb(1, 1, 1));
  files.write("m.mtl", "newmtl a\nmap_Kd t.png\n");
  files.write("m.obj", "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\n");
  EXPECT_THAT(load(files, "m.obj").problems,
              HasSubstr("a texture, without texture coordinates of 1 material (a)"));
}

TEST(ObjTextures, OfManyTexturesThatCannotBeReadTheFirstAreListed) {
  const SceneTestFiles files;
  std::string mtl;
  std::vector<std::string> names;
  for (int i = 0; i < 20; ++i) {
    names.push_back("m" + std::to_string(i));
    mtl += "newmtl " + names.back() + "\nmap_Kd gone" + names.back() + ".png\n";
  }
  const auto loaded = load_materials(files, names, mtl);
  EXPECT_THAT(loaded.problems, AllOf(HasSubstr("error m.mtl:10: the texture 'gonem4.png' is missing"),
                                     HasSubstr("15 more textures that cannot be read")));
}

}  // namespace
}  // namespace lightbench
