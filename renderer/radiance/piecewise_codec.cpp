#include "renderer/radiance/piecewise_codec.h"

#include "renderer/radiance/piecewise_encoder.h"
#include "renderer/radiance/piecewise_file.h"

namespace lightbench {
namespace {

std::vector<std::array<std::uint8_t, 4>> padded(const std::vector<Rgb8>& colors) {
  std::vector<std::array<std::uint8_t, 4>> result;
  result.reserve(colors.size());
  for (const Rgb8& color : colors) result.push_back({color[0], color[1], color[2], 255});
  return result;
}

template <typename Entry>
BufferTexture texture_of(BufferFormat format, const std::vector<Entry>& entries) {
  return BufferTexture(format, entries.data(), entries.size());
}

class PiecewiseTextures : public RadianceTextures {
 public:
  explicit PiecewiseTextures(const PiecewiseStack& stack)
      : starts_(texture_of(BufferFormat::r32ui, stack.first_sample)),
        layers_(texture_of(BufferFormat::r16ui, stack.layers)),
        indices_(texture_of(BufferFormat::r16ui, stack.color_indices)),
        colors_(texture_of(BufferFormat::rgba8ui, padded(stack.colors))),
        samples_(int(stack.layers.size())),
        mapped_(!stack.color_indices.empty()) {}

  void bind(const Program& program) const override {
    unsigned unit = 2;
    for (const BufferTexture* texture : {&starts_, &layers_, &indices_, &colors_}) texture->bind(unit++);
    program.set("samples", samples_);
    program.set("mapped", mapped_);
  }

 private:
  BufferTexture starts_, layers_, indices_, colors_;
  int samples_;
  bool mapped_;
};

CodecReport compress(const HalfStack& stack, std::span<const std::uint8_t> counts, const ParamValues& params,
                     const std::filesystem::path& stem) {
  const SampleRule rule = params.text("encoder") == "paper" ? SampleRule::paper : SampleRule::greedy;
  const ByteStack bytes = to_bytes(stack);
  const PiecewiseStack compressed = encode_piecewise(bytes, rule, params.integer("threshold"));
  write_piecewise(stem, compressed);
  return report_codec(bytes, decode_piecewise(compressed), piecewise_file_sizes(compressed), counts);
}

RadianceFile load(const std::filesystem::path& stem, const ParamValues&) {
  const PiecewiseStack stack = read_piecewise(stem);
  return {stack.width, stack.height, stack.grid, stack.scale, std::make_unique<PiecewiseTextures>(stack)};
}

ShaderDefines defines(const ParamValues& params) {
  const std::string& search = params.text("search");
  return {"CODEC_PIECEWISE", search == "linear"   ? "SEARCH_LINEAR"
                             : search == "binary" ? "SEARCH_BINARY"
                                                  : "SEARCH_ONCE"};
}

}  // namespace

RadianceCodec piecewise_codec() {
  return {"piecewise", {"encoder", "threshold"}, {".mtnc", ".mti", ".mtm", ".mtsp"}, compress, load, defines};
}

}  // namespace lightbench
