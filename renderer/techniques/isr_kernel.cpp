#include "renderer/techniques/isr_kernel.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

#include <glm/geometric.hpp>

namespace lightbench {

namespace {

struct Polar {
  double ring;  ///< 0 .. count: where among the rings
  double angle;
};

/// Samples in rings whose borders lie at radius * (i / count)^spread; `place` says where sample i is.
template <typename Place>
std::vector<KernelSample> rings(int count, float radius, float spread, const Place& place) {
  assert(count > 0 && count <= kMaxKernelSamples);
  const auto distance = [&](double i) { return radius * std::pow(i / count, double(spread)); };
  std::vector<KernelSample> kernel;
  for (int i = 0; i < count; ++i) {
    const Polar at = place(i);
    const double r = distance(at.ring);
    const double inner = distance(i);
    const double outer = distance(i + 1);
    kernel.push_back({{r * std::cos(at.angle), r * std::sin(at.angle)},
                      float(std::numbers::pi * (outer * outer - inner * inner))});
  }
  return kernel;
}

}  // namespace

std::vector<KernelSample> spiral_kernel(int count, float radius, float spread) {
  const double golden_angle = std::numbers::pi * (3 - std::sqrt(5.0));
  return rings(count, radius, spread, [&](int i) { return Polar{i + 0.5, i * golden_angle}; });
}

std::vector<KernelSample> jittered_kernel(int count, float radius, float spread) {
  std::mt19937 random(1);  // the same on every machine, unlike the distributions of <random>
  const auto jitter = [&] { return double(random()) / 4294967296.0; };
  std::vector<int> sectors(std::size_t(std::max(count, 0)));
  std::iota(sectors.begin(), sectors.end(), 0);
  for (std::size_t i = sectors.size(); i > 1; --i)
    std::swap(sectors[i - 1], sectors[std::size_t(jitter() * double(i))]);
  return rings(count, radius, spread, [&](int i) {
    const double ring = i + jitter();
    return Polar{ring, (sectors[std::size_t(i)] + jitter()) * 2 * std::numbers::pi / count};
  });
}

std::vector<KernelSample> grid_kernel(int count, float spacing) {
  assert(count > 0 && count <= kMaxKernelSamples);
  std::vector<KernelSample> kernel;
  for (int ring = 1; int(kernel.size()) < count; ++ring)
    for (int y = -ring; y <= ring; ++y)
      for (int x = -ring; x <= ring; ++x)
        if ((std::abs(x) == ring || std::abs(y) == ring) && int(kernel.size()) < count)
          kernel.push_back({spacing * glm::vec2(x, y), spacing * spacing});
  return kernel;
}

bool fills_grid(int count) {
  const int side = int(std::lround(std::sqrt(double(count) + 1)));
  return side % 2 == 1 && side * side == count + 1;
}

int near_samples(const std::vector<KernelSample>& kernel, int block) {
  if (block == 1) return int(kernel.size());
  const float least = 16.0f * float(block * block);
  const auto far = std::find_if(kernel.begin(), kernel.end(),
                                [&](const KernelSample& sample) { return sample.area >= least; });
  return int(far - kernel.begin());
}

float kernel_reach(const std::vector<KernelSample>& kernel) {
  float reach = 0;
  for (const KernelSample& sample : kernel) reach = std::max(reach, glm::length(sample.offset));
  return reach;
}

}  // namespace lightbench
