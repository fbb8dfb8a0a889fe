#include "reports/compare.h"

#include <cstdio>

#include <CLI/CLI.hpp>

#include "base/image_kinds.h"
#include "base/text.h"
#include "pipeline/commands/commands.h"
#include "pipeline/commands/number_range.h"
#include "pipeline/score.h"
#include "pipeline/tables.h"
#include "reports/escape.h"
#include "reports/value_text.h"

namespace lightbench {
namespace {

struct CompareParams {
  std::string reference;
  std::string image;
  std::vector<std::string> metrics;
  std::string baseline;
  std::string layer;
  std::string reference_layer;
  std::string mask;
  std::string difference;
  std::string heat;
  double heat_scale = 64;
  bool json = false;
};

void print_table(const CompareResult& result) {
  for (const auto& [name, value] : result.metrics) {
    const Metric& metric = find_metric(name, "");
    if (value.value)
      std::printf("%-20s %12.*f %s\n", name.c_str(), metric.decimals, *value.value, metric.unit.c_str());
    else
      std::printf("%-20s %12s (%s)\n", name.c_str(), "undefined", value.undefined_because.c_str());
  }
  std::printf("%zu of %d x %d pixels count in masked metrics (%s)\n", result.mask_pixels, result.width,
              result.height, plain_line(result.mask_source).c_str());
  std::printf("%s", error_place_text(result.place).c_str());
  if (result.alpha.pixels > 0)
    std::printf(
        "not equal: %s another alpha, by up to %d of 255; metrics do not tell of it\n",
        (counted(result.alpha.pixels, "pixel") + (result.alpha.pixels == 1 ? " has" : " have")).c_str(),
        result.alpha.largest);
}

ExitCode run_compare(const CompareParams& params) {
  const CompareResult result = compare_files({.reference = params.reference,
                                              .image = params.image,
                                              .baseline = params.baseline,
                                              .layer = params.layer,
                                              .reference_layer = params.reference_layer,
                                              .mask = params.mask,
                                              .metrics = params.metrics,
                                              .difference = params.difference,
                                              .heat = params.heat,
                                              .heat_scale = params.heat_scale});
  if (params.json)
    std::printf("%s", score_json({.masked_pixels = result.mask_pixels,
                                  .metrics = {result.metrics.begin(), result.metrics.end()},
                                  .place = result.place.value_or(ErrorPlace{}),
                                  .alpha = result.alpha})
                          .c_str());
  else
    print_table(result);
  return ExitCode::ok;
}

}  // namespace

void add_compare_command(CLI::App& app, Action& action) {
  CLI::App* command = nullptr;
  auto params =
      add_command<CompareParams>(app, "compare", "Compare two pictures", action, run_compare, command);
  command
      ->add_option("reference", params->reference,
                   "The truth: a picture in one of the formats " + image_kind_names())
      ->required();
  command->add_option("image", params->image, "The picture to judge, of the same size")->required();
  command
      ->add_option(
          "-m,--metric", params->metrics,
          "Which: " + join(row_names(metrics()), ", ") + "; default: all that need no more than is given")
      ->delimiter(',')
      ->allow_extra_args(false);
  command->add_option("--baseline", params->baseline, "Picture that gain and quality are measured against");
  command->add_option(
      "--layer", params->layer,
      "Layer or part to read in OpenEXR files that have named ones; default: the one without a "
      "name, or the only one with colour");
  command->add_option("--reference-layer", params->reference_layer,
                      "The same for the reference alone; default: that of --layer");
  command->add_option("--mask", params->mask,
                      "Picture that marks the pixels of masked metrics: by an alpha of at least half, or "
                      "without one by a colour "
                      "that is not black; default: the truth's alpha, if it has one");
  command->add_option("--diff", params->difference, "Write the negative of the absolute error (PNG)");
  command->add_option("--heat", params->heat, "Write the error as a heat map with a colour bar (PNG)");
  command->add_option("--heat-scale", params->heat_scale, "Error at the end of the colour bar, of 255")
      ->check(number_between(1.0, 255.0))
      ->capture_default_str();
  command->add_flag("--json", params->json, "Print JSON");
  command->footer(
      R"(Pictures are compared as they look over black: as sRGB on the 0..255 scale, to which floats are rounded.
Besides the metrics it says how many pixels differ, where the largest error is and which block is worst.
Metrics see colours; that two pictures differ in alpha is told on a line of its own.

Example:
  lightbench compare truth.exr mine.png --metric mean_error,pearson --diff difference.png)");
}

}  // namespace lightbench
