#include "pipeline/caustics_methods.h"

#include <algorithm>

#include "base/error.h"
#include "renderer/caustics/water_light.h"
#include "renderer/technique.h"

namespace lightbench {

const std::vector<CausticsMethodRow>& caustics_methods() {
  static const std::vector<CausticsMethodRow> rows{
      {"level map", {}, true},
      {"level map, smart", {{"slicing", "smart"}}, true},
      {"level map, read back", {{"slicing", "smart_read_back"}}, true},
      {"level map, all planes", {{"slicing", "uniform"}}, true},
      {"level map, discard", {{"slicing", "uniform"}, {"plane_test", "discard"}}, true},
      {"volumetric", {{"method", "volumetric"}}, true},
      {"volumetric, clusters", {{"method", "volumetric"}, {"slice_images", "clusters"}}, true},
      {"hit", {{"method", "hit"}}, false},
      {"hit, no split", {{"method", "hit"}, {"straddling", "drop"}}, false},
  };
  return rows;
}

std::vector<std::string> caustics_method_names() {
  std::vector<std::string> names;
  for (const CausticsMethodRow& method : caustics_methods()) names.emplace_back(method.name);
  return names;
}

std::vector<CausticsMethodRow> chosen_caustics_methods(const std::vector<std::string>& names) {
  std::vector<CausticsMethodRow> methods;
  for (const CausticsMethodRow& method : caustics_methods())
    if (names.empty() || std::find(names.begin(), names.end(), method.name) != names.end())
      methods.push_back(method);
  return methods;
}

void require_lit_water(const Scene& scene) {
  if (!scene.water) throw Error("the scene has no water", scene.name);
  for (const Light& light : scene.lights)
    if (const std::string problem = water_light_problem(scene, light); !problem.empty())
      throw Error(problem, scene.name);
}

ParamValues method_params(const CausticsMethodRow& method, const MapSettings& settings) {
  const Technique& technique = find_technique("caustics", "caustics");
  std::map<std::string, ParamValue> given = method.params;
  given["map_size"] = static_cast<long long>(settings.size);
  given["slices"] = static_cast<long long>(settings.slices);
  given["layers"] = static_cast<long long>(settings.layers);
  return resolve_params(technique.params, technique.presets, "", given, method.name);
}

}  // namespace lightbench
