#include "pipeline/bench.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <iterator>
#include <map>
#include <numeric>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/json_bytes.h"
#include "pipeline/concrete.h"
#include "pipeline/plan.h"
#include "pipeline/selection.h"
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

/// A scene of the job that is loaded.
struct BenchScene {
  const Job& job;
  int number;
  const std::filesystem::path& out;
  Scene scene;
};

FrameRequest frame_request(const BenchScene& bench, const View& view, const JobVariant& variant) {
  const Job& job = bench.job;
  FrameRequest request{bench.scene, view, job.width, job.height, job.samples, {}};
  if (find_technique(variant.technique, "").needs_bake)
    request.baked = bench.out / compressed_folder(job, bench.number, variant);
  return request;
}

std::vector<BenchRow> bench_view(const BenchScene& bench, const View& view,
                                 const std::vector<JobVariant>& variants, Renderer& renderer, int rounds) {
  std::vector<Samples> samples(variants.size());
  for (int round = -kWarmUps; round < rounds; ++round)
    for (std::size_t v = 0; v < variants.size(); ++v) {
      const Technique& technique = find_technique(variants[v].technique, "");
      const FrameResult frame =
          renderer.render(technique, variant_params(variants[v]), frame_request(bench, view, variants[v]));
      if (round >= 0) samples[v].add(frame);
    }
  std::vector<BenchRow> rows;
  for (std::size_t v = 0; v < variants.size(); ++v) {
    BenchRow row{bench.scene.name, view.name, variants[v].name, {}};
    for (const auto& pass : samples[v].order)
      if (!samples[v].seconds[pass].empty()) row.times.push_back(summarize(pass, samples[v].seconds[pass]));
    rows.push_back(std::move(row));
  }
  return rows;
}

struct TimedView {
  View view;
  std::vector<JobVariant> variants;
};

std::vector<TimedView> timed_views(const Job& job, const JobScene& scene, const std::string& only) {
  std::vector<TimedView> timed;
  for (const auto& view : views_of(scene)) {
    std::vector<JobVariant> variants;
    std::copy_if(job.variants.begin(), job.variants.end(), std::back_inserter(variants),
                 [&](const JobVariant& variant) {
                   const std::string label = fmt::format("{}/{}/{}", scene.name, view.name, variant.name);
                   return is_timed(variant) && is_selected(label, only);
                 });
    if (!variants.empty()) timed.push_back({view, std::move(variants)});
  }
  return timed;
}

}  // namespace

bool is_timed(const JobVariant& variant) {
  const Technique& technique = find_technique(variant.technique, "");
  return !technique.offline && !technique.external;
}

BenchTime summarize(const std::string& pass, std::vector<double> seconds) {
  assert(!seconds.empty());
  std::sort(seconds.begin(), seconds.end());
  return {pass, quantile(seconds, 0.5), quantile(seconds, 0.25), quantile(seconds, 0.75)};
}

std::vector<BenchRow> bench_job(const Job& concrete, const std::filesystem::path& out, const std::string& gl,
                                int rounds, const std::string& only) {
  std::vector<BenchRow> rows;
  for (std::size_t s = 0; s < concrete.scenes.size(); ++s) {
    const JobScene& job_scene = concrete.scenes[s];
    const auto timed = timed_views(concrete, job_scene, only);
    if (timed.empty()) continue;
    BenchScene bench{concrete, int(s), out, load_scene(job_scene.file)};
    bench.scene.name = job_scene.name;
    Renderer renderer(parse_gl(gl, "--gl"));
    for (const auto& [view, variants] : timed) {
      set_time(bench.scene, view.time);
      for (auto& row : bench_view(bench, view, variants, renderer, rounds)) rows.push_back(std::move(row));
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

std::string bench_means(const std::vector<BenchRow>& rows) {
  std::vector<std::string> order;
  std::map<std::string, std::vector<double>> medians;
  for (const auto& row : rows) {
    if (!medians.contains(row.variant)) order.push_back(row.variant);
    medians[row.variant].push_back(row.times.front().median);
  }
  const auto mean = [&](const std::string& variant) {
    const auto& values = medians.at(variant);
    return std::accumulate(values.begin(), values.end(), 0.0) / double(values.size());
  };
  std::string text = fmt::format("{:<44} {:>5} {:>10} {:>10}\n", "variant", "views", "mean ms", "to first");
  for (const auto& variant : order)
    text += fmt::format("{:<44} {:>5} {:>10.2f} {:>10.2f}\n", variant, medians.at(variant).size(),
                        mean(variant) * 1e3, mean(variant) / mean(order.front()));
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
  return json_text(json, 2) + "\n";
}

}  // namespace lightbench
