#pragma once

#include <vector>

#include "base/params.h"
#include "renderer/caustics/hit.h"
#include "renderer/caustics/level_map.h"
#include "renderer/caustics/map_rays.h"
#include "renderer/caustics/volumetric.h"

namespace lightbench {

enum class CausticsMethod { level_map, hit, volumetric };

struct CausticsOptions {
  CausticsMethod method = CausticsMethod::level_map;
  int layers = 2;      ///< of the position map: with two, light that is bent aside is stopped by edges
  int steps = 16;      ///< in which a ray is followed through the position map, at most
  int map_size = 512;  ///< texels along the edge of a receiver's maps
  bool fresnel = false;
  bool level_of_detail = false;  ///< no more slices than the receiver is pixels large
  VolumeCulling culling = VolumeCulling::on;
  bool surface = true;  ///< whether the water's surface is drawn
  ReceiverColor color = ReceiverColor::surface;
  double least_area = 1.0 / 256;  ///< texels
  LevelMapOptions level_map;
  HitOptions hit;
  VolumetricOptions volumetric;
};

/// The rows of technique `caustics`, and the options made from their values.
std::vector<ParamSpec> caustics_params();
CausticsOptions caustics_options(const ParamValues& params);

/// The same, with at most so many slices by every method.
CausticsOptions with_slices(CausticsOptions options, int most);

}  // namespace lightbench
