#pragma once

#include "renderer/radiance/pca.h"
#include "renderer/radiance/texel_values.h"

/// How far a PcaStack is from what it stands for, at the texels that count.
namespace lightbench {

/// As in PcaOptions (pca_encoder.h).
struct PcaErrors {
  double mean_changed = 0;
  double error_99 = 0;
};
PcaErrors measure_pca(const HalfStack& stack, const TexelPlaces& places, const PcaStack& pca);

/// Adds those that take the sum of |decoded - true| over the components below the threshold in every value.
/// `pca` has none yet.
void add_corrections(const HalfStack& stack, const TexelPlaces& places, int threshold, PcaStack& pca);

}  // namespace lightbench
