#pragma once

#include "renderer/radiance/radiance_codecs.h"

namespace lightbench {

/// The texels as they were baked: 16-bit floats, filtered over texels by the hardware.
RadianceCodec raw_codec();

}  // namespace lightbench
