#pragma once

#include <span>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "base/params.h"
#include "renderer/radiance/bake.h"
#include "renderer/radiance/chart_atlas.h"

namespace lightbench {

/// How many texels an object gets whose name matches.
struct NamedSize {
  std::string pattern;  ///< shell pattern of entity names
  glm::ivec2 size;
};

/// Everything that decides what is baked of a scene.
struct BakeSettings {
  BakeOptions trace;  ///< with the grid of objects that are not too glossy for it
  /// Of Phong, up to which that grid serves: others get more directions (object_grid). 0: all have that grid.
  double gloss_exponent = 40;
  std::vector<NamedSize> sizes;  ///< the first that matches counts
  double density = 0;            ///< texels along a unit of length, of other objects; 0: from `texels`
  double texels = 500000;        ///< of all other objects of the scene together, about
  AtlasUvs uvs = AtlasUvs::automatic;
};

/// Their rows, defaults and what is made of values. Throws Error for sizes that cannot be read.
std::vector<ParamSpec> bake_params();
BakeSettings bake_settings(const ParamValues& params);
/// The part of a variant's parameters that decides a bake, as text: a line for each.
std::string bake_params_text(const ParamValues& params);

}  // namespace lightbench
