#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/image.h"
#include "reports/compare.h"
#include "reports/difference_image.h"
#include "reports/error_place.h"
#include "reports/metric.h"

namespace lightbench {

struct ScoreRequest {
  std::filesystem::path image = {};
  std::filesystem::path reference = {};
  std::filesystem::path baseline = {};  ///< empty: none
  std::filesystem::path baseline_albedo =
      {};  ///< linear; for metrics with needs_ambient_fit; empty: not known
  std::filesystem::path previous_image = {};  ///< of the frame before; empty: none
  std::filesystem::path previous_reference = {};
  std::filesystem::path mask = {};  ///< empty: the reference's alpha, if it has one and is to be used
  std::vector<std::string> metrics = {};
  bool use_reference_alpha = true;  ///< else, without a mask, all pixels count
};

struct Score {
  Image8 image = {};  ///< three components, as all of these
  Image8 reference = {};
  Image8 baseline = {};           ///< empty without one
  std::size_t masked_pixels = 0;  ///< that masked metrics look at
  bool identical = false;         ///< whether image and reference agree in every pixel's colour
  std::map<std::string, MetricValue> metrics = {};
  std::optional<ErrorPlace> place = {};  ///< as `compare` tells it; `compute_score` leaves it out
  AlphaDifference alpha = {};  ///< of two files that are compared; compute_score does not look for it
};

/// Reads the images on the 0..255 scale and computes the metrics. A metric that needs a baseline where there
/// is none is undefined. Throws Error for unreadable images, NaN, and other sizes.
Score compute_score(const ScoreRequest& request);

/// The metrics, the number of masked pixels, the place of the largest error and the difference of alpha, if
/// there are any, as JSON.
std::string score_json(const Score& score);

}  // namespace lightbench
