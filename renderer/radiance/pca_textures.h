#pragma once

#include <memory>

#include "renderer/radiance/pca.h"
#include "renderer/radiance/radiance_objects.h"

namespace lightbench {

/// For techniques/surface_radiance/pca.glsl: the hardware interpolates. Corrections are left out.
std::unique_ptr<RadianceTextures> interpolated_pca(const PcaStack& stack);

/// For techniques/surface_radiance/pca_corrected.glsl: values are decoded to the bit, and corrected. A stack
/// need not have corrections. Throws Error where it has more of them than OpenGL takes.
std::unique_ptr<RadianceTextures> corrected_pca(const PcaStack& stack);

}  // namespace lightbench
