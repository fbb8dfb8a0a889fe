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
  bool same_light;  ///< whether its maps have the bits of all others of which this is said
};

const std::vector<CausticsMethodRow>& caustics_methods();

/// The names of all rows.
std::vector<std::string> caustics_method_names();

/// The rows of these names, in the order of the table; all for none.
std::vector<CausticsMethodRow> chosen_caustics_methods(const std::vector<std::string>& names);

/// Throws Error for a scene without water and for lights that cannot shine through it.
void require_lit_water(const Scene& scene);

/// What a study draws all rows with: values of the technique's parameters.
struct MapSettings {
  int size = 512;
  int slices = 100;
  int layers = 2;
};

/// All parameters of the technique for a row.
ParamValues method_params(const CausticsMethodRow& method, const MapSettings& settings);

}  // namespace lightbench
