#include <cstdlib>

#include <gmock/gmock.h>

#include "agreement_pair.h"
#include "scene/camera_script.h"
#include "scene/scene_file.h"

/// `direct` with hard shadows and POV-Ray without radiosity show the same image, but for where shadows and
/// silhouettes end: there a pixel belongs to one side or the other. All pixels are compared, those with them.
namespace lightbench {
namespace {

struct Agreement {
  const char* name;
  std::string scene;  ///< below the sources
  std::string cameras;
  double mean_error;  ///< of 255, over all pixels, edges with them
  bool real_scene = false;

  friend void PrintTo(const Agreement& agreement, std::ostream* out) { *out << agreement.name; }
};

std::size_t silhouette_differences(const Pair& pair) {
  std::size_t count = 0;
  for (std::size_t i = 3; i < pair.reference.data.size(); i += 4)
    count += pair.reference.data[i] != pair.snapshot.data[i];
  return count;
}

/// Pixels whose right or lower neighbour is on the other side of a silhouette.
std::size_t silhouette_length(const Image8& image) {
  std::size_t count = 0;
  for (int y = 0; y + 1 < image.height; ++y)
    for (int x = 0; x + 1 < image.width; ++x) {
      const auto alpha = image.pixel(x, y)[3];
      count += alpha != image.pixel(x + 1, y)[3] || alpha != image.pixel(x, y + 1)[3];
    }
  return count;
}

void expect_agreement(const Pair& pair, double limit) {
  EXPECT_LE(mean_error(pair), limit);
  // OpenGL snaps vertices to 1/256 of a pixel: about that part of a silhouette's pixels may fall to the other
  // side, and a cut-out has two silhouettes, its own and that of its texels.
  const double allowed = 1 + 0.02 * double(silhouette_length(pair.reference));
  EXPECT_LE(double(silhouette_differences(pair)), allowed);
}

bool scene_folder_is_there() {
  const char* folder = std::getenv("LIGHTBENCH_SCENES");
  return folder != nullptr && std::filesystem::is_directory(folder);
}

bool scenes_are_required() {
  const char* required = std::getenv("LIGHTBENCH_REQUIRE_SCENES");
  return required != nullptr && std::string(required) == "1";
}

class PovrayAgreement : public testing::TestWithParam<Agreement> {};

TEST_P(PovrayAgreement, OfDirectLight) {
  if (GetParam().real_scene && !scene_folder_is_there()) {
    if (scenes_are_required()) FAIL() << "LIGHTBENCH_SCENES is not there, and LIGHTBENCH_REQUIRE_SCENES is 1";
    GTEST_SKIP() << "LIGHTBENCH_SCENES is not there";
  }
  const std::filesystem::path sources = LIGHTBENCH_SOURCE_DIR;
  const Scene scene = load_scene(sources / GetParam().scene);
  const PovAssets assets = pov_assets(scene);
  Renderer renderer(GlBackend::osmesa);
  for (const View& view : read_camera_script(sources / GetParam().cameras)) {
    SCOPED_TRACE(view.name);
    const FrameRequest frame{
        .scene = scene, .view = view, .width = 512, .height = 384, .samples = 1, .buffers = {}};
    expect_agreement({render_with_povray(scene, assets, view, frame), render_direct(renderer, frame)},
                     GetParam().mean_error);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Povray, PovrayAgreement,
    testing::Values(Agreement{"cornell", "jobs/scenes/cornell.json", "jobs/cameras/cornell.json", 0.15},
                    Agreement{"yard", "tests/data/yard/yard.json", "tests/data/yard/cameras.json", 0.15},
                    Agreement{"office", "jobs/scenes/office.json", "jobs/cameras/office.json", 0.3, true},
                    Agreement{"garage", "jobs/scenes/garage.json", "jobs/cameras/garage.json", 0.3, true},
                    // Palms and grass: every third pixel is an edge of a cut-out or of its shadow.
                    Agreement{"hacienda", "jobs/scenes/hacienda.json", "jobs/cameras/hacienda.json", 1.0,
                              true}),
    [](const auto& row) { return std::string(row.param.name); });

TEST(PovraySupersampling, AgreementHoldsForSupersampledImages) {
  const std::filesystem::path yard = LIGHTBENCH_TEST_DATA "/yard";
  const Scene scene = load_scene(yard / "yard.json");
  const View view = read_camera_script(yard / "cameras.json").front();
  const FrameRequest frame{
      .scene = scene, .view = view, .width = 256, .height = 192, .samples = 3, .buffers = {}};
  Renderer renderer(GlBackend::osmesa);
  const Pair pair{render_with_povray(scene, pov_assets(scene), view, frame), render_direct(renderer, frame)};
  EXPECT_LE(mean_error(pair), 0.15);
}

}  // namespace
}  // namespace lightbench
