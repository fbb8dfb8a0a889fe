#include "reports/compare.h"

#include <algorithm>
#include <cstdlib>
#include <optional>

#include <fmt/format.h>

#include "base/error.h"
#include "base/file_clashes.h"
#include "base/image_io.h"
#include "reports/difference_image.h"

namespace lightbench {
namespace {

using std::filesystem::path;

struct Mask {
  std::vector<std::uint8_t> pixels;
  std::string source;
};

Image8 colors(const Image8& image) {
  return image.channels == 3 ? image : first_channels(image, 3);
}

bool has_transparency(const Image8& image) {
  if (image.channels != 4) return false;
  for (std::size_t i = 3; i < image.data.size(); i += 4)
    if (image.data[i] != 255) return true;
  return false;
}

int alpha_of(const Image8& image, std::size_t pixel) {
  return image.channels == 4 ? image.data[4 * pixel + 3] : 255;
}

AlphaDifference alpha_difference(const Image8& reference, const Image8& image) {
  AlphaDifference difference;
  for (std::size_t i = 0; i < reference.pixel_count(); ++i) {
    const int here = std::abs(alpha_of(reference, i) - alpha_of(image, i));
    difference.pixels += here != 0;
    difference.largest = std::max(difference.largest, here);
  }
  return difference;
}

Mask read_mask(const path& file, const Image8& reference) {
  const Image8 image = read_image_srgb8(file);
  if (image.width != reference.width || image.height != reference.height)
    throw Error(fmt::format("the mask is {}x{}, the images are {}x{}", image.width, image.height,
                            reference.width, reference.height),
                file.string());
  if (has_transparency(image)) return {object_mask(image), file.string()};
  Mask mask{std::vector<std::uint8_t>(image.pixel_count()), file.string()};
  const Image8 color = colors(image);
  for (std::size_t i = 0; i < mask.pixels.size(); ++i)
    mask.pixels[i] = color.data[3 * i] != 0 || color.data[3 * i + 1] != 0 || color.data[3 * i + 2] != 0;
  return mask;
}

Mask choose_mask(const CompareOptions& options, const Image8& reference) {
  if (!options.mask.empty()) return read_mask(options.mask, reference);
  const bool alpha = has_transparency(reference);
  return {object_mask(reference), alpha ? "alpha of " + options.reference.string() : "all pixels"};
}

std::vector<std::string> chosen_metrics(const CompareOptions& options) {
  for (const std::string& name : options.metrics) find_metric(name, "--metric");
  if (!options.metrics.empty()) return options.metrics;
  std::vector<std::string> names;
  for (const Metric& metric : metrics())
    if (!metric.needs_ambient_fit && !metric.needs_previous &&
        (!metric.needs_baseline || !options.baseline.empty()))
      names.push_back(metric.name);
  return names;
}

void check_files(const CompareOptions& options) {
  const NamedFile outputs[] = {{"the difference image", options.difference}, {"the heat map", options.heat}};
  const NamedFile inputs[] = {{"the reference", options.reference},
                              {"the image", options.image},
                              {"the baseline", options.baseline},
                              {"the mask", options.mask}};
  for (const NamedFile& output : outputs)
    if (!output.path.empty() && output.path.extension() != ".png")
      throw Error("the name of a picture to write must end in .png", output.path.string());
  check_outputs(outputs, inputs);
}

}  // namespace

CompareResult compare_files(const CompareOptions& options) {
  const std::vector<std::string> names = chosen_metrics(options);
  check_files(options);

  const std::string& reference_layer =
      options.reference_layer.empty() ? options.layer : options.reference_layer;
  const Image8 reference_file = read_image_srgb8(options.reference, reference_layer);
  const Image8 reference = colors(reference_file);
  const Image8 image_file = read_image_srgb8(options.image, options.layer);
  const Image8 image = colors(image_file);
  check_pair(reference, image, options.reference.string(), options.image.string());
  std::optional<Image8> baseline;
  if (!options.baseline.empty()) {
    baseline = colors(read_image_srgb8(options.baseline, options.layer));
    check_pair(reference, *baseline, options.reference.string(), options.baseline.string());
  }
  const Mask mask = choose_mask(options, reference_file);

  CompareResult result{.width = reference.width,
                       .height = reference.height,
                       .metrics = {},
                       .mask_pixels = 0,
                       .mask_source = mask.source,
                       .place = find_error(reference, image),
                       .alpha = alpha_difference(reference_file, image_file)};
  result.mask_pixels =
      std::size_t(std::ranges::count_if(mask.pixels, [](std::uint8_t counts) { return counts != 0; }));
  const auto values =
      compute_metrics(names, {reference, image, baseline ? &*baseline : nullptr, &mask.pixels});
  for (const std::string& name : names) result.metrics.emplace_back(name, values.at(name));

  if (!options.difference.empty()) write_png(options.difference, difference_image(reference, image));
  if (!options.heat.empty()) write_png(options.heat, heat_map(reference, image, options.heat_scale));
  return result;
}

}  // namespace lightbench
