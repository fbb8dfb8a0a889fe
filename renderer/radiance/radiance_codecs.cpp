#include "renderer/radiance/radiance_codecs.h"

#include "renderer/radiance/radiance_file.h"

namespace lightbench {
namespace {

/// An array with a layer for each direction, filtered over texels by the hardware.
class RawTextures : public RadianceTextures {
 public:
  explicit RawTextures(const HalfStack& stack)
      : layers_(GlTexture::array(TexelFormat::rgb16f, stack.width, stack.height, stack.grid.layers(),
                                 Filter::linear)) {
    for (int layer = 0; layer < stack.grid.layers(); ++layer)
      layers_.upload_layer(
          layer,
          std::span(stack.texels).subspan(std::size_t(layer) * stack.layer_size(), stack.layer_size()));
  }
  void bind(const Program&) const override { layers_.bind(2); }
  std::size_t bytes() const override {
    return std::size_t(layers_.width()) * std::size_t(layers_.height()) * std::size_t(layers_.layers()) * 6;
  }

 private:
  GlTexture layers_;
};

}  // namespace

std::vector<ParamSpec> codec_params() {
  return {{"codec",
           ParamType::choice,
           std::string("raw"),
           0,
           0,
           {"raw"},
           "how radiance is kept; raw: 16-bit floats for each direction"}};
}

ShaderDefines codec_defines(const ParamValues& params) {
  return {params.text("codec") == "raw" ? "CODEC_RAW" : ""};
}

RadianceFile load_radiance(const std::filesystem::path& stem, const ParamValues&) {
  const HalfStack stack = read_half_radiance(stem.string() + ".mtex");
  return {stack.width, stack.height, stack.grid, stack.scale, std::make_unique<RawTextures>(stack)};
}

}  // namespace lightbench
