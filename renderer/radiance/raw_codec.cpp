#include "renderer/radiance/raw_codec.h"

#include "renderer/radiance/radiance_file.h"

namespace lightbench {
namespace {

/// An array with a layer for each direction.
class RawTextures : public RadianceTextures {
 public:
  explicit RawTextures(const HalfStack& stack)
      : layers_(GlTexture::array(TexelFormat::rgb16f, stack.width, stack.height, stack.grid.layers(),
                                 Filter::linear)) {
    for (int layer = 0; layer < stack.grid.layers(); ++layer)
      layers_.upload_layer(
          layer,
          std::as_bytes(
              std::span(stack.texels).subspan(std::size_t(layer) * stack.layer_size(), stack.layer_size())));
  }
  void bind(const Program&) const override { layers_.bind(2); }

 private:
  GlTexture layers_;
};

RadianceFile load(const std::filesystem::path& stem, const ParamValues&) {
  const HalfStack stack = read_half_radiance(stem.string() + ".mtex");
  return {stack.width, stack.height, stack.grid, stack.scale, std::make_unique<RawTextures>(stack)};
}

}  // namespace

RadianceCodec raw_codec() {
  return {"raw", {}, {".mtex"}, nullptr, load, [](const ParamValues&) { return ShaderDefines{"CODEC_RAW"}; }};
}

}  // namespace lightbench
