#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "renderer/radiance/radiance_stack.h"
#include "renderer/radiance/rgtc.h"

namespace lightbench {

/// A ByteStack as a weighted sum of a few functions of the direction: one mean and one basis for the whole
/// object, and for each texel a record of fixed size, its coefficients. All of it can be textures as it is:
/// a shader reads any texel at once, and may interpolate coefficients between texels and the basis between
/// directions.
///
/// With u for a number of 0..1 that is stored in 8 or 16 bits (over 255 or 65535) and s for one of -1..1 in
/// 16 bits (over 32767), component c of texel t in direction d is, in steps of 8 bits,
///
///     mean(d, c) + sum over k of coefficient(t, k) * basis(k, d, c)
///     mean(d, c)        = mean_offset + mean_scale * u
///     coefficient(t, k) = offset[k] + scale[k] * u
///     basis(k, d, c)    = s
///
/// clamped to 0..255; for bytes it is rounded to nearest. Where there are corrections, those of the texel
/// for this layer are added then, and each sum is clamped again. They hold a bound only for whoever gets the
/// same bytes before: PcaLine tells how the sum is computed.
///
/// The first coefficients have 16 bits and the next ones 8, each four of them the RGBA of a texel. The rest,
/// which need it least, are compressed by RGTC, each two of them the RG of a texel.
struct PcaStack {
  int width = 0;
  int height = 0;
  DirectionGrid grid;
  float radiance_scale = 1;  ///< the radiance that stands for 255: `scale` of the ByteStack
  /// All directions are the same: mean and basis are kept for one.
  bool matte = false;

  float mean_offset = 0, mean_scale = 0;
  /// RGB of each direction, along phi, then theta, whatever the grid's order of layers.
  std::vector<std::uint16_t> mean = {};
  /// For each four coefficients, which may be more than there are, and each component c one layer of RGBA, of
  /// directions as in `mean`.
  std::vector<std::int16_t> basis = {};

  std::vector<float> offset = {}, scale = {};  ///< by coefficient
  std::vector<std::uint16_t> wide = {};        ///< layers of RGBA, of texels
  std::vector<std::uint8_t> narrow = {};       ///< layers of RGBA, of texels
  std::vector<std::uint64_t> blocks = {};      ///< layers of RG, of blocks of 4 x 4 texels (rgtc.h)

  int correction_step = 0;  ///< 0: there are no corrections
  /// Of each block of 4 x 4 texels its first correction, then their number.
  std::vector<std::uint32_t> first_correction = {};
  std::vector<std::uint32_t> corrections = {};  ///< packed; those of a block by rising key, which may repeat

  std::size_t texels() const { return std::size_t(width) * std::size_t(height); }
  std::size_t directions() const { return matte ? 1 : std::size_t(grid.layers()); }
  std::size_t coefficients() const { return offset.size(); }
  std::size_t wide_coefficients() const { return wide.size() / texels(); }
  std::size_t narrow_coefficients() const { return narrow.size() / texels(); }
  std::size_t blocks_across() const { return std::size_t(width + kRgtcSide - 1) / kRgtcSide; }
  std::size_t blocks_down() const { return std::size_t(height + kRgtcSide - 1) / kRgtcSide; }
  std::size_t block_count() const { return blocks_across() * blocks_down(); }
  std::size_t bytes() const;  ///< of all that a shader reads

  bool operator==(const PcaStack&) const = default;
};

/// `offset + step * stored`, of a number as it is stored, 0..65535 or 0..255. In 32-bit floats, and
/// with coefficients over 32767 and the basis as it is stored, a sum is but sums and products, which are the
/// same to the bit wherever they are rounded one by one, and added by rising k:
///
///     (mean.offset + mean.step * u) + (k0.offset + k0.step * u) * s + (k1.offset + k1.step * u) * s + ...
struct PcaLine {
  float offset, step;
};
PcaLine mean_line(const PcaStack& stack);
std::vector<PcaLine> coefficient_lines(const PcaStack& stack);

/// Where a layer's direction is in `mean`: i_theta * phis + i_phi.
std::size_t direction_index(const PcaStack& stack, int layer);
/// In `basis`, of coefficient k and component c.
std::size_t basis_index(const PcaStack& stack, std::size_t k, std::size_t c, std::size_t direction);

/// Where a texel is among the blocks of 4 x 4.
struct BlockPlace {
  std::size_t block;  ///< row by row
  int place;          ///< in it, 4 y + x
};
BlockPlace block_place(const PcaStack& stack, std::size_t texel);
/// In `blocks`, of the k-th of the compressed coefficients.
std::size_t block_index(const PcaStack& stack, std::size_t block, std::size_t k);

/// What is added to one value, in steps of PcaStack::correction_step.
struct PcaCorrection {
  std::uint32_t key;         ///< layer * 16 + place in the block
  std::array<int, 3> steps;  ///< -kMaxCorrection to kMaxCorrection
};
inline constexpr int kMaxCorrection = 7;

/// Bits 0 to 19 are the key, 20 to 23, 24 to 27 and 28 to 31 the components' steps plus 8.
std::uint32_t pack(const PcaCorrection& correction);
PcaCorrection unpack_correction(std::uint32_t packed);
inline std::uint32_t correction_key(int layer, int place) {
  return std::uint32_t(layer * 16 + place);
}

/// Decodes texels one by one.
class PcaDecoder {
 public:
  explicit PcaDecoder(const PcaStack& stack);

  std::array<std::uint8_t, 3> value(std::size_t texel, int layer) const;
  /// All layers of a texel, in the grid's order; equal to what `value` gives.
  void layers_of(std::size_t texel, std::span<std::array<std::uint8_t, 3>> layers) const;

 private:
  int stored(std::size_t texel, std::size_t k) const;
  float coefficient(std::size_t texel, std::size_t k) const;
  std::span<const std::uint32_t> corrections_of(std::size_t block) const;
  void correct(std::uint32_t packed, std::array<std::uint8_t, 3>& value) const;

  const PcaStack& stack_;
  std::size_t layers_, wide_, narrow_;
  std::vector<PcaLine> lines_;
  std::vector<float> mean_, basis_;  ///< as planes of a component over the grid's layers
};

ByteStack decode_pca(const PcaStack& stack);

}  // namespace lightbench
