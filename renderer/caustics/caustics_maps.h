#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "base/image.h"
#include "base/params.h"
#include "renderer/caustics/receiver_box.h"
#include "renderer/gl_context.h"
#include "scene/scene.h"

namespace lightbench {

/// One caustics map, and what it took.
struct CausticsMap {
  ReceiverBox box;
  Image flux;                                ///< as draw_level_map gives it; row 0 on top
  std::vector<std::size_t> texels_by_plane;  ///< of the position map
  std::size_t used_planes() const;           ///< to which any belong
  std::size_t lit = 0;                       ///< triangles of the water that let light in
  std::size_t drawn = 0;                     ///< of them, those whose light may reach the receiver
  std::size_t sideways = 0;                  ///< of them, those that no map shows
  std::size_t raised = 0;                    ///< fragments whose area was raised to the least
  std::size_t texture_bytes =
      0;  ///< the most that textures took at a time, for the position map and all after it
  double position_seconds = 0;  ///< that the position map took, with its second layer
  double seconds = 0;           ///< that the map took after it
};

/// Draws the maps of technique `caustics` by themselves, to see into them. The scene must outlive it.
class CausticsMaps {
 public:
  CausticsMaps(const Scene& scene, GlBackend backend);
  ~CausticsMaps();

  /// With parameters of the technique.
  CausticsMap draw(std::size_t receiver, const Light& light, const ParamValues& params);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace lightbench
