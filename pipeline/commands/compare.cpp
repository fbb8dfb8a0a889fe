#include <cstdio>

#include <CLI/CLI.hpp>

#include "base/image_io.h"
#include "base/text.h"
#include "pipeline/commands/commands.h"
#include "pipeline/score.h"
#include "pipeline/tables.h"

namespace lightbench {
namespace {

struct CompareParams {
  std::string reference;
  std::string image;
  std::vector<std::string> metrics;
  std::string baseline;
  std::string mask;
  std::string difference;
  std::string heat;
  double heat_scale = 64;
  bool json = false;
};

void print_scores(const Score& score, const std::vector<std::string>& names) {
  for (const auto& name : names) {
    const Metric& metric = find_metric(name, "");
    const MetricValue& value = score.metrics.at(name);
    if (value.value)
      std::printf("%-20s %12.*f %s\n", name.c_str(), metric.decimals, *value.value, metric.unit.c_str());
    else
      std::printf("%-20s %12s (%s)\n", name.c_str(), "undefined", value.undefined_because.c_str());
  }
}

ExitCode run_compare(const CompareParams& params) {
  ScoreRequest request{.image = params.image,
                       .reference = params.reference,
                       .baseline = params.baseline,
                       .mask = params.mask,
                       .metrics = params.metrics};
  for (const auto& name : params.metrics) find_metric(name, "--metric");
  if (request.metrics.empty())
    for (const auto& metric : metrics())
      if (!metric.needs_ambient_fit && (!metric.needs_baseline || !params.baseline.empty()))
        request.metrics.push_back(metric.name);
  request.use_reference_alpha = false;
  const Score score = compute_score(request);
  if (params.json)
    std::printf("%s", score_json(score).c_str());
  else
    print_scores(score, request.metrics);
  if (!params.difference.empty())
    write_png(params.difference, difference_image(score.reference, score.image));
  if (!params.heat.empty()) write_png(params.heat, heat_map(score.reference, score.image, params.heat_scale));
  return ExitCode::ok;
}

}  // namespace

void add_compare_command(CLI::App& app, Action& action) {
  CLI::App* command = nullptr;
  auto params =
      add_command<CompareParams>(app, "compare", "Compare two pictures", action, run_compare, command);
  command->add_option("reference", params->reference, "The truth: any picture that OpenImageIO reads")
      ->required();
  command->add_option("image", params->image, "The picture to judge, of the same size")->required();
  command
      ->add_option("-m,--metric", params->metrics,
                   "Which: " + join(row_names(metrics()), ", ") + "; default: all")
      ->delimiter(',')
      ->allow_extra_args(false);
  command->add_option("--baseline", params->baseline, "Picture that gain and quality are measured against");
  command->add_option(
      "--mask", params->mask,
      "Picture whose alpha (or grey) of at least half marks the pixels of masked metrics; default: all");
  command->add_option("--diff", params->difference, "Write the negative of the absolute error (PNG)");
  command->add_option("--heat", params->heat, "Write the error as a heat map with a colour bar (PNG)");
  command->add_option("--heat-scale", params->heat_scale, "Error at the end of the colour bar, of 255")
      ->check(CLI::Range(1.0, 255.0))
      ->capture_default_str();
  command->add_flag("--json", params->json, "Print JSON");
  command->footer(
      R"(Float pictures are compared as the rounded sRGB of their linear values, on the 0..255 scale.

Example:
  lightbench compare truth.exr mine.png --metric mean_error,pearson --diff difference.png)");
}

}  // namespace lightbench
