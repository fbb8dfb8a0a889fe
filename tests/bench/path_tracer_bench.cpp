// The path tracer against a plain loop over single rays that makes the same picture, one after the other in
// the same iteration: `speedup` is of whole frames, the rest is the path tracer's rays per second by class.
#include <cmath>
#include <cstdlib>

#include <benchmark/benchmark.h>

#include "base/stopwatch.h"
#include "renderer/path_tracer.h"
#include "scene/camera_script.h"
#include "scene/scene_file.h"
#include "tests/bench/plain_path_tracer.h"

namespace lightbench {
namespace {

constexpr int kWidth = 192, kHeight = 144;

double mean_difference(const Image& image, const std::vector<glm::vec3>& pixels) {
  double sum = 0;
  for (std::size_t i = 0; i < pixels.size(); ++i)
    for (int c = 0; c < 3; ++c)
      sum += std::abs(double(image.data[4 * i + std::size_t(c)]) - double(pixels[i][c]));
  return sum / double(3 * pixels.size());
}

void path_tracer(benchmark::State& state, const char* scene_file, const char* camera_file) {
  if (std::string_view(scene_file).find("office") != std::string_view::npos &&
      !std::getenv("LIGHTBENCH_SCENES")) {
    state.SkipWithError("LIGHTBENCH_SCENES is not set");
    return;
  }
  const std::string folder = LIGHTBENCH_SOURCE_DIR "/";
  const Scene scene = load_scene(folder + scene_file);
  const View view = read_camera_script(folder + camera_file).front();
  PathTracerOptions options;
  options.samples = 64;
  double ours = 0, plain = 0;
  PathTracedImage image;
  std::vector<glm::vec3> pixels;
  for (auto _ : state) {
    const Stopwatch watch;
    image = trace_paths(scene, view, kWidth, kHeight, 1, options);
    const double seconds = watch.seconds();
    const Stopwatch plain_watch;
    pixels = bench::plain_path_trace(scene, view, kWidth, kHeight, options);
    plain += plain_watch.seconds();
    ours += seconds;
    state.SetIterationTime(seconds);
  }
  state.counters["speedup"] = plain / ours;
  state.counters["difference"] = mean_difference(image.image, pixels);
  for (const RayRate& rate : image.rays)
    state.counters[rate.name + "_rays/s"] = double(rate.rays) / rate.seconds;
}
BENCHMARK_CAPTURE(path_tracer, cornell, "jobs/scenes/cornell.json", "jobs/cameras/cornell.json")
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(path_tracer, yard, "tests/data/yard/yard.json", "tests/data/yard/cameras.json")
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(path_tracer, office, "jobs/scenes/office.json", "jobs/cameras/office.json")
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace lightbench
