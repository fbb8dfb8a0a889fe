#include "renderer/radiance/pca_codec.h"

#include "renderer/radiance/pca_encoder.h"
#include "renderer/radiance/pca_file.h"
#include "renderer/radiance/pca_textures.h"

namespace lightbench {
namespace {

PcaOptions options_of(const ParamValues& params) {
  PcaOptions options;
  options.max_coefficients = (params.integer("coefficients") + 1) / 2 * 2;
  options.first_bits = params.text("first_bits") == "16" ? 16 : 8;
  options.mean_error = params.number("mean_error");
  options.error_99 = params.number("error_99");
  options.threshold = params.integer("bound");
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

bool is_bounded(const ParamValues& params) {
  return params.integer("bound") > 0;
}

RadianceFile load(const std::filesystem::path& stem, const ParamValues& params) {
  const PcaStack stack = read_pca(file_of(stem));
  return {stack.width, stack.height, stack.grid, stack.radiance_scale,
          is_bounded(params) ? corrected_pca(stack) : interpolated_pca(stack)};
}

ShaderDefines defines(const ParamValues& params) {
  ShaderDefines defines{"CODEC_PCA"};
  if (is_bounded(params)) defines.emplace_back("CORRECTED");
  return defines;
}

}  // namespace

RadianceCodec pca_codec() {
  return {"pca",     {"coefficients", "first_bits", "mean_error", "error_99", "bound"},
          {".mtpc"}, compress,
          load,      defines};
}

}  // namespace lightbench
