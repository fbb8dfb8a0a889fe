#pragma once

#include <string>
#include <vector>

#include <glm/vec2.hpp>

namespace lightbench {

/// What techniques/isr/gather.frag.glsl has room for.
inline constexpr int kMaxKernelSamples = 1000;
inline constexpr int kMaxKernelLevels = 5;

struct KernelSample {
  glm::vec2 offset;  ///< in pixels of the coarse image
  float area;        ///< its share of the kernel, in pixels of the coarse image squared
};

/// A golden-angle spiral in a disc of `radius`: sample i lies at the distance radius * ((i + 1/2) /
/// count)^spread. At spread 1/2 the samples are uniform in area; greater ones crowd at the centre. Shares are
/// the areas of the rings between samples and add up to the disc.
std::vector<KernelSample> spiral_kernel(int count, float radius, float spread);

/// The same with one sample anywhere in each ring, and one in each of `count` equal sectors (a Latin square),
/// by a fixed rule.
std::vector<KernelSample> jittered_kernel(int count, float radius, float spread);

/// The cells of the smallest square grid around the centre that has `count` of them besides the centre
/// itself, nearest rings first; `spacing` apart. Each share is a cell.
std::vector<KernelSample> grid_kernel(int count, float spacing);

/// 8, 24, 48, 80, ...: the counts that fill a grid.
bool fills_grid(int count);

/// How many samples from the first one on stand for less than 16 blocks of `block` by `block` pixels: they
/// read the coarse image itself, those after them the blocks. All where `block` is 1.
int near_samples(const std::vector<KernelSample>& kernel, int block);

/// The length of the longest offset.
float kernel_reach(const std::vector<KernelSample>& kernel);

}  // namespace lightbench
