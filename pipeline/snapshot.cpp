#include "pipeline/snapshot.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/atomic_file.h"
#include "base/color.h"
#include "base/error.h"
#include "base/text.h"

namespace lightbench {
namespace {

Image8 rounded(const Image& image) {
  Image8 result(image.width, image.height, image.channels);
  std::transform(image.data.begin(), image.data.end(), result.data.begin(), [](float value) {
    return static_cast<std::uint8_t>(
        std::lround(std::clamp(std::isnan(value) ? 0.0f : value, 0.0f, 1.0f) * 255));
  });
  return result;
}

/// Values mapped to 0..1 for the eye.
Image for_the_eye(Image buffer) {
  const auto [least, greatest] = std::minmax_element(buffer.data.begin(), buffer.data.end());
  if (buffer.data.empty() || !std::isfinite(*least) || !std::isfinite(*greatest)) return buffer;
  const float low = *least;
  const float range = *greatest - low;
  if (buffer.channels == 1 && range > 0) {
    for (float& value : buffer.data) value = (value - low) / range;
  } else if (low < 0) {
    for (float& value : buffer.data) value = 0.5f * value + 0.5f;
  }
  return buffer;
}

void check_finite(const Image& image, const std::filesystem::path& file) {
  if (const auto bad = first_non_finite(image); bad >= 0) {
    const auto pixel = bad / image.channels;
    throw Error("the image has a value that is not a number at pixel (" +
                    std::to_string(pixel % image.width) + ", " + std::to_string(pixel / image.width) + ")",
                file.string());
  }
}

std::vector<std::string> write_half(const std::filesystem::path& exr, const Image& image,
                                    const ImageMetadata& metadata) {
  const std::size_t clamped = write_exr(exr, image, PixelType::half, metadata);
  if (clamped == 0) return {};
  return {
      fmt::format("{} of {} pixels have a number beyond {:.0f}, the largest 16-bit float, and were written "
                  "with that",
                  clamped, image.pixel_count(), kLargestHalf)};
}

}  // namespace

std::vector<std::string> write_image_pair(const std::filesystem::path& exr, const std::filesystem::path& png,
                                          const Image& image, const ImageMetadata& metadata) {
  check_finite(image, exr);
  auto warnings = write_half(exr, image, metadata);
  write_png(png, first_channels(read_image_srgb8(exr), 3));
  return warnings;
}

std::vector<std::string> write_picture(const std::filesystem::path& file, const Image& image) {
  check_finite(image, file);
  if (file.extension() == ".exr") return write_half(file, image, {});
  write_png(file, first_channels(to_srgb8(image), 3));
  return {};
}

void write_buffer_pair(const std::filesystem::path& exr, const std::filesystem::path& png,
                       const Image& buffer) {
  write_exr(exr, buffer, PixelType::float32);
  write_png(png, rounded(for_the_eye(buffer)));
}

void require_writable(const std::filesystem::path& file) {
  AtomicFile(file).write(" ");
}

GlBackend parse_gl(const std::string& text, const std::string& where) {
  if (text == "osmesa") return GlBackend::osmesa;
  if (text == "egl") return GlBackend::egl;
  throw Error("must be osmesa or egl, not '" + text + "'", where);
}

}  // namespace lightbench
