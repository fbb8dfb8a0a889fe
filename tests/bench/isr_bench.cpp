// Image-space radiosity of one view while the same room has ever more triangles: what draws the scene grows
// with them, what gathers light does not.
#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include "renderer/renderer.h"
#include "scene/camera_script.h"
#include "scene/scene_file.h"

namespace lightbench {
namespace {

constexpr const char* kCornell = LIGHTBENCH_SOURCE_DIR "/jobs/scenes/cornell.json";
constexpr const char* kViews = LIGHTBENCH_SOURCE_DIR "/jobs/cameras/cornell.json";

template <typename T>
T between(const std::vector<T>& values, const glm::uvec3& corner, float u, float v) {
  return (1 - u - v) * values[corner.x] + u * values[corner.y] + v * values[corner.z];
}

/// The same surface, each triangle cut into n * n.
Mesh cut(const Mesh& mesh, int n) {
  Mesh result;
  result.name = mesh.name;
  for (const MeshPart& part : mesh.parts) {
    MeshPart fine{part.material, std::uint32_t(result.triangles.size()),
                  part.triangle_count * std::uint32_t(n * n)};
    for (std::uint32_t t = part.first_triangle; t < part.first_triangle + part.triangle_count; ++t) {
      const glm::uvec3 corners = mesh.triangles[t];
      const auto first = std::uint32_t(result.positions.size());
      for (int row = 0; row <= n; ++row)
        for (int i = 0; i <= n - row; ++i) {
          const float u = float(i) / float(n), v = float(row) / float(n);
          result.positions.push_back(between(mesh.positions, corners, u, v));
          result.normals.push_back(glm::normalize(between(mesh.normals, corners, u, v)));
          if (!mesh.uvs.empty()) result.uvs.push_back(between(mesh.uvs, corners, u, v));
          if (!mesh.colors.empty()) result.colors.push_back(between(mesh.colors, corners, u, v));
        }
      std::uint32_t start = first;
      for (int row = 0; row < n; ++row) {
        const auto width = std::uint32_t(n - row);
        for (std::uint32_t i = 0; i < width; ++i) {
          result.triangles.push_back({start + i, start + i + 1, start + width + 1 + i});
          if (i + 1 < width)
            result.triangles.push_back({start + i + 1, start + width + 2 + i, start + width + 1 + i});
        }
        start += width + 1;
      }
    }
    result.parts.push_back(fine);
  }
  return result;
}

/// The Cornell box of about that many triangles.
Scene room(std::size_t triangles) {
  Scene scene = load_scene(kCornell);
  const double share = double(triangles) / double(triangle_count(scene));
  const int n = std::max(1, int(std::lround(std::sqrt(share))));
  for (Mesh& mesh : scene.meshes) mesh = cut(mesh, n);
  return scene;
}

void isr(benchmark::State& state, const char* preset) {
  const Scene scene = room(std::size_t(state.range(0)));
  const View view = read_camera_script(kViews).front();
  const Technique& technique = find_technique("isr", "bench");
  const ParamValues params = resolve_params(technique.params, technique.presets, preset, {}, "bench");
  Renderer renderer(GlBackend::osmesa);
  std::map<std::string, double> passes;
  const FrameRequest frame{.scene = scene, .view = view, .width = 512, .height = 384, .buffers = {}};
  renderer.render(technique, params, frame);
  for (auto _ : state)
    for (const PassTime& pass : renderer.render(technique, params, frame).passes)
      passes[pass.name] += 1e3 * pass.seconds;
  state.counters["triangles"] = double(triangle_count(scene));
  for (const auto& [pass, milliseconds] : passes)
    state.counters[pass + " ms"] = benchmark::Counter(milliseconds, benchmark::Counter::kAvgIterations);
}
BENCHMARK_CAPTURE(isr, area_80, "area-80")
    ->RangeMultiplier(10)
    ->Range(1000, 1000000)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(isr, fast, "fast")
    ->RangeMultiplier(10)
    ->Range(1000, 1000000)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(isr, best, "best")
    ->RangeMultiplier(10)
    ->Range(1000, 1000000)
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace lightbench
