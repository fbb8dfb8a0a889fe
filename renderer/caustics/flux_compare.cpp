#include "renderer/caustics/flux_compare.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <functional>

namespace lightbench {
namespace {

/// Mean over the texels around that count, of those that count.
std::vector<double> smoothed(const FluxField& field, const std::vector<bool>& counts, double most) {
  std::vector<double> result;
  for (int y = 0; y < field.size; ++y)
    for (int x = 0; x < field.size; ++x) {
      const auto at = [&](int i, int j) { return std::size_t(j) * std::size_t(field.size) + std::size_t(i); };
      if (!counts[at(x, y)]) continue;
      double sum = 0;
      int count = 0;
      for (int j = std::max(y - 1, 0); j <= std::min(y + 1, field.size - 1); ++j)
        for (int i = std::max(x - 1, 0); i <= std::min(x + 1, field.size - 1); ++i)
          if (counts[at(i, j)]) sum += field.values[at(i, j)], ++count;
      result.push_back(std::min(sum / count, most));
    }
  return result;
}

double mean(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return values.empty() ? 0 : sum / double(values.size());
}

bool same_everywhere(const std::vector<double>& values) {
  return std::ranges::adjacent_find(values, std::not_equal_to()) == values.end();
}

std::optional<double> pearson(const std::vector<double>& a, const std::vector<double>& b) {
  if (same_everywhere(a) || same_everywhere(b)) return std::nullopt;
  const double mean_a = mean(a), mean_b = mean(b);
  double ab = 0, aa = 0, bb = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    ab += (a[i] - mean_a) * (b[i] - mean_b);
    aa += (a[i] - mean_a) * (a[i] - mean_a);
    bb += (b[i] - mean_b) * (b[i] - mean_b);
  }
  return ab / std::sqrt(aa * bb);
}

}  // namespace

FluxField flux_field(const FluxMap& map) {
  FluxField field{map.size, {}, std::vector<bool>(map.texels.size(), true)};
  for (const glm::vec3& texel : map.texels) field.values.push_back(double(texel.r));
  return field;
}

FluxField flux_field(const Image& map) {
  FluxField field{map.width, {}, std::vector<bool>(map.pixel_count(), true)};
  for (int y = map.height; y-- > 0;)
    for (int x = 0; x < map.width; ++x) field.values.push_back(double(map.pixel(x, y)[0]));
  return field;
}

FluxLikeness compare_flux(const FluxField& map, const FluxField& truth, double most) {
  assert(map.size == truth.size);
  std::vector<bool> counts;
  double sum = 0, true_sum = 0;
  for (std::size_t i = 0; i < map.values.size(); ++i) {
    counts.push_back(map.counts[i] && truth.counts[i]);
    if (!counts.back()) continue;
    sum += map.values[i];
    true_sum += truth.values[i];
  }
  return {pearson(smoothed(map, counts, most), smoothed(truth, counts, most)),
          true_sum > 0 ? std::optional(sum / true_sum) : std::nullopt};
}

std::size_t differing_texels(const Image& a, const Image& b) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.data.size(); i += 4)
    count += !std::equal(a.data.begin() + std::ptrdiff_t(i), a.data.begin() + std::ptrdiff_t(i) + 3,
                         b.data.begin() + std::ptrdiff_t(i));
  return count;
}

}  // namespace lightbench
