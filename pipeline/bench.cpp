#include "pipeline/bench.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "pipeline/concrete.h"
#include "pipeline/snapshot.h"
#include "renderer/renderer.h"
#include "scene/motion.h"
#include "scene/scene_file.h"

namespace lightbench {
namespace {

constexpr int kWarmUps = 2;
const char* const kWholeFrame = "all passes";

/// Times of one variant's passes, in the order in which they first ran.
struct Samples {
  std::vector<std::string> order = {kWholeFrame};
  std::map<std::string, std::vector<double>> seconds;

  void add(const FrameResult& frame) {
    std::map<std::string, double> sums;
    for (const auto& pass : frame.passes) {
      if (!sums.contains(pass.name) && !seconds.contains(pass.name)) order.push_back(pass.name);
      sums[pass.name] += pass.seconds;
      sums[kWholeFrame] += pass.seconds;
    }
    for (const auto& [name, sum] : sums) seconds[name].push_back(sum);
  }
};

double quantile(const std::vector<double>& sorted, double q) {
  const double place = q * double(sorted.size() - 1);
  const auto below = std::size_t(place);
  const auto above = std::min(below + 1, sorted.size() - 1);
  return std::lerp(sorted[below], sorted[above], place - double(below));
}

std::vector<BenchRow> bench_view(const Job& job, const JobScene& job_scene, const Scene& scene,
                                 const View& view, Renderer& renderer, int rounds) {
  std::vector<Samples> samples(job.variants.size());
  for (int round = -kWarmUps; round < rounds; ++round)
    for (std::size_t v = 0; v < job.variants.size(); ++v) {
      const FrameRequest request{scene, view, job.width, job.height, job.samples, {}};
      const Technique& technique = find_technique(job.variants[v].technique, "");
      const FrameResult frame = renderer.render(technique, variant_params(job.variants[v]), request);
      if (round >= 0) samples[v].add(frame);
    }
  std::vector<BenchRow> rows;
  for (std::size_t v = 0; v < job.variants.size(); ++v) {
    BenchRow row{job_scene.name, view.name, job.variants[v].name, {}};
    for (const auto& pass : samples[v].order)
      if (!samples[v].seconds[pass].empty()) row.times.push_back(summarize(pass, samples[v].seconds[pass]));
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace

BenchTime summarize(const std::string& pass, std::vector<double> seconds) {
  assert(!seconds.empty());
  std::sort(seconds.begin(), seconds.end());
  return {pass, quantile(seconds, 0.5), quantile(seconds, 0.25), quantile(seconds, 0.75)};
}

std::vector<BenchRow> bench_job(const Job& concrete, const std::string& gl, int rounds) {
  Job job = concrete;
  std::erase_if(job.variants,
                [](const JobVariant& variant) { return find_technique(variant.technique, "").offline; });
  std::vector<BenchRow> rows;
  for (const auto& job_scene : job.scenes) {
    Scene scene = load_scene(job_scene.file);
    scene.name = job_scene.name;
    Renderer renderer(parse_gl(gl, "--gl"));
    for (const auto& view : views_of(job_scene)) {
      set_time(scene, view.time);
      for (auto& row : bench_view(job, job_scene, scene, view, renderer, rounds))
        rows.push_back(std::move(row));
    }
  }
  return rows;
}

std::string bench_table(const std::vector<BenchRow>& rows) {
  std::string text =
      fmt::format("{:<44} {:<24} {:>10} {:>20}\n", "view and variant", "pass", "median ms", "quartiles ms");
  for (const auto& row : rows) {
    std::string label = row.scene + "/" + row.view + "/" + row.variant;
    for (const auto& time : row.times) {
      text += fmt::format("{:<44} {:<24} {:>10.2f} {:>9.2f} ..{:>8.2f}\n", label, time.pass,
                          time.median * 1e3, time.lower * 1e3, time.upper * 1e3);
      label.clear();
    }
  }
  return text;
}

std::string bench_json(const Job& job, const std::vector<BenchRow>& rows, int rounds,
                       const std::string& renderer) {
  nlohmann::ordered_json json = {{"format", 1},
                                 {"job", job.name},
                                 {"size", {job.width, job.height}},
                                 {"samples", job.samples},
                                 {"rounds", rounds},
                                 {"warm_ups", kWarmUps},
                                 {"renderer", renderer}};
  json["rows"] = nlohmann::ordered_json::array();
  for (const auto& row : rows) {
    nlohmann::ordered_json item = {{"scene", row.scene}, {"view", row.view}, {"variant", row.variant}};
    for (const auto& time : row.times)
      item["passes"].push_back({{"name", time.pass},
                                {"median_seconds", time.median},
                                {"lower_quartile", time.lower},
                                {"upper_quartile", time.upper}});
    json["rows"].push_back(std::move(item));
  }
  return json.dump(2) + "\n";
}

}  // namespace lightbench
