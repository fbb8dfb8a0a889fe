#include "renderer/radiance/pca_quantizer.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lightbench {
namespace {

using Eigen::Index;
using Eigen::VectorXf;

struct Range {
  explicit Range(const VectorXf& numbers) : least(numbers.minCoeff()), span(numbers.maxCoeff() - least) {}
  /// The whole range is 0..max.
  float scaled(float number, float max) const { return span > 0 ? max * ((number - least) / span) : 0; }
  float rounded(float number, float max) const {
    return std::clamp(std::round(scaled(number, max)), 0.0f, max);
  }

  float least, span;
};

/// Each axis is stretched so that its largest component is 1: `stretch` tells by how much.
void store_axes(const PcaAxes& axes, const VectorXf& stretch, PcaStack& pca) {
  const std::size_t layers = pca.directions();
  const Range range(axes.mean);
  pca.mean_offset = range.least, pca.mean_scale = range.span;
  pca.mean.resize(3 * layers);
  pca.basis.resize(12 * layers * ((pca.coefficients() + 3) / 4));
  for (std::size_t layer = 0; layer < layers; ++layer)
    for (std::size_t c = 0; c < 3; ++c) {
      const std::size_t direction = direction_index(pca, int(layer));
      const Index row = Index(c * layers + layer);
      pca.mean[3 * direction + c] = std::uint16_t(range.rounded(axes.mean[row], 65535));
      for (std::size_t k = 0; k < std::size_t(stretch.size()); ++k) {
        const float value = axes.vectors(row, Index(k)) * stretch[Index(k)];
        pca.basis[basis_index(pca, k, c, direction)] =
            std::int16_t(std::lround(32767 * std::clamp(value, -1.0f, 1.0f)));
      }
    }
}

/// `layers` of RGBA.
template <typename Number>
void store_plain(std::size_t k, const VectorXf& numbers, const Range& range, const TexelPlaces& places,
                 std::size_t texels, std::vector<Number>& layers) {
  for (std::size_t i = 0; i < places.size(); ++i)
    layers[4 * (k / 4 * texels + places[i]) + k % 4] =
        Number(range.rounded(numbers[Index(i)], std::numeric_limits<Number>::max()));
}

void store_compressed(std::size_t k, const VectorXf& numbers, const Range& range, const TexelPlaces& places,
                      PcaStack& pca) {
  struct Block {
    std::array<float, 16> numbers{};
    std::uint32_t counts = 0;
  };
  std::vector<Block> blocks(pca.block_count());
  for (std::size_t i = 0; i < places.size(); ++i) {
    const BlockPlace at = block_place(pca, places[i]);
    blocks[at.block].numbers[std::size_t(at.place)] = range.scaled(numbers[Index(i)], 255);
    blocks[at.block].counts |= 1u << at.place;
  }
  for (std::size_t i = 0; i < blocks.size(); ++i)
    pca.blocks[block_index(pca, i, k)] = encode_rgtc(blocks[i].numbers, blocks[i].counts);
}

}  // namespace

PcaStack quantized(const HalfStack& stack, const TexelPlaces& places, const PcaAxes& axes,
                   const Eigen::MatrixXf& coefficients, const PcaLayout& layout) {
  PcaStack pca{
      .width = stack.width, .height = stack.height, .grid = stack.grid, .radiance_scale = stack.scale};
  pca.offset.resize(layout.coefficients()), pca.scale.resize(layout.coefficients());
  pca.wide.resize(layout.wide * pca.texels());
  pca.narrow.resize(layout.narrow * pca.texels());
  pca.blocks.resize(layout.compressed * pca.block_count());
  const Index kept = std::min(Index(layout.coefficients()), axes.vectors.cols());
  const VectorXf sizes = axes.vectors.leftCols(kept).cwiseAbs().colwise().maxCoeff();
  store_axes(axes, sizes.cwiseInverse(), pca);
  for (std::size_t k = 0; k < std::size_t(kept); ++k) {
    const VectorXf numbers = coefficients.row(Index(k)) * sizes[Index(k)];
    const Range range(numbers);
    pca.offset[k] = range.least, pca.scale[k] = range.span;
    if (k < layout.wide)
      store_plain(k, numbers, range, places, pca.texels(), pca.wide);
    else if (k < layout.wide + layout.narrow)
      store_plain(k - layout.wide, numbers, range, places, pca.texels(), pca.narrow);
    else
      store_compressed(k - layout.wide - layout.narrow, numbers, range, places, pca);
  }
  return pca;
}

PcaStack matte_pca(const HalfStack& stack, const TexelPlaces& places) {
  PcaStack pca{.width = stack.width,
               .height = stack.height,
               .grid = stack.grid,
               .radiance_scale = stack.scale,
               .matte = true};
  pca.mean.resize(3), pca.basis.resize(12);
  pca.offset.resize(4), pca.scale = {255, 255, 255, 0};
  pca.narrow.resize(4 * pca.texels());
  for (std::size_t c = 0; c < 3; ++c) pca.basis[basis_index(pca, c, c, 0)] = 32767;
  for_texel_blocks(stack, places, [&](std::size_t, auto block, const Eigen::MatrixXf& values) {
    for (std::size_t i = 0; i < block.size(); ++i)
      for (std::size_t c = 0; c < 3; ++c)
        pca.narrow[4 * block[i] + c] =
            std::uint8_t(std::lround(values(Index(c) * stack.grid.layers(), Index(i))));
  });
  return pca;
}

}  // namespace lightbench
