// Ray queries and loading on the project's own Cornell box and yard.
#include <cmath>

#include <benchmark/benchmark.h>

#include "povexport/pov_scene.h"
#include "renderer/rays.h"
#include "scene/scene_file.h"

namespace lightbench {
namespace {

constexpr const char* kCornell = LIGHTBENCH_SOURCE_DIR "/jobs/scenes/cornell.json";
constexpr const char* kYard = LIGHTBENCH_SOURCE_DIR "/tests/data/yard/yard.json";

void closest_hit(benchmark::State& state, const char* file) {
  const Scene scene = load_scene(file);
  const SceneRays rays(scene);
  const glm::vec3 origin = world_bounds(scene).center();
  unsigned i = 0;
  for (auto _ : state) {
    const float z = 1 - 2 * (float(i % 997) + 0.5f) / 997, phi = 2.3999632f * float(i++ % 997);
    const float r = std::sqrt(1 - z * z);
    benchmark::DoNotOptimize(rays.closest_hit(origin, {r * std::cos(phi), z, r * std::sin(phi)}));
  }
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK_CAPTURE(closest_hit, cornell, kCornell);
BENCHMARK_CAPTURE(closest_hit, yard, kYard);

void load(benchmark::State& state, const char* file) {
  for (auto _ : state) benchmark::DoNotOptimize(load_scene(file));
}
BENCHMARK_CAPTURE(load, yard, kYard)->Unit(benchmark::kMillisecond);

void export_assets(benchmark::State& state, const char* file) {
  const Scene scene = load_scene(file);
  for (auto _ : state) benchmark::DoNotOptimize(pov_assets(scene));
}
BENCHMARK_CAPTURE(export_assets, yard, kYard)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace lightbench
