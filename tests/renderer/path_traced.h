#pragma once

#include <algorithm>
#include <cmath>

#include "base/color.h"
#include "renderer/path_tracer.h"

/// Small path-traced images and numbers of them.
namespace lightbench::test {

inline PathTracerOptions with_bounces(int bounces, int samples = 64) {
  PathTracerOptions options;
  options.bounces = bounces;
  options.samples = samples;
  return options;
}

inline Image traced(const Scene& scene, const View& view, const PathTracerOptions& options, int width = 16,
                    int height = 12) {
  return trace_paths(scene, view, width, height, 1, options).image;
}

inline double mean_of(const Image& image, int channel = 0) {
  double sum = 0;
  for (std::size_t i = 0; i < image.pixel_count(); ++i)
    sum += double(image.data[4 * i + std::size_t(channel)]);
  return sum / double(image.pixel_count());
}

/// Mean absolute difference of the sRGB images, of 255.
inline double difference(const Image& a, const Image& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.data.size(); ++i)
    if (i % 4 != 3)
      sum += 255 * std::abs(double(srgb_encode(std::clamp(a.data[i], 0.0f, 1.0f))) -
                            double(srgb_encode(std::clamp(b.data[i], 0.0f, 1.0f))));
  return sum / double(3 * a.pixel_count());
}

}  // namespace lightbench::test
