#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/image.h"
#include "renderer/caustics/light_tracer.h"

/// Comparing maps of flux: their red, after a box of 3 x 3 texels and clipped, so that neither a single texel
/// where light folds nor noise decides.
namespace lightbench::test {

using FluxImages = std::vector<double>;  ///< row by row, from w = 0

inline FluxImages comparable(const std::vector<double>& flux, int size, double most = 8) {
  FluxImages result;
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      double sum = 0;
      int count = 0;
      for (int j = std::max(y - 1, 0); j <= std::min(y + 1, size - 1); ++j)
        for (int i = std::max(x - 1, 0); i <= std::min(x + 1, size - 1); ++i, ++count)
          sum += flux[std::size_t(j * size + i)];
      result.push_back(std::min(sum / count, most));
    }
  return result;
}

inline FluxImages comparable(const FluxMap& map) {
  std::vector<double> flux;
  for (const glm::vec3& texel : map.texels) flux.push_back(double(texel.r));
  return comparable(flux, map.size);
}

/// Of a map as read back, whose row 0 is on top.
inline FluxImages comparable(const Image& map) {
  std::vector<double> flux;
  for (int y = map.height; y-- > 0;)
    for (int x = 0; x < map.width; ++x) flux.push_back(double(map.pixel(x, y)[0]));
  return comparable(flux, map.width);
}

inline double mean(const FluxImages& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return sum / double(values.size());
}

/// Pearson's.
inline double correlation(const FluxImages& a, const FluxImages& b) {
  const double mean_a = mean(a), mean_b = mean(b);
  double ab = 0, aa = 0, bb = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    ab += (a[i] - mean_a) * (b[i] - mean_b);
    aa += (a[i] - mean_a) * (a[i] - mean_a);
    bb += (b[i] - mean_b) * (b[i] - mean_b);
  }
  return ab / std::sqrt(aa * bb);
}

}  // namespace lightbench::test
