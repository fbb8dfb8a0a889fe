#pragma once

#include "renderer/radiance/radiance_codecs.h"

namespace lightbench {

/// 8 bits, of which some directions of each texel are kept and lines are drawn between them
/// (surface-radiance thesis, 5.2): renderer/radiance/piecewise.h.
RadianceCodec piecewise_codec();

}  // namespace lightbench
