#include "renderer/radiance/radiance_codecs.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "renderer/radiance/pca_codec.h"
#include "renderer/radiance/piecewise_codec.h"
#include "renderer/radiance/raw_codec.h"

namespace lightbench {

std::span<const RadianceCodec> radiance_codecs() {
  static const std::array table{raw_codec(), piecewise_codec(), pca_codec()};
  return table;
}

const RadianceCodec& radiance_codec(const ParamValues& params) {
  return *std::ranges::find(radiance_codecs(), params.text("codec"), &RadianceCodec::name);
}

std::vector<ParamSpec> codec_params() {
  std::vector<std::string> names;
  for (const RadianceCodec& codec : radiance_codecs()) names.emplace_back(codec.name);
  return {
      choice_param(
          "codec", std::move(names),
          "how radiance is kept; raw: 16-bit floats for each direction; piecewise: 8 bits, some directions "
          "of each texel and lines between them; pca: 8 bits, weights of a few functions of the direction"),
      choice_param("encoder", {"greedy", "paper"},
                   "of piecewise; greedy: the longest lines that keep the threshold; paper: the rule of the "
                   "thesis, which bounds no error"),
      integer_param("threshold", 6, 0, 765,
                    "of piecewise: the sum of a value's errors over its three components, of 255 each, is "
                    "below it; 0: none"),
      choice_param(
          "search", {"once", "binary", "linear"},
          "of piecewise, for a texel's directions when drawing; linear: from the first one on, as in the "
          "thesis; binary; once: one binary search for two neighbours. All give the same picture"),
      integer_param(
          "coefficients", 40, 4, 64,
          "of pca: the most that a texel has, rounded up to an even number; fewer where the errors allow it"),
      choice_param("first_bits", {"8", "16"},
                   "of pca: of each of the first four coefficients; with 16 they show no steps"),
      number_param("mean_error", 1.1, 0, 255,
                   "of pca: the largest mean error, of 255, over what is not decoded as it was"),
      number_param("error_99", 6.0, 0, 255,
                   "of pca: the error, of 255, that 99 % of all values may not exceed"),
      integer_param(
          "bound", 0, 0, 255,
          "of pca: not 0: instead of those two errors, corrections keep the sum of a value's errors over its "
          "three components, of 255 each, below this in every value; drawing costs several times as much"),
  };
}

std::string codec_params_text(const ParamValues& params) {
  const RadianceCodec& codec = radiance_codec(params);
  std::string text = fmt::format("codec={}\n", codec.name);
  for (const char* name : codec.params) text += fmt::format("{}={}\n", name, to_text(params.all().at(name)));
  return text;
}

}  // namespace lightbench
