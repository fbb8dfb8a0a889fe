#pragma once

#include "renderer/radiance/pca.h"
#include "renderer/radiance/pca_fit.h"
#include "renderer/radiance/texel_values.h"

namespace lightbench {

/// How many coefficients are kept in which way (pca.h).
struct PcaLayout {
  std::size_t wide, narrow;  ///< multiples of 4
  std::size_t compressed;    ///< even
  std::size_t coefficients() const { return wide + narrow + compressed; }
};

/// Stores the axes, and as many coefficients as the layout has for the texels at `places`: of those, one
/// column each. Where there are fewer axes, the rest is 0. What other texels get is left open.
PcaStack quantized(const HalfStack& stack, const TexelPlaces& places, const PcaAxes& axes,
                   const Eigen::MatrixXf& coefficients, const PcaLayout& layout);

/// Without loss: of an object that is matte, the colours of the first layer.
PcaStack matte_pca(const HalfStack& stack, const TexelPlaces& places);

}  // namespace lightbench
