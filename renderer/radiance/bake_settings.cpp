#include "renderer/radiance/bake_settings.h"

#include <algorithm>
#include <array>
#include <charconv>

#include <fmt/format.h>

#include "base/error.h"
#include "base/text.h"
#include "renderer/radiance/chart_layout.h"

namespace lightbench {
namespace {

struct UvsName {
  AtlasUvs uvs;
  const char* name;
};
constexpr std::array kUvs{UvsName{AtlasUvs::automatic, "auto"}, UvsName{AtlasUvs::own, "own"},
                          UvsName{AtlasUvs::charts, "charts"}};

int whole_number(const std::string& text) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || value < 1 || value > kMaxAtlasSide)
    return 0;
  return value;
}

NamedSize named_size(const std::string& text) {
  const auto equals = text.rfind('=');
  const auto cross = text.rfind('x');
  NamedSize result;
  if (equals != std::string::npos && cross != std::string::npos && cross > equals) {
    result.pattern = trimmed(text.substr(0, equals));
    result.size = {whole_number(trimmed(text.substr(equals + 1, cross - equals - 1))),
                   whole_number(trimmed(text.substr(cross + 1)))};
  }
  if (result.pattern.empty() || result.size.x == 0 || result.size.y == 0)
    throw Error(fmt::format("'{}' is not OBJECT=WIDTHxHEIGHT with 1 to {} texels a side", trimmed(text),
                            kMaxAtlasSide),
                "parameter 'sizes'");
  return result;
}

std::vector<NamedSize> named_sizes(const std::string& text) {
  std::vector<NamedSize> sizes;
  if (trimmed(text).empty()) return sizes;
  for (const std::string& part : split(text, ',')) sizes.push_back(named_size(part));
  return sizes;
}

template <typename Row>
std::vector<std::string> names_of(std::span<const Row> rows) {
  std::vector<std::string> names;
  for (const Row& row : rows) names.emplace_back(row.name);
  return names;
}

/// The value whose row has that name.
template <typename Row>
const Row& row_called(std::span<const Row> rows, const std::string& name) {
  return *std::ranges::find_if(rows, [&](const Row& row) { return row.name == name; });
}

}  // namespace

std::vector<ParamSpec> bake_params() {
  const DirectionGrid grid;
  const BakeSettings settings;
  return {
      integer_param("thetas", grid.thetas, 2, kMaxThetas, "directions from the normal to the horizon"),
      integer_param("phis", grid.phis, 1, kMaxPhis, "directions around the normal"),
      number_param("gloss_exponent", settings.gloss_exponent, 0, 1e6,
                   "exponent of highlights that thetas x phis directions serve; objects with higher ones get "
                   "more by the root of the ratio both ways, up to 45 x 45; 0: all have thetas x phis"),
      choice_param("order", names_of(layer_orders()), name_of(grid.order),
                   "of a texel's directions; phi_serpentine: neighbours in the order are neighbours on the "
                   "hemisphere, which compresses best"),
      text_param("sizes", "",
                 "texels of objects: 'OBJECT=WIDTHxHEIGHT, ...'; OBJECT is a shell pattern of entity names, "
                 "the first that matches counts"),
      number_param("density", settings.density, 0, 1e6,
                   "of other objects: texels along a unit of length; 0: as `texels` says"),
      number_param("texels", settings.texels, 1, 1e9, "of all other objects of the scene together, about"),
      choice_param("uvs", names_of(std::span<const UvsName>(kUvs)),
                   "auto: the mesh's own texture coordinates where no two places of its surface share one, "
                   "else charts that are packed anew; own, charts: always"),
      number_param("scale", settings.trace.scale, 1e-3, 1e6,
                   "the radiance that 255 stands for where 8 bits are kept; what is brighter is cut off"),
      integer_param("light_samples", settings.trace.light_samples, 0, 65536,
                    "on each area light, placed anew for each texel; 0: the fixed points that all other "
                    "techniques light with"),
      integer_param("bounces", settings.trace.bounces, 0, 16, "of indirect light, over matte surfaces"),
      integer_param("bounce_samples", settings.trace.bounce_samples, 2, 65536, "paths of each texel"),
      integer_param("seed", int(settings.trace.seed), 0, 2147483647, "of all random choices"),
  };
}

BakeSettings bake_settings(const ParamValues& params) {
  BakeSettings settings;
  settings.trace.grid.thetas = params.integer("thetas");
  settings.trace.grid.phis = params.integer("phis");
  settings.gloss_exponent = params.number("gloss_exponent");
  settings.trace.grid.order = row_called(layer_orders(), params.text("order")).order;
  settings.trace.scale = float(params.number("scale"));
  settings.trace.light_samples = params.integer("light_samples");
  settings.trace.bounces = params.integer("bounces");
  settings.trace.bounce_samples = params.integer("bounce_samples");
  settings.trace.seed = std::uint64_t(params.integer("seed"));
  settings.sizes = named_sizes(params.text("sizes"));
  settings.density = params.number("density");
  settings.texels = params.number("texels");
  settings.uvs = row_called(std::span<const UvsName>(kUvs), params.text("uvs")).uvs;
  return settings;
}

std::string bake_params_text(const ParamValues& params) {
  std::string text;
  for (const ParamSpec& row : bake_params())
    text += fmt::format("{}={}\n", row.name, to_text(params.all().at(row.name)));
  return text;
}

}  // namespace lightbench
