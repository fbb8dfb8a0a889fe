#include "scene/random_views.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "base/error.h"
#include "scene/views/generators.h"

namespace lightbench {
namespace {

struct Generator {
  int version;
  decltype(&views_1::draw_cameras) draw_cameras;
  decltype(&views_1::why_invalid) why_invalid;
};

constexpr std::array kGenerators{Generator{1, views_1::draw_cameras, views_1::why_invalid},
                                 Generator{2, views_2::draw_cameras, views_2::why_invalid}};
static_assert(kGenerators.back().version == kNewestGenerator);

const Generator& generator(int version) {
  const auto found = std::find_if(kGenerators.begin(), kGenerators.end(),
                                  [&](const Generator& g) { return g.version == version; });
  if (found == kGenerators.end())
    throw Error(fmt::format("random views have no generator of version {}; the newest is {}", version,
                            kNewestGenerator));
  return *found;
}

void check_that_there_is_something(const Scene& scene) {
  const Bounds bounds = world_bounds(scene);
  if (bounds.empty() || !(bounds.diagonal() > 0)) throw Error("an empty scene has no views", scene.name);
}

}  // namespace

std::vector<View> draw_random_views(const Scene& scene, const RandomViewOptions& options,
                                    const ClosestHit& closest_hit) {
  check_that_there_is_something(scene);
  std::vector<View> views;
  for (const Camera& camera : generator(options.version).draw_cameras(scene, options, closest_hit))
    views.push_back({fmt::format("random-{}-{:04}", options.seed, views.size() + 1), camera});
  return views;
}

std::optional<std::string> why_view_is_invalid(const Scene& scene, const View& view, float aspect,
                                               const ClosestHit& closest_hit, int version) {
  check_that_there_is_something(scene);
  return generator(version).why_invalid(scene, view.camera, aspect, closest_hit);
}

}  // namespace lightbench
