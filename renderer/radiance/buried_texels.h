#pragma once

#include <span>
#include <vector>

#include "renderer/radiance/bake.h"
#include "renderer/radiance/chart_atlas.h"
#include "renderer/radiance/solids.h"

/// Texels that another object stands on: nobody sees them, but bilinear lookups of their neighbours read
/// them.
namespace lightbench {

/// Of each texel, whether the place at a distance of `above` over it lies in a solid.
std::vector<bool> buried_texels(const PathScene& scene, const Solids& solids, std::size_t entity,
                                std::span<const BakeTexel> texels, float above);

/// Gives each buried surface texel of the atlas the mean of those around it, from the nearest ones on; where
/// a chart is buried whole, its texels stay as they are. `buried` is by surface texel.
void fill_buried(const ChartAtlas& atlas, const std::vector<bool>& buried, HalfStack& stack);

}  // namespace lightbench
