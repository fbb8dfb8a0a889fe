#include <cmath>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "base/image_io.h"
#include "scene_test_files.h"

namespace lightbench {
namespace {

// A small scene that uses most statements.
constexpr std::string_view kObj =
    "# a comment\nmtllib m.mtl\no first thing\nv 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 1 1 0 0 0 1\nv 0.5 0.25 0\n"
    "v 0 1 0\nvt 0 0\nvt 1 0.5\nvt -3.5e1 1e-3\nvn 0 0 1\nvn 0 0.6 0.8\nusemtl red paint\ns 1\n"
    "f 1/1/1 2/2/1 3/3/2 4/1/2 5/2/1\ng other part\nv 0 0 2\nv 2 0 2 \\\n\nv 0 2 2\nusemtl leaf\n"
    "f -3//-1 -2//-1 -1//-2\nf -3/1 -2/2 -1/3\nf 1 2 6\nl 1 2\nf 8 7 6\n";
constexpr std::string_view kMtl =
    "newmtl red paint\nKd 0.8 0.1 0.1\nKs 0.5 0.4 0.3\nNs 50\nKe 0 0 0\nd 0.5\nillum 2\nmap_Kd t.png\n"
    "\nnewmtl leaf\nKd 1 1 1\nmap_Kd -s 1 1 1 t.png\nmap_d t.png\nTr 0.25\nbump -bm 0.5 t.png\n";
constexpr std::string_view kJson =
    R"({"name": "s", "entities": [{"obj": "m.obj", "up": "z", "size": [1, 2, 3], "transform": {"rotate": [1, 2, 3]}},
    {"box": {"min": [0, 0, 0], "max": [1, 1, 1]}, "material": {"diffuse": [1, 1, 1]}}],
    "materials": {"leaf": {"emission": [1, 1, 1]}}, "lights": [{"type": "point", "position": [1, 2, 3],
    "attenuation": {"type": "fade", "distance": 2}}], "background": {"color": [0, 0, 0]}, "near": 1, "far": 9})";

class BrokenFiles : public ::testing::Test {
 protected:
  void SetUp() override {
    Image8 texture(4, 4, 4, 200);
    texture.data[3] = 0;
    png_ = encode_png(texture);
    restore();
  }

  void restore() {
    files_.write("m.obj", kObj);
    files_.write("m.mtl", kMtl);
    files_.write("t.png", png_);
    files_.write("s.json", kJson);
  }

  // Whatever the files hold, a scene comes back that is sound as far as it goes, or problems with places.
  void expect_sound() const {
    const LoadedScene loaded = load_scene_collecting(files_.path("s.json"));
    for (const Problem& p : loaded.problems) {
      ASSERT_FALSE(p.what.empty());
      ASSERT_FALSE(p.where.empty()) << p.what;
    }
    ASSERT_TRUE(error_count(loaded) > 0 || triangle_count(loaded.scene) > 0);
    for (const Mesh& mesh : loaded.scene.meshes) {
      for (const glm::uvec3& t : mesh.triangles) ASSERT_LT(std::max({t.x, t.y, t.z}), mesh.positions.size());
      for (const glm::vec3& p : mesh.positions) ASSERT_TRUE(std::isfinite(p.x + p.y + p.z));
      for (const glm::vec3& n : mesh.normals) ASSERT_NEAR(n.x * n.x + n.y * n.y + n.z * n.z, 1.0f, 1e-4f);
      for (const MeshPart& part : mesh.parts)
        ASSERT_LT(std::size_t(part.material), loaded.scene.materials.size());
    }
  }

  void truncate_everywhere(const std::string& name, std::string_view text, std::size_t step) {
    for (std::size_t length = 0; length < text.size(); length += step) {
      files_.write(name, text.substr(0, length));
      ASSERT_NO_FATAL_FAILURE(expect_sound()) << name << " cut at " << length;
    }
    restore();
  }

  // Replaces, inserts and removes bytes, words and lines; the same for the same seed.
  void mutate(const std::string& name, std::string_view text, int times) {
    static constexpr const char* kWords[] = {"nan",        "-1", "0",  "999999999", "1e39", "-", "/", "//",
                                             "\n",         " ",  "\t", "\r",        "\\\n", "#", "f", "v",
                                             "4294967297", "[",  "{",  "\"",        "null", ":", ",", "\xFF"};
    std::mt19937_64 random(1);
    for (int i = 0; i < times; ++i) {
      std::string mutant(text);
      for (int k = 0; k < 3; ++k) {
        const std::size_t at = random() % mutant.size();
        const std::size_t removed = random() % 4;
        mutant.replace(at, removed, kWords[random() % std::size(kWords)]);
      }
      files_.write(name, mutant);
      ASSERT_NO_FATAL_FAILURE(expect_sound()) << name << " mutant " << i << ":\n" << mutant;
    }
    restore();
  }

  SceneTestFiles files_;
  std::string png_;
};

TEST_F(BrokenFiles, AreWholeToBeginWith) {
  const LoadedScene loaded = load_scene_collecting(files_.path("s.json"));
  EXPECT_EQ(error_count(loaded), 0u) << described(loaded, files_);
}

TEST_F(BrokenFiles, TruncatedObj) {
  truncate_everywhere("m.obj", kObj, 1);
}
TEST_F(BrokenFiles, TruncatedMtl) {
  truncate_everywhere("m.mtl", kMtl, 1);
}
TEST_F(BrokenFiles, TruncatedJson) {
  truncate_everywhere("s.json", kJson, 3);
}
TEST_F(BrokenFiles, TruncatedTexture) {
  truncate_everywhere("t.png", png_, 2);
}
TEST_F(BrokenFiles, MutatedObj) {
  mutate("m.obj", kObj, 500);
}
TEST_F(BrokenFiles, MutatedMtl) {
  mutate("m.mtl", kMtl, 300);
}
TEST_F(BrokenFiles, MutatedJson) {
  mutate("s.json", kJson, 300);
}
TEST_F(BrokenFiles, MutatedTexture) {
  mutate("t.png", png_, 100);
}

TEST_F(BrokenFiles, ACutTextureIsAlwaysAnError) {
  for (std::size_t length = 0; length + 12 < png_.size(); length += 5) {
    files_.write("t.png", std::string_view(png_).substr(0, length));
    EXPECT_GT(error_count(load_scene_collecting(files_.path("s.json"))), 0u) << length;
  }
}

TEST_F(BrokenFiles, RandomBytesAreAnError) {
  std::mt19937_64 random(2);
  for (int i = 0; i < 50; ++i) {
    std::string bytes(1 + random() % 2000, ' ');
    for (char& c : bytes) c = char(random());
    files_.write("m.obj", bytes);
    EXPECT_GT(error_count(load_scene_collecting(files_.path("s.json"))), 0u) << i;
    ASSERT_NO_FATAL_FAILURE(expect_sound()) << i;
  }
}

}  // namespace
}  // namespace lightbench
