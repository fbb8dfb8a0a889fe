#pragma once

#include <map>
#include <string>
#include <vector>

#include "base/params.h"
#include "scene/scene.h"

namespace lightbench {

/// A way in which technique `caustics` draws maps, as the studies name it.
struct CausticsMethodRow {
  const char* name;
  std::map<std::string, ParamValue> params;
  bool same_light;          ///< whether its maps have the bits of all others of which this is said
  bool by_position = true;  ///< whether it needs the position map for more than casting
};

const std::vector<CausticsMethodRow>& caustics_methods();

/// Throws Error for a scene without water and for lights that cannot shine through it.
void require_lit_water(const Scene& scene);

/// All parameters of the technique for a row.
ParamValues method_params(const CausticsMethodRow& method, int map_size, int slices);

}  // namespace lightbench
