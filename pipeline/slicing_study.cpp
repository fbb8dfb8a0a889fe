#include "pipeline/slicing_study.h"

#include <algorithm>

#include <fmt/format.h>

#include "pipeline/bench.h"
#include "pipeline/caustics_methods.h"
#include "renderer/caustics/caustics_maps.h"
#include "renderer/caustics/flux_compare.h"

namespace lightbench {
namespace {

double seconds_of(const CausticsMap& map) {
  return map.position_seconds + map.seconds;
}

/// Fills `receiver` by one number of planes more.
void add_times(CausticsMaps& maps, std::size_t entity, const Light& light, int planes,
               const SlicingStudyOptions& options, SlicedReceiver& receiver) {
  const std::vector<CausticsMethodRow> methods = chosen_caustics_methods(options.methods);
  std::vector<ParamValues> params;
  for (const CausticsMethodRow& method : methods)
    params.push_back(method_params(method, {options.map_size, planes - 1, options.layers}));
  SlicingTimes times;
  times.planes = planes;
  CausticsMap first;
  for (std::size_t m = 0; m < methods.size(); ++m) {
    CausticsMap drawn = maps.draw(entity, light, params[m]);
    if (m == 0)
      first = std::move(drawn);
    else if (methods[0].same_light && methods[m].same_light)
      times.differing = std::max(times.differing, differing_texels(drawn.flux, first.flux));
  }
  std::vector<std::vector<double>> seconds(methods.size());
  for (int round = 0; round < options.rounds; ++round)
    for (std::size_t m = 0; m < methods.size(); ++m)
      seconds[m].push_back(seconds_of(maps.draw(entity, light, params[m])));
  for (std::size_t m = 0; m < methods.size(); ++m) {
    const BenchTime time = summarize(methods[m].name, seconds[m]);
    times.methods.push_back({time.pass, 1e3 * time.median, 1e3 * time.lower, 1e3 * time.upper});
  }
  times.used = int(first.used_planes());
  receiver.texels_by_plane = std::move(first.texels_by_plane);
  receiver.times.push_back(std::move(times));
}

}  // namespace

std::vector<SlicedReceiver> study_slicing(const Scene& scene, const SlicingStudyOptions& options,
                                          const std::function<void(const std::string&)>& progress) {
  require_lit_water(scene);
  CausticsMaps maps(scene, options.backend);
  std::vector<SlicedReceiver> receivers;
  for (const Light& light : scene.lights)
    for (std::size_t entity = 0; entity < scene.entities.size(); ++entity) {
      const std::string& name = scene.entities[entity].name;
      if (entity_bounds(scene, entity).empty()) continue;
      if (std::find(options.without.begin(), options.without.end(), name) != options.without.end()) continue;
      SlicedReceiver receiver{scene.name, name, light.name, {}, {}};
      for (const int planes : options.planes) {
        progress(fmt::format("{}: {}, {} planes", scene.name, name, planes));
        add_times(maps, entity, light, planes, options, receiver);
      }
      receivers.push_back(std::move(receiver));
    }
  return receivers;
}

}  // namespace lightbench
