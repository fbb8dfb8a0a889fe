#include "pipeline/score.h"

#include <algorithm>
#include <optional>

#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/image_io.h"
#include "base/json_bytes.h"
#include "reports/ambient_fit.h"

namespace lightbench {
namespace {

/// One byte a pixel from the last component (alpha, or grey of a mask picture): at least half covered counts.
std::vector<std::uint8_t> mask_from(const Image8& image) {
  std::vector<std::uint8_t> mask(image.pixel_count());
  for (std::size_t i = 0; i < mask.size(); ++i)
    mask[i] = image.data[(i + 1) * std::size_t(image.channels) - 1] >= 128;
  return mask;
}

/// The frame before, as read.
struct PreviousPictures {
  Image8 reference;
  Image8 image;
  std::vector<std::uint8_t> mask;  ///< empty: all pixels

  PreviousFrame frame() const { return {reference, image, mask.empty() ? nullptr : &mask}; }
};

PreviousPictures read_previous(const ScoreRequest& request, const Image8& now) {
  PreviousPictures previous;
  const Image8 reference = read_image_srgb8(request.previous_reference);
  previous.reference = first_channels(reference, 3);
  previous.image = first_channels(read_image_srgb8(request.previous_image), 3);
  check_pair(now, previous.reference, request.reference.string(), request.previous_reference.string());
  check_pair(now, previous.image, request.reference.string(), request.previous_image.string());
  if (request.use_reference_alpha && reference.channels == 4) previous.mask = mask_from(reference);
  return previous;
}

}  // namespace

Score compute_score(const ScoreRequest& request) {
  Score score;
  const Image8 reference = read_image_srgb8(request.reference);
  score.reference = first_channels(reference, 3);
  score.image = first_channels(read_image_srgb8(request.image), 3);
  check_pair(score.reference, score.image, request.reference.string(), request.image.string());
  score.identical = score.image == score.reference;
  if (!request.baseline.empty()) {
    score.baseline = first_channels(read_image_srgb8(request.baseline), 3);
    check_pair(score.reference, score.baseline, request.reference.string(), request.baseline.string());
  }
  std::vector<std::uint8_t> mask;
  if (!request.mask.empty()) {
    const Image8 picture = read_image_srgb8(request.mask);
    check_pair(score.reference, first_channels(picture, 3), request.reference.string(),
               request.mask.string());
    mask = mask_from(picture);
  } else if (request.use_reference_alpha && reference.channels == 4) {
    mask = mask_from(reference);
  }
  score.masked_pixels =
      mask.empty() ? reference.pixel_count() : std::size_t(std::count(mask.begin(), mask.end(), 1));
  std::optional<Image8> ambient_fit;
  if (needs_ambient_fit(request.metrics) && !request.baseline.empty() && !request.baseline_albedo.empty())
    ambient_fit = fit_ambient(read_float_image(request.baseline), read_float_image(request.baseline_albedo),
                              score.reference)
                      .image;
  MetricInput input{score.reference, score.image};
  if (!score.baseline.empty()) input.baseline = &score.baseline;
  if (!mask.empty()) input.mask = &mask;
  if (ambient_fit) input.ambient_fit = &*ambient_fit;
  std::optional<PreviousPictures> previous;
  std::optional<PreviousFrame> previous_frame;
  if (!request.previous_image.empty()) {
    previous = read_previous(request, score.reference);
    input.previous = &previous_frame.emplace(previous->frame());
  }
  score.metrics = compute_metrics(request.metrics, input);
  return score;
}

namespace {

nlohmann::ordered_json box_json(const PixelBox& box) {
  return {{"x", box.x}, {"y", box.y}, {"width", box.width}, {"height", box.height}};
}

/// In pixels from the top left corner.
void add_place(const ErrorPlace& place, nlohmann::ordered_json& json) {
  json["differing_pixels"] = place.differing;
  if (place.differing == 0) return;
  auto& largest = json["largest_error"] = {{"error", place.largest}, {"x", place.x}, {"y", place.y}};
  largest["region"] = box_json(place.region);
  largest["region"]["pixels"] = place.region_pixels;
  json["worst_block"] = box_json(place.block.box);
  json["worst_block"]["mean_error"] = place.block.mean_error;
}

}  // namespace

std::string score_json(const Score& score) {
  nlohmann::ordered_json json = {{"format", 1}, {"object_pixels", score.masked_pixels}};
  for (const auto& [name, value] : score.metrics) {
    if (value.value)
      json["metrics"][name] = *value.value;
    else
      json["metrics"][name] = {{"undefined", value.undefined_because}};
  }
  if (score.place) add_place(*score.place, json);
  if (score.alpha.pixels > 0)
    json["alpha"] = {{"pixels", score.alpha.pixels}, {"largest", score.alpha.largest}};
  return json_text(json, 2) + "\n";
}

}  // namespace lightbench
