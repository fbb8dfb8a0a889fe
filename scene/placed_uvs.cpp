#include "scene/placed_uvs.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/common.hpp>

namespace lightbench {
namespace {

// Beyond this a float has fewer than 11 bits for the place in the texture: less than half a texel of one of
// 1024 pixels. Nearer ones stay as they are, so that faces share their vertices.
constexpr double kFar = 4096;

}  // namespace

PlacedUvs::PlacedUvs(const ObjData& data, const std::vector<TexturePlacement>& placements)
    : data_(data), placements_(placements) {
  for (std::uint32_t i = 0; i < data.faces.size(); ++i) move_if_far(i);
}

glm::vec2 PlacedUvs::at(std::uint32_t corner, std::uint32_t face) const {
  if (data_.corners[corner].uv < 0) return glm::vec2(0);
  const glm::dvec2 uv = placed(corner, data_.faces[face]);
  const auto move = moves_.find(face);
  return glm::vec2(move == moves_.end() ? uv : uv + move->second);
}

glm::dvec2 PlacedUvs::placed(std::uint32_t corner, const ObjFace& face) const {
  const glm::dvec2 uv = data_.uvs[std::size_t(data_.corners[corner].uv)];
  if (face.material < 0 || std::size_t(face.material) >= placements_.size()) return uv;
  const TexturePlacement& placement = placements_[std::size_t(face.material)];
  return placement == TexturePlacement() ? uv : uv * placement.scale + placement.offset;
}

void PlacedUvs::move_if_far(std::uint32_t face) {
  const ObjFace& f = data_.faces[face];
  glm::dvec2 min(std::numeric_limits<double>::max());
  glm::dvec2 max(std::numeric_limits<double>::lowest());
  for (std::uint32_t i = f.first_corner; i < f.first_corner + f.corner_count; ++i) {
    if (data_.corners[i].uv < 0) continue;
    const glm::dvec2 uv = placed(i, f);
    min = glm::min(min, uv);
    max = glm::max(max, uv);
  }
  glm::dvec2 move(0);
  for (int k = 0; k < 2; ++k)
    if (min[k] <= max[k] && std::max(-min[k], max[k]) > kFar) move[k] = -std::floor(min[k]);
  if (move != glm::dvec2(0)) moves_.emplace(face, move);
}

}  // namespace lightbench
