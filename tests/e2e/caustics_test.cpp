// Scenes with water: technique caustics, its references, and command caustics.
#include <gmock/gmock.h>

#include "e2e_fixture.h"

namespace lightbench {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

constexpr const char* kPool = R"({
  "entities": [{"name": "floor", "box": {"min": [-1, -0.1, -1], "max": [1, 0, 1]}}],
  "lights": [{"name": "sun", "type": "directional", "direction": [0.2, -1, 0]}],
  "water": {"min": [-1.5, -1.5], "max": [1.5, 1.5], "height": 1, "grid": [21, 21],
            "waves": [{"amplitude": 0.02, "wavelength": 0.8, "direction": [1, 0]}]}
})";

class GlCaustics : public test::Program {};

TEST_F(GlCaustics, ATableTellsHowNearEachMethodComes) {
  write("pool.json", kPool);
  const auto result = run({"caustics", "pool.json", "--rays", "100000", "--map-size", "32", "-o", "maps.md"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.err, HasSubstr("pool: floor, hit"));
  const std::string tables = read_file(path("maps.md"));
  EXPECT_THAT(tables,
              AllOf(HasSubstr("| pool | floor | sun |"), HasSubstr("| level map |"), HasSubstr("| rays |")));
}

TEST_F(GlCaustics, APageTellsWhatPlanesCost) {
  write("pool.json", kPool);
  const auto result =
      run({"slicing", "pool.json", "--planes", "2..3,5", "--rounds", "1", "--map-size", "32", "-o", "out"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.err, HasSubstr("pool: floor, 5 planes"));
  EXPECT_THAT(read_file(path("out/slicing.md")),
              AllOf(HasSubstr("| pool | floor | sun | 3 |"), HasSubstr(" hit ")));
  EXPECT_THAT(read_file(path("out/index.html")), HasSubstr("<svg"));
}

TEST_F(GlCaustics, PlanesThatAreNoNumbersAreAnError) {
  write("pool.json", kPool);
  for (const char* planes : {"1", "3..", "x", "3-5", "99999"}) {
    const auto result = run({"slicing", "pool.json", "--planes", planes, "-o", "out"});
    EXPECT_EQ(result.exit_code, 3) << planes;
    EXPECT_THAT(result.err, HasSubstr("--planes")) << planes;
  }
  const auto result = run({"slicing", "pool.json", "--without", "floor", "-o", "out"});
  EXPECT_THAT(result.err, HasSubstr("no receiver is there to time"));
}

TEST_F(GlCaustics, ASceneWithoutWaterIsAnError) {
  write("dry.json", R"({"entities": [{"name": "floor", "box": {"min": [-1, -0.1, -1], "max": [1, 0, 1]}}]})");
  const auto study = run({"caustics", "dry.json"});
  EXPECT_EQ(study.exit_code, 3);
  EXPECT_THAT(study.err, HasSubstr("dry: the scene has no water"));
  const auto picture = run({"render", "dry.json", "-t", "caustics", "-o", "dry.png"});
  EXPECT_EQ(picture.exit_code, 3);
  EXPECT_THAT(picture.err, HasSubstr("it has no water"));
}

TEST_F(GlCaustics, ALightThatCannotShineThroughIsAnError) {
  std::string scene = kPool;
  scene.replace(scene.find("[0.2, -1, 0]"), 12, "[0.2, 1, 0]");
  write("pool.json", scene);
  const auto picture = run({"render", "pool.json", "-t", "caustics", "-o", "pool.png"});
  EXPECT_EQ(picture.exit_code, 3);
  EXPECT_THAT(picture.err, HasSubstr("light 'sun' does not shine down on the water"));
}

TEST_F(GlCaustics, AJobComparesThemWithRays) {
  write("pool.json", kPool);
  write("job.json", R"({
    "name": "pool", "size": [64, 48],
    "scenes": [{"scene": "pool.json", "random": {"count": 1, "seed": 1}}],
    "variants": [{"name": "level map", "technique": "caustics", "params": {"map_size": 64}},
                 {"name": "volumetric", "technique": "caustics",
                  "params": {"map_size": 64, "method": "volumetric", "slices": 10}}],
    "references": [{"name": "rays", "kind": "light_tracer", "params": {"rays": 100000, "map_size": 64}}],
    "metrics": ["mean_error", "luv"]
  })");
  const auto result = run({"run", "job.json", "--out", "out"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(read_file(path("out/summary.md")),
              AllOf(HasSubstr("| volumetric | rays |"), HasSubstr("light")));
}

}  // namespace
}  // namespace lightbench
