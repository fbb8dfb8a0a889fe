#pragma once

#include <cstddef>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "renderer/caustics/receiver_box.h"
#include "renderer/caustics/water_light.h"

namespace lightbench {

/// A water's illumination volumes (the water caustics thesis, 4.3) in the maps of a receiver: all as
/// functions of the depth z in its box, which is 0 on the side of the light and 1 on the far side.
struct MapRays {
  /// Where a triangle's light lands, and how much. std430.
  struct Triangle {
    glm::vec4 flux;  ///< as it enters the water; w unused
    glm::vec4 area;  ///< of its image in the plane at z, signed, in the world: x + y z + z z^2; w unused
  };

  std::vector<glm::vec4>
      places;  ///< of each vertex's ray: x and y of the map at z = 0, and what each unit of z adds
  std::vector<glm::vec2> ways;      ///< the same of the way through the water, in the world
  std::vector<glm::vec2> spots;     ///< as WaterLight has them
  std::vector<glm::uvec3> corners;  ///< of the triangles whose light may reach the box
  std::vector<Triangle> triangles;
  glm::vec2 most_step{0};  ///< by how much a unit of z moves a ray of those triangles at most, either way
  std::size_t lit = 0;     ///< triangles that let light in
  std::size_t sideways =
      0;  ///< of them, those with a ray that runs across the box's axis or up it, which no map shows
};

enum class VolumeCulling { on, off };

/// `light` is that of the water's mesh. With culling, triangles are left out whose volume misses the box.
MapRays map_rays(const Mesh& water, const WaterLight& light, const ReceiverBox& box,
                 VolumeCulling culling = VolumeCulling::on);

}  // namespace lightbench
