#include "renderer/radiance/radiance_codecs.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "renderer/radiance/piecewise_codec.h"
#include "renderer/radiance/raw_codec.h"

namespace lightbench {

std::span<const RadianceCodec> radiance_codecs() {
  static const std::array table{raw_codec(), piecewise_codec()};
  return table;
}

const RadianceCodec& radiance_codec(const ParamValues& params) {
  return *std::ranges::find(radiance_codecs(), params.text("codec"), &RadianceCodec::name);
}

std::vector<ParamSpec> codec_params() {
  std::vector<std::string> names;
  for (const RadianceCodec& codec : radiance_codecs()) names.emplace_back(codec.name);
  const std::string first = names.front();
  return {
      {"codec", ParamType::choice, first, 0, 0, std::move(names),
       "how radiance is kept; raw: 16-bit floats for each direction; piecewise: 8 bits, some directions of "
       "each "
       "texel and lines between them"},
      {"encoder",
       ParamType::choice,
       std::string("greedy"),
       0,
       0,
       {"greedy", "paper"},
       "of piecewise; greedy: the longest lines that keep the threshold; paper: the rule of the thesis, "
       "which "
       "bounds no error"},
      {"threshold",
       ParamType::integer,
       6LL,
       0,
       765,
       {},
       "of piecewise: the sum of a value's errors over its three components, of 255 each, is below it; 0: "
       "none"},
      {"search",
       ParamType::choice,
       std::string("once"),
       0,
       0,
       {"once", "binary", "linear"},
       "of piecewise, for a texel's directions when drawing; linear: from the first one on, as in the "
       "thesis; "
       "binary; once: one binary search for two neighbours. All give the same picture"},
  };
}

std::string codec_params_text(const ParamValues& params) {
  const RadianceCodec& codec = radiance_codec(params);
  std::string text = fmt::format("codec={}\n", codec.name);
  for (const char* name : codec.params) text += fmt::format("{}={}\n", name, to_text(params.all().at(name)));
  return text;
}

}  // namespace lightbench
