#pragma once

#include "renderer/radiance/radiance_codecs.h"

namespace lightbench {

/// 8 bits as weighted sums of a few functions of the direction, which all texels of an object share
/// (renderer/radiance/pca.h). The hardware interpolates weights over texels and functions over directions, in
/// encoded values; but with a bound on errors a shader mixes the values that it holds for, in linear light.
RadianceCodec pca_codec();

}  // namespace lightbench
