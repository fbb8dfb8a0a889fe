#include "renderer/radiance/pca_textures.h"

#include <cstddef>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

namespace lightbench {
namespace {

/// An array of the layers that follow one another in memory; empty where there are none.
template <typename Entry>
GlTexture layers_of(TexelFormat format, glm::ivec2 size, const std::vector<Entry>& entries,
                    std::size_t layer_entries, Wrap wrap) {
  if (entries.empty()) return {};
  const int layers = int(entries.size() / layer_entries);
  GlTexture texture = GlTexture::array(format, size.x, size.y, layers, Filter::linear, wrap);
  for (int layer = 0; layer < layers; ++layer)
    texture.upload_layer(
        layer, std::as_bytes(std::span(entries).subspan(std::size_t(layer) * layer_entries, layer_entries)));
  return texture;
}

template <typename Entry>
BufferTexture buffer_texture_of(BufferFormat format, const std::vector<Entry>& entries) {
  return BufferTexture(format, entries.data(), entries.size());
}

/// What both ways of drawing read: units 2 to 5.
class CommonTextures {
 public:
  explicit CommonTextures(const PcaStack& stack)
      : groups_(int(stack.wide_coefficients() / 4), int(stack.narrow_coefficients() / 4)),
        compressed_(int(stack.coefficients()) - 4 * (groups_.x + groups_.y)) {
    const glm::ivec2 directions =
        stack.matte ? glm::ivec2(1) : glm::ivec2(stack.grid.phis, stack.grid.thetas);
    const glm::ivec2 texels(stack.width, stack.height);
    mean_ =
        layers_of(TexelFormat::rgb16, directions, stack.mean, 3 * stack.directions(), Wrap::repeat_across);
    basis_ = layers_of(TexelFormat::rgba16_snorm, directions, stack.basis, 4 * stack.directions(),
                       Wrap::repeat_across);
    wide_ = layers_of(TexelFormat::rgba16, texels, stack.wide, 4 * stack.texels(), Wrap::clamp);
    narrow_ = layers_of(TexelFormat::rgba8, texels, stack.narrow, 4 * stack.texels(), Wrap::clamp);
  }

  void bind(const Program& program) const {
    unsigned unit = 2;
    for (const GlTexture* texture : {&mean_, &basis_, &wide_, &narrow_}) texture->bind(unit++);
    program.set("groups", groups_);
    program.set("compressed", compressed_);
  }

 private:
  GlTexture mean_, basis_, wide_, narrow_;
  glm::ivec2 groups_;  ///< of four coefficients: of 16 bits, of 8
  int compressed_;     ///< coefficients
};

constexpr unsigned kBlocks = 6;
constexpr unsigned kCoefficients = 3;  // a storage buffer

class InterpolatedPca : public RadianceTextures {
 public:
  explicit InterpolatedPca(const PcaStack& stack)
      : common_(stack),
        blocks_(layers_of(TexelFormat::rg_rgtc2, {stack.width, stack.height}, stack.blocks,
                          2 * stack.block_count(), Wrap::clamp)),
        mean_range_(stack.mean_offset, stack.mean_scale) {
    std::vector<glm::vec2> ranges;
    for (std::size_t k = 0; k < stack.coefficients(); ++k)
      ranges.emplace_back(stack.offset[k], stack.scale[k]);
    ranges_ = buffer_of(ranges);
  }

  void bind(const Program& program) const override {
    common_.bind(program);
    blocks_.bind(kBlocks);
    ranges_.bind_storage(kCoefficients);
    program.set("mean_range", mean_range_);
  }

 private:
  CommonTextures common_;
  GlTexture blocks_;
  Buffer ranges_;
  glm::vec2 mean_range_;
};

class CorrectedPca : public RadianceTextures {
 public:
  explicit CorrectedPca(const PcaStack& stack)
      : common_(stack),
        blocks_(buffer_texture_of(BufferFormat::rg32ui, stack.blocks)),
        first_corrections_(buffer_texture_of(BufferFormat::r32ui, stack.first_correction)),
        corrections_(buffer_texture_of(BufferFormat::r32ui, stack.corrections)),
        lines_(buffer_of(coefficient_lines(stack))),
        mean_line_(mean_line(stack).offset, mean_line(stack).step),
        step_(stack.correction_step) {}

  void bind(const Program& program) const override {
    common_.bind(program);
    unsigned unit = kBlocks;
    for (const BufferTexture* texture : {&blocks_, &first_corrections_, &corrections_}) texture->bind(unit++);
    lines_.bind_storage(kCoefficients);
    program.set("mean_line", mean_line_);
    program.set("correction_step", step_);
  }

 private:
  CommonTextures common_;
  BufferTexture blocks_, first_corrections_, corrections_;
  Buffer lines_;
  glm::vec2 mean_line_;
  int step_;
};

}  // namespace

std::unique_ptr<RadianceTextures> interpolated_pca(const PcaStack& stack) {
  return std::make_unique<InterpolatedPca>(stack);
}

std::unique_ptr<RadianceTextures> corrected_pca(const PcaStack& stack) {
  return std::make_unique<CorrectedPca>(stack);
}

}  // namespace lightbench
