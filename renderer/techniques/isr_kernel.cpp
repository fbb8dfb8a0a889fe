#include "renderer/techniques/isr_kernel.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

namespace lightbench {

std::vector<KernelSample> spiral_kernel(int count, float radius, float spread) {
  assert(count > 0 && count <= kMaxKernelSamples);
  const double golden_angle = std::numbers::pi * (3 - std::sqrt(5.0));
  const auto distance = [&](double i) { return radius * std::pow(i / count, double(spread)); };
  std::vector<KernelSample> kernel;
  for (int i = 0; i < count; ++i) {
    const double r = distance(i + 0.5);
    const double inner = distance(i);
    const double outer = distance(i + 1);
    kernel.push_back({{r * std::cos(i * golden_angle), r * std::sin(i * golden_angle)},
                      float(std::numbers::pi * (outer * outer - inner * inner))});
  }
  return kernel;
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
