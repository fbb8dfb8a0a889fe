#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include <glm/vec2.hpp>

#include "scene/obj_parser.h"
#include "scene/texture_options.h"

namespace lightbench {

/// The texture coordinates of a model's faces: placed as their material says, and moved by whole repeats of
/// the texture where they lie so far away that 32-bit floats would lose their fractions.
class PlacedUvs {
 public:
  /// `placements` are of ObjData::materials; those that are missing change nothing.
  PlacedUvs(const ObjData& data, const std::vector<TexturePlacement>& placements);

  /// Returns the coordinates of a corner of a face (both are indices); they are zero where the file gives
  /// none.
  glm::vec2 at(std::uint32_t corner, std::uint32_t face) const;

 private:
  glm::dvec2 placed(std::uint32_t corner, const ObjFace& face) const;
  void move_if_far(std::uint32_t face);

  const ObjData& data_;
  const std::vector<TexturePlacement>& placements_;
  std::unordered_map<std::uint32_t, glm::dvec2> moves_;  // of faces, whole numbers
};

}  // namespace lightbench
