#include <gmock/gmock.h>

#include "agreement_pair.h"
#include "base/json_reader.h"
#include "scene/camera_script.h"
#include "scene/scene_file.h"

/// jobs/lineup.json: one scene for each feature that is exported, which both sides show alike. The rows,
/// their views, the size and the limit are those of the job, so that a new row is tested as soon as it stands
/// there.
namespace lightbench {
namespace {

const std::filesystem::path kJobs = std::filesystem::path(LIGHTBENCH_SOURCE_DIR) / "jobs";

struct Row {
  std::filesystem::path scene;
  std::vector<View> views;

  friend void PrintTo(const Row& row, std::ostream* out) { *out << row.scene.stem().string(); }
};

JsonObject job() {
  return JsonObject(JsonValue::parse_file(kJobs / "lineup.json"));
}

std::vector<Row> rows() {
  std::vector<Row> rows;
  for (const JsonValue& item : job().at("scenes").items()) {
    JsonObject scene(item);
    Row row{kJobs / scene.at("scene").text(), {}};
    for (const JsonValue& view : scene.at("views").items()) row.views.push_back(read_view(view));
    rows.push_back(row);
  }
  return rows;
}

double limit() {
  return JsonObject(job().at("gates").items().at(0)).at("max").number();
}

class PovrayLineup : public testing::TestWithParam<Row> {};

TEST_P(PovrayLineup, IsShownAlike) {
  const Scene scene = load_scene(GetParam().scene);
  const PovAssets assets = pov_assets(scene);
  const std::vector<double> size = job().at("size").numbers(2);
  Renderer renderer(GlBackend::osmesa);
  for (const View& view : GetParam().views) {
    SCOPED_TRACE(view.name);
    const FrameRequest frame{.scene = scene,
                             .view = view,
                             .width = int(size[0]),
                             .height = int(size[1]),
                             .samples = 1,
                             .buffers = {}};
    const Pair pair{render_with_povray(scene, assets, view, frame), render_direct(renderer, frame)};
    EXPECT_LE(mean_error(pair), limit());
  }
}

INSTANTIATE_TEST_SUITE_P(Povray, PovrayLineup, testing::ValuesIn(rows()),
                         [](const auto& row) { return row.param.scene.stem().string(); });

TEST(Lineup, HoldsEveryFileOfItsFolder) {
  std::vector<std::string> files, named;
  for (const auto& entry : std::filesystem::directory_iterator(kJobs / "scenes" / "lineup"))
    if (entry.path().extension() == ".json") files.push_back(entry.path().stem().string());
  for (const Row& row : rows()) named.push_back(row.scene.stem().string());
  EXPECT_THAT(named, testing::UnorderedElementsAreArray(files));
}

}  // namespace
}  // namespace lightbench
