#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "renderer/caustics/receiver_box.h"
#include "renderer/paths/path_scene.h"

namespace lightbench {

/// The first surface below the water along the axis of a receiver's box, at the middle of a map's texel.
struct ReceiverTexel {
  float depth = 2;    ///< in the box, 0 to 1; 2 where there is nothing
  bool own = false;   ///< whether it is the receiver's
  glm::vec3 face{0};  ///< unit geometric normal towards the light
  glm::vec3 albedo{0};
};

/// x along u, then y along w, by exact rays.
std::vector<ReceiverTexel> receiver_texels(const PathScene& scene, const ReceiverBox& box,
                                           std::size_t receiver, int size);

}  // namespace lightbench
