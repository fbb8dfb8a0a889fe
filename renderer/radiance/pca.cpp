#include "renderer/radiance/pca.h"

#include <algorithm>

namespace lightbench {
namespace {

using Rgb8 = std::array<std::uint8_t, 3>;

/// Of what is not a number, as a damaged file may give, 0.
std::uint8_t byte_of(float value) {
  return std::uint8_t(value > 0 ? std::min(value, 255.0f) + 0.5f : 0.5f);
}

constexpr std::uint32_t kKeyMask = (1u << 20) - 1;

}  // namespace

std::size_t PcaStack::bytes() const {
  const auto size = [](const auto& numbers) { return numbers.size() * sizeof numbers[0]; };
  return size(mean) + size(basis) + size(offset) + size(scale) + size(wide) + size(narrow) + size(blocks) +
         size(first_correction) + size(corrections);
}

PcaLine mean_line(const PcaStack& stack) {
  return {stack.mean_offset, stack.mean_scale / 65535};
}

std::vector<PcaLine> coefficient_lines(const PcaStack& stack) {
  const std::size_t wide = stack.wide_coefficients();
  std::vector<PcaLine> lines;
  for (std::size_t k = 0; k < stack.coefficients(); ++k)
    lines.push_back({stack.offset[k] / 32767, stack.scale[k] / 32767 / (k < wide ? 65535.0f : 255.0f)});
  return lines;
}

std::size_t direction_index(const PcaStack& stack, int layer) {
  if (stack.matte) return 0;
  const glm::ivec2 place = stack.grid.place(layer);
  return std::size_t(place.x) * std::size_t(stack.grid.phis) + std::size_t(place.y);
}

std::size_t basis_index(const PcaStack& stack, std::size_t k, std::size_t c, std::size_t direction) {
  return 4 * ((3 * (k / 4) + c) * stack.directions() + direction) + k % 4;
}

BlockPlace block_place(const PcaStack& stack, std::size_t texel) {
  const std::size_t width = std::size_t(stack.width), x = texel % width, y = texel / width;
  return {y / kRgtcSide * stack.blocks_across() + x / kRgtcSide,
          int(y % kRgtcSide * kRgtcSide + x % kRgtcSide)};
}

std::size_t block_index(const PcaStack& stack, std::size_t block, std::size_t k) {
  return 2 * (k / 2 * stack.block_count() + block) + k % 2;
}

std::uint32_t pack(const PcaCorrection& correction) {
  std::uint32_t packed = correction.key;
  for (std::size_t c = 0; c < 3; ++c) packed |= std::uint32_t(correction.steps[c] + 8) << (20 + 4 * c);
  return packed;
}

PcaCorrection unpack_correction(std::uint32_t packed) {
  const auto step = [&](int c) { return int((packed >> (20 + 4 * c)) & 15) - 8; };
  return {packed & kKeyMask, {step(0), step(1), step(2)}};
}

PcaDecoder::PcaDecoder(const PcaStack& stack)
    : stack_(stack),
      layers_(stack.directions()),
      wide_(stack.wide_coefficients()),
      narrow_(stack.narrow_coefficients()),
      lines_(coefficient_lines(stack)),
      mean_(3 * layers_),
      basis_(3 * layers_ * stack.coefficients()) {
  const PcaLine line = mean_line(stack);
  for (std::size_t layer = 0; layer < layers_; ++layer) {
    const std::size_t d = direction_index(stack, int(layer));
    for (std::size_t c = 0; c < 3; ++c) {
      mean_[c * layers_ + layer] = line.offset + line.step * float(stack.mean[3 * d + c]);
      for (std::size_t k = 0; k < stack.coefficients(); ++k)
        basis_[(3 * k + c) * layers_ + layer] = float(stack.basis[basis_index(stack, k, c, d)]);
    }
  }
}

int PcaDecoder::stored(std::size_t texel, std::size_t k) const {
  const auto at = [&](std::size_t i) { return 4 * (i / 4 * stack_.texels() + texel) + i % 4; };
  if (k < wide_) return stack_.wide[at(k)];
  if (k < wide_ + narrow_) return stack_.narrow[at(k - wide_)];
  const BlockPlace at_block = block_place(stack_, texel);
  const std::size_t index = block_index(stack_, at_block.block, k - wide_ - narrow_);
  return decode_rgtc(stack_.blocks[index], at_block.place);
}

/// Over 32767.
float PcaDecoder::coefficient(std::size_t texel, std::size_t k) const {
  return lines_[k].offset + lines_[k].step * float(stored(texel, k));
}

std::span<const std::uint32_t> PcaDecoder::corrections_of(std::size_t block) const {
  const std::size_t first = stack_.first_correction[block];
  return std::span(stack_.corrections).subspan(first, stack_.first_correction[block + 1] - first);
}

void PcaDecoder::correct(std::uint32_t packed, Rgb8& value) const {
  const PcaCorrection correction = unpack_correction(packed);
  for (std::size_t c = 0; c < 3; ++c)
    value[c] = std::uint8_t(std::clamp(value[c] + stack_.correction_step * correction.steps[c], 0, 255));
}

Rgb8 PcaDecoder::value(std::size_t texel, int layer) const {
  Rgb8 value;
  const std::size_t place = stack_.matte ? 0 : std::size_t(layer);
  for (std::size_t c = 0; c < 3; ++c) {
    float sum = mean_[c * layers_ + place];
    for (std::size_t k = 0; k < stack_.coefficients(); ++k)
      sum += coefficient(texel, k) * basis_[(3 * k + c) * layers_ + place];
    value[c] = byte_of(sum);
  }
  if (stack_.correction_step == 0) return value;
  const BlockPlace at = block_place(stack_, texel);
  const std::span corrections = corrections_of(at.block);
  const std::uint32_t key = correction_key(layer, at.place);
  const auto is_before = [](std::uint32_t packed, std::uint32_t k) { return (packed & kKeyMask) < k; };
  for (auto i = std::lower_bound(corrections.begin(), corrections.end(), key, is_before);
       i != corrections.end() && (*i & kKeyMask) == key; ++i)
    correct(*i, value);
  return value;
}

/// Adds in the order of `value`, and this file is built without fused additions, so that both are equal.
void PcaDecoder::layers_of(std::size_t texel, std::span<Rgb8> layers) const {
  std::vector<float> sums = mean_;
  for (std::size_t k = 0; k < stack_.coefficients(); ++k) {
    const float factor = coefficient(texel, k);
    const float* const basis = basis_.data() + k * sums.size();
    for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += factor * basis[i];
  }
  for (std::size_t layer = 0; layer < layers.size(); ++layer) {
    const std::size_t place = stack_.matte ? 0 : layer;
    for (std::size_t c = 0; c < 3; ++c) layers[layer][c] = byte_of(sums[c * layers_ + place]);
  }
  if (stack_.correction_step == 0) return;
  const BlockPlace at = block_place(stack_, texel);
  for (const std::uint32_t packed : corrections_of(at.block))
    if (int(packed % 16) == at.place) correct(packed, layers[(packed & kKeyMask) / 16]);
}

ByteStack decode_pca(const PcaStack& stack) {
  const std::size_t layers = std::size_t(stack.grid.layers());
  ByteStack bytes{stack.width, stack.height, stack.grid, stack.radiance_scale, {}};
  bytes.texels.resize(stack.texels() * layers);
  const PcaDecoder decoder(stack);
  constexpr std::size_t kBlock = 64;  // texels that are written to each layer in turn
  std::vector<Rgb8> values(kBlock * layers);
  for (std::size_t first = 0; first < stack.texels(); first += kBlock) {
    const std::size_t count = std::min(kBlock, stack.texels() - first);
    for (std::size_t i = 0; i < count; ++i)
      decoder.layers_of(first + i, std::span(values).subspan(i * layers, layers));
    for (std::size_t layer = 0; layer < layers; ++layer)
      for (std::size_t i = 0; i < count; ++i)
        bytes.texels[layer * stack.texels() + first + i] = values[i * layers + layer];
  }
  return bytes;
}

}  // namespace lightbench
