#include "renderer/radiance/pca_corrections.h"

#include <algorithm>
#include <cassert>
#include <cstdlib>
#include <numeric>
#include <tuple>

namespace lightbench {
namespace {

using Eigen::Index;
using Steps = std::array<int, 3>;

/// Of what is not negative; far quicker than the library's.
int rounded(float value) {
  const float above = value + 0.5f;
  return int(above);
}

/// Calls `handle(texel, layer, true - decoded)` for all values.
template <typename Handle>
void for_rests(const HalfStack& stack, const TexelPlaces& places, const PcaStack& pca, const Handle& handle) {
  const PcaDecoder decoder(pca);
  const std::size_t layers = std::size_t(stack.grid.layers());
  std::vector<std::array<std::uint8_t, 3>> decoded(layers);
  for_texel_blocks(stack, places, [&](std::size_t, auto block, const Eigen::MatrixXf& values) {
    for (std::size_t i = 0; i < block.size(); ++i) {
      decoder.layers_of(block[i], decoded);
      const float* const value = values.data() + 3 * layers * i;
      for (std::size_t layer = 0; layer < layers; ++layer) {
        Steps rest;
        for (std::size_t c = 0; c < 3; ++c) rest[c] = rounded(value[c * layers + layer]) - decoded[layer][c];
        handle(block[i], int(layer), rest);
      }
    }
  });
}

int sum_of(const Steps& rest) {
  return std::abs(rest[0]) + std::abs(rest[1]) + std::abs(rest[2]);
}

/// The largest step of which whole numbers leave less than the threshold over three components.
int step_below(int threshold) {
  return 2 * ((threshold - 1) / 3) + 1;
}

Steps in_steps(Steps rest, int step) {
  for (int& r : rest) r = (r + (r > 0 ? step / 2 : -(step / 2))) / step;
  return rest;
}

/// The next correction of a value, taken off what is still to be added.
std::uint32_t take_correction(std::uint32_t key, Steps& steps) {
  PcaCorrection correction{key, {}};
  for (std::size_t c = 0; c < 3; ++c) {
    correction.steps[c] = std::clamp(steps[c], -kMaxCorrection, kMaxCorrection);
    steps[c] -= correction.steps[c];
  }
  return pack(correction);
}

}  // namespace

PcaErrors measure_pca(const HalfStack& stack, const TexelPlaces& places, const PcaStack& pca) {
  std::array<std::uint64_t, 3 * 255 + 1> counts{};
  for_rests(stack, places, pca,
            [&](std::uint32_t, int, const Steps& rest) { ++counts[std::size_t(sum_of(rest))]; });
  const std::uint64_t values = std::accumulate(counts.begin(), counts.end(), std::uint64_t(0));
  std::uint64_t sum = 0, seen = 0;
  PcaErrors errors;
  for (std::size_t error = 0; error < counts.size(); ++error) {
    if (counts[error] > 0 && 100 * seen < 99 * values) errors.error_99 = double(error) / 3;
    seen += counts[error];
    sum += error * counts[error];
  }
  if (sum > 0) errors.mean_changed = double(sum) / 3 / double(values - counts[0]);
  return errors;
}

void add_corrections(const HalfStack& stack, const TexelPlaces& places, int threshold, PcaStack& pca) {
  assert(threshold > 0 && pca.correction_step == 0);
  struct Correction {
    std::uint32_t block, key, packed;
    bool operator<(const Correction& other) const {
      return std::tie(block, key, packed) < std::tie(other.block, other.key, other.packed);
    }
  };
  const int step = step_below(threshold);
  std::vector<Correction> corrections;
  for_rests(stack, places, pca, [&](std::uint32_t texel, int layer, const Steps& rest) {
    if (sum_of(rest) < threshold) return;
    const BlockPlace at = block_place(pca, texel);
    const std::uint32_t key = correction_key(layer, at.place);
    for (Steps steps = in_steps(rest, step); steps != Steps{};)
      corrections.push_back({std::uint32_t(at.block), key, take_correction(key, steps)});
  });
  std::sort(corrections.begin(), corrections.end());
  pca.correction_step = step;
  pca.first_correction.assign(pca.block_count() + 1, 0);
  for (const Correction& correction : corrections) {
    ++pca.first_correction[correction.block + 1];
    pca.corrections.push_back(correction.packed);
  }
  std::partial_sum(pca.first_correction.begin(), pca.first_correction.end(), pca.first_correction.begin());
}

}  // namespace lightbench
