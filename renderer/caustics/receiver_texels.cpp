#include "renderer/caustics/receiver_texels.h"

#include <algorithm>

#include <glm/geometric.hpp>

#include "renderer/paths/closest_surface.h"

namespace lightbench {

std::vector<ReceiverTexel> receiver_texels(const PathScene& scene, const ReceiverBox& box,
                                           std::size_t receiver, int size) {
  const glm::vec3 axis(-box.v);
  const double far_above = 1 + double(world_bounds(scene.scene).diagonal()) / box.size.y;
  std::vector<ReceiverTexel> texels;
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      ReceiverTexel& texel = texels.emplace_back();
      const glm::vec3 above(box.from_map({(x + 0.5) / size, (y + 0.5) / size, -far_above}));
      const float to_water = (scene.scene.water->height - above.y) / axis.y;
      const auto hit = closest_surface(scene, above, axis, std::max(to_water, 0.0f));
      if (!hit) continue;
      const glm::vec3 face = glm::normalize(hit->surface.face);
      texel = {float(box.to_map(hit->position).z), hit->entity == receiver,
               glm::dot(face, axis) > 0 ? -face : face, hit->surface.albedo};
    }
  return texels;
}

}  // namespace lightbench
