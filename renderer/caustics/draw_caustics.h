#pragma once

#include <optional>

#include "renderer/caustics/caustics_params.h"
#include "renderer/caustics/occluder_map.h"

namespace lightbench {

class FrameContext;

/// The second layer of a map, if the options ask for it.
std::optional<OccluderMap> draw_occluders(FrameContext& frame, const ReceiverMap& map, const MapRays& rays,
                                          const CausticsOptions& options);

/// By the method of the options: RGBA32F as draw_level_map gives it.
GlTexture draw_caustics(FrameContext& frame, const ReceiverMap& map, const Volumes& volumes,
                        const CausticsOptions& options);

}  // namespace lightbench
