#include "reports/ambient_fit.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "base/color.h"
#include "base/error.h"

namespace lightbench {
namespace {

/// Rounded sRGB of linear values in steps of 1/65535, which is finer than the steps of 8 bits.
std::vector<std::uint8_t> encoded_values() {
  Image ramp(65536, 1, 1);
  for (std::size_t i = 0; i < ramp.data.size(); ++i) ramp.data[i] = float(i) / 65535.0f;
  return to_srgb8(ramp).data;
}

/// One component of the pixels that ambient light changes.
struct Samples {
  std::vector<float> direct;
  std::vector<float> albedo;
  std::vector<std::uint8_t> reference;

  std::uint64_t error(double irradiance) const {
    static const std::vector<std::uint8_t> encoded = encoded_values();
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < direct.size(); ++i) {
      const float value = std::clamp(direct[i] + albedo[i] * float(irradiance), 0.0f, 1.0f);
      sum += std::uint64_t(
          std::abs(int(encoded[std::size_t(std::lround(value * 65535.0f))]) - int(reference[i])));
    }
    return sum;
  }
};

Samples samples_of(const Image& direct, const Image& albedo, const Image8& reference, int component) {
  Samples samples;
  for (int y = 0; y < direct.height; ++y)
    for (int x = 0; x < direct.width; ++x) {
      const float reflects = albedo.pixel(x, y)[std::size_t(component)];
      if (!(reflects > 0)) continue;
      samples.direct.push_back(direct.pixel(x, y)[std::size_t(component)]);
      samples.albedo.push_back(reflects);
      samples.reference.push_back(reference.pixel(x, y)[std::size_t(component)]);
    }
  return samples;
}

/// The error has one valley but for rounding: it is bracketed by powers, then narrowed.
double best_irradiance(const Samples& samples) {
  constexpr double kSmallest = 1e-4;
  constexpr double kFactor = 1.25;
  constexpr int kPowers = 60;   // up to 65
  constexpr int kHalvings = 7;  // down to a step of 0.2 %
  double best = 0;
  std::uint64_t least = samples.error(0);
  for (int i = 0; i < kPowers; ++i) {
    const double candidate = kSmallest * std::pow(kFactor, i);
    if (const std::uint64_t error = samples.error(candidate); error < least) least = error, best = candidate;
  }
  double step = (kFactor - 1) / 2;
  for (int halvings = 0; halvings < kHalvings; ++halvings, step /= 2)
    for (const double candidate : {best * (1 - step), best * (1 + step)})
      if (const std::uint64_t error = samples.error(candidate); error < least)
        least = error, best = candidate;
  return best;
}

}  // namespace

AmbientFit fit_ambient(const Image& direct, const Image& albedo, const Image8& reference) {
  const auto fits = [&](const auto& image) {
    return image.width == direct.width && image.height == direct.height && image.channels >= 3;
  };
  if (!fits(direct) || !fits(albedo) || !fits(reference))
    throw Error("the direct light, its albedo and the reference do not belong together");
  AmbientFit fit;
  Image image(direct.width, direct.height, 3);
  for (int c = 0; c < 3; ++c) {
    const double irradiance = best_irradiance(samples_of(direct, albedo, reference, c));
    fit.irradiance[std::size_t(c)] = irradiance;
    for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x)
        image.pixel(x, y)[std::size_t(c)] =
            direct.pixel(x, y)[std::size_t(c)] + albedo.pixel(x, y)[std::size_t(c)] * float(irradiance);
  }
  fit.image = to_srgb8(image);
  return fit;
}

}  // namespace lightbench
