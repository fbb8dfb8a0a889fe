#pragma once

#include "renderer/caustics/caustics_params.h"

namespace lightbench {

class FrameContext;

/// By the method of the options: RGBA32F as draw_level_map gives it.
GlTexture draw_caustics(FrameContext& frame, const ReceiverMap& map, const Volumes& volumes,
                        const CausticsOptions& options);

}  // namespace lightbench
