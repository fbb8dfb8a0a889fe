#include "base/image_layers.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <strings.h>

#include "base/error.h"
#include "base/text.h"

namespace lightbench {
namespace {

enum Role { red, green, blue, luminance, alpha, chroma, horizontal, role_count };

struct ChannelName {
  const char* name;  // in any case
  Role role;
};

constexpr ChannelName kChannelNames[] = {
    {"R", red},        {"Red", red},     {"G", green},     {"Green", green},
    {"B", blue},       {"Blue", blue},   {"Y", luminance}, {"Luminance", luminance},
    {"A", alpha},      {"Alpha", alpha}, {"RY", chroma},   {"BY", chroma},
    {"X", horizontal},
};

struct Layer {
  std::string name;
  std::size_t part = 0;
  std::array<std::optional<int>, role_count> channels{};

  bool has(Role role) const { return channels[role].has_value(); }
  bool has_rgb() const { return has(red) && has(green) && has(blue); }
  /// Y beside X is a coordinate, as of normals and positions.
  bool has_color() const { return has_rgb() || (has(luminance) && !has(horizontal)); }
};

std::string layer_name(const std::vector<FilePart>& parts, const FilePart& part, const std::string& prefix) {
  if (parts.size() == 1 || part.name.empty()) return prefix;
  if (prefix.empty() || prefix == part.name) return part.name;
  return prefix.starts_with(part.name + ".") ? prefix : part.name + "." + prefix;
}

std::vector<Layer> find_layers(const std::vector<FilePart>& parts) {
  std::vector<Layer> layers;
  std::map<std::pair<std::size_t, std::string>, std::size_t> index;
  for (std::size_t part = 0; part < parts.size(); ++part)
    for (std::size_t i = 0; i < parts[part].channels.size(); ++i) {
      const std::string& channel = parts[part].channels[i];
      const std::size_t dot = channel.rfind('.');
      const std::string prefix = dot == std::string::npos ? "" : channel.substr(0, dot);
      const std::string suffix = dot == std::string::npos ? channel : channel.substr(dot + 1);
      const std::string name = layer_name(parts, parts[part], prefix);
      const auto [position, is_new] = index.try_emplace({part, name}, layers.size());
      if (is_new) layers.push_back(Layer{name, part});
      Layer& layer = layers[position->second];
      for (const ChannelName& row : kChannelNames)
        if (::strcasecmp(row.name, suffix.c_str()) == 0 && !layer.has(row.role))
          layer.channels[row.role] = int(i);
    }
  return layers;
}

/// "'a', 'b' and 3 more".
std::string list(const std::vector<std::string>& names) {
  constexpr std::size_t kMost = 20;
  std::vector<std::string> quoted;
  for (const std::string& name : names)
    if (quoted.size() < kMost) quoted.push_back("'" + name + "'");
  return join(quoted, ", ") +
         (names.size() > kMost ? fmt::format(" and {} more", names.size() - kMost) : std::string());
}

std::string all_channels(const std::vector<FilePart>& parts) {
  std::vector<std::string> names;
  for (const FilePart& part : parts) names.insert(names.end(), part.channels.begin(), part.channels.end());
  return list(names);
}

std::vector<std::string> names_of(const std::vector<const Layer*>& layers) {
  std::vector<std::string> names;
  for (const Layer* layer : layers) names.push_back(layer->name);
  return names;
}

const Layer& choose(const std::vector<const Layer*>& colored, const std::string& where) {
  const auto unnamed = std::ranges::find_if(colored, [](const Layer* layer) { return layer->name.empty(); });
  if (unnamed != colored.end()) return **unnamed;
  if (colored.size() > 1)
    throw Error(fmt::format("has several layers and none without a name; one of them must be chosen: {}",
                            list(names_of(colored))),
                where);
  return *colored.front();
}

const Layer& wanted(const std::vector<const Layer*>& colored, const std::string& name,
                    const std::string& where) {
  const auto found = std::ranges::find_if(colored, [&](const Layer* layer) { return layer->name == name; });
  if (found != colored.end()) return **found;
  const std::vector<std::string> names = names_of(colored);
  throw Error(fmt::format("has no layer '{}' with colour{}; layers with colour: {}", name,
                          did_you_mean(name, names), list(names)),
              where);
}

}  // namespace

PictureChannels find_picture(const std::vector<FilePart>& parts, const std::string& wanted_layer,
                             const std::string& where) {
  const std::vector<Layer> layers = find_layers(parts);
  std::vector<const Layer*> colored;
  for (const Layer& layer : layers)
    if (layer.has_color()) colored.push_back(&layer);
  if (colored.empty())
    throw Error(fmt::format("has no colour: neither channels R, G and B, nor Y; its channels are {}",
                            all_channels(parts)),
                where);
  const bool has_names = std::ranges::any_of(layers, [](const Layer& layer) { return !layer.name.empty(); });
  const Layer& layer =
      wanted_layer.empty() || !has_names ? choose(colored, where) : wanted(colored, wanted_layer, where);
  if (!layer.has_rgb() && layer.has(chroma))
    throw Error("stores its colours as luminance and chroma (channels Y, RY and BY), which is not read",
                where);
  PictureChannels picture{.part = layer.part, .indices = {}, .has_alpha = layer.has(alpha)};
  for (const Role role : {red, green, blue})
    if (layer.has_rgb()) picture.indices.push_back(*layer.channels[role]);
  if (!layer.has_rgb()) picture.indices.push_back(*layer.channels[luminance]);
  if (picture.has_alpha) picture.indices.push_back(*layer.channels[alpha]);
  return picture;
}

}  // namespace lightbench
