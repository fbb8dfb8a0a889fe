#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "reports/error_place.h"
#include "reports/metric.h"

namespace lightbench {

/// Two image files of any kind that can be read, and what to make of them.
struct CompareOptions {
  std::filesystem::path reference{};
  std::filesystem::path image{};
  std::filesystem::path baseline{};  ///< may be empty: then metrics that need one are undefined
  std::string layer{};  ///< of files with named layers; empty: the one without a name, or the only one
  std::string reference_layer{};       ///< the same for the reference; empty: `layer`
  std::filesystem::path mask{};        ///< for masked metrics; empty: the reference's alpha, if it has one
  std::vector<std::string> metrics{};  ///< empty: all that need no more than is given
  std::filesystem::path difference{};  ///< a PNG to write; empty: none
  std::filesystem::path heat{};        ///< the same
  double heat_scale = 64;              ///< of 255: the error at the end of the heat map's bar
};

/// How two pictures differ in alpha; one without alpha is opaque.
struct AlphaDifference {
  std::size_t pixels = 0;  ///< that have another alpha
  int largest = 0;         ///< of 255

  bool operator==(const AlphaDifference&) const = default;
};

struct CompareResult {
  int width = 0;
  int height = 0;
  std::vector<std::pair<std::string, MetricValue>> metrics;  ///< in the order asked for
  std::size_t mask_pixels = 0;                               ///< that masked metrics were computed over
  std::string mask_source;          ///< "all pixels", "alpha of FILE", or the mask's file
  std::optional<ErrorPlace> place;  ///< where the colours differ most, if they do
  AlphaDifference alpha{};          ///< which metrics do not tell of
};

/// Compares what is seen over black (base/image_io.h) on the 0..255 scale of 8-bit sRGB. A mask file counts
/// where its alpha is at least one half; one whose alpha is 1 everywhere, or that has none, counts where a
/// colour component is not 0. Throws Error for a missing or broken file, NaN or infinity in one, sizes that
/// differ, an unknown metric, an output that is no PNG or one of the inputs, and outputs that are one file.
CompareResult compare_files(const CompareOptions& options);

}  // namespace lightbench
