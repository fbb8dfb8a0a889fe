#include "renderer/caustics/draw_caustics.h"

namespace lightbench {

std::optional<OccluderMap> draw_occluders(FrameContext& frame, const ReceiverMap& map, const MapRays& rays,
                                          const CausticsOptions& options) {
  if (options.layers == 1) return std::nullopt;
  return OccluderMap(frame, map, rays.most_step, options.steps);
}

GlTexture draw_caustics(FrameContext& frame, const ReceiverMap& map, const Volumes& volumes,
                        const CausticsOptions& options) {
  switch (options.method) {
    case CausticsMethod::level_map:
      return draw_level_map(frame, map, volumes, options.level_map);
    case CausticsMethod::hit:
      return draw_hits(frame, map, volumes, options.hit);
    case CausticsMethod::volumetric:
      return draw_volumetric(frame, map, volumes, options.volumetric);
  }
  return {};
}

}  // namespace lightbench
