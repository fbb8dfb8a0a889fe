#include "renderer/radiance/pca_codec.h"

#include <glm/vec2.hpp>

#include "renderer/radiance/pca_encoder.h"
#include "renderer/radiance/pca_file.h"

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

std::vector<glm::vec2> ranges_of(const PcaStack& stack) {
  std::vector<glm::vec2> ranges;
  for (std::size_t k = 0; k < stack.coefficients(); ++k) ranges.emplace_back(stack.offset[k], stack.scale[k]);
  return ranges;
}

class PcaTextures : public RadianceTextures {
 public:
  explicit PcaTextures(const PcaStack& stack)
      : mean_range_(stack.mean_offset, stack.mean_scale),
        groups_(int(stack.wide_coefficients() / 4), int(stack.narrow_coefficients() / 4)),
        pairs_(int(stack.coefficients() / 2) - 2 * (groups_.x + groups_.y)) {
    const glm::ivec2 directions =
        stack.matte ? glm::ivec2(1) : glm::ivec2(stack.grid.phis, stack.grid.thetas);
    const glm::ivec2 texels(stack.width, stack.height);
    mean_ =
        layers_of(TexelFormat::rgb16, directions, stack.mean, 3 * stack.directions(), Wrap::repeat_across);
    basis_ = layers_of(TexelFormat::rgba16_snorm, directions, stack.basis, 4 * stack.directions(),
                       Wrap::repeat_across);
    wide_ = layers_of(TexelFormat::rgba16, texels, stack.wide, 4 * stack.texels(), Wrap::clamp);
    narrow_ = layers_of(TexelFormat::rgba8, texels, stack.narrow, 4 * stack.texels(), Wrap::clamp);
    blocks_ = layers_of(TexelFormat::rg_rgtc2, texels, stack.blocks, 2 * stack.block_count(), Wrap::clamp);
    const std::vector<glm::vec2> ranges = ranges_of(stack);
    ranges_ = Buffer(ranges.data(), ranges.size() * sizeof(glm::vec2));
  }

  void bind(const Program& program) const override {
    unsigned unit = 2;
    for (const GlTexture* texture : {&mean_, &basis_, &wide_, &narrow_, &blocks_}) texture->bind(unit++);
    ranges_.bind_storage(3);
    program.set("mean_range", mean_range_);
    program.set("groups", groups_);
    program.set("pairs", pairs_);
  }

 private:
  GlTexture mean_, basis_, wide_, narrow_, blocks_;
  Buffer ranges_;
  glm::vec2 mean_range_;
  glm::ivec2 groups_;  ///< of four coefficients: of 16 bits, of 8
  int pairs_;          ///< of compressed ones
};

PcaOptions options_of(const ParamValues& params) {
  PcaOptions options;
  options.max_coefficients = (params.integer("coefficients") + 1) / 2 * 2;
  options.first_bits = params.text("first_bits") == "16" ? 16 : 8;
  options.mean_error = params.number("mean_error");
  options.error_99 = params.number("error_99");
  return options;
}

std::filesystem::path file_of(const std::filesystem::path& stem) {
  return stem.string() + ".mtpc";
}

CodecReport compress(const HalfStack& stack, std::span<const std::uint8_t> counts, const ParamValues& params,
                     const std::filesystem::path& stem) {
  const PcaStack compressed = encode_pca(stack, counts, options_of(params));
  write_pca(file_of(stem), compressed);
  return report_codec(to_bytes(stack), decode_pca(compressed), {{"mtpc", compressed.bytes()}}, counts);
}

RadianceFile load(const std::filesystem::path& stem, const ParamValues&) {
  const PcaStack stack = read_pca(file_of(stem));
  return {stack.width, stack.height, stack.grid, stack.radiance_scale, std::make_unique<PcaTextures>(stack)};
}

}  // namespace

RadianceCodec pca_codec() {
  return {"pca", {"coefficients", "first_bits", "mean_error", "error_99"},     {".mtpc"}, compress,
          load,  [](const ParamValues&) { return ShaderDefines{"CODEC_PCA"}; }};
}

}  // namespace lightbench
