#pragma once

#include <optional>
#include <vector>

#include "base/image.h"
#include "renderer/caustics/light_tracer.h"

/// How alike two maps of flux are: by their red, after a mean over 3 x 3 texels and clipped, so that neither
/// a single texel where light folds nor noise decides.
namespace lightbench {

/// Of a map's texels, x along u, then y along w.
struct FluxField {
  int size = 0;
  std::vector<double> values;
  std::vector<bool> counts;  ///< whether the texel is compared
};

FluxField flux_field(const FluxMap& map);
/// Of a map as read back from OpenGL, row 0 on top.
FluxField flux_field(const Image& map);

struct FluxLikeness {
  /// Pearson's; none where one of the maps is the same everywhere, as one without light is.
  std::optional<double> correlation;
  /// The first map's over the second's, over all texels that count, neither smoothed nor clipped; none where
  /// the second has no light.
  std::optional<double> energy;
};

/// Over the texels that count in both; both are clipped at `most`. Sizes must be equal.
FluxLikeness compare_flux(const FluxField& map, const FluxField& truth, double most);

/// Texels whose light, RGB of RGBA, has other bits.
std::size_t differing_texels(const Image& a, const Image& b);

}  // namespace lightbench
