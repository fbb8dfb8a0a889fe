#pragma once

#include <cstdint>
#include <vector>

#include "scene/obj_parser.h"

namespace lightbench {

/// Whether two faces in one place may both be seen: through the holes of one that is cut out.
bool may_both_show(std::int32_t material_a, std::int32_t material_b, const std::vector<bool>& has_cutout);

/// Marks each face of four and more corners that has the corners of an earlier one, from whichever corner
/// on and whichever way round. Such faces must be found before they are cut: their diagonals may differ.
/// Triangles are never marked.
std::vector<bool> repeated_faces(const ObjData& data, const std::vector<std::uint32_t>& point_of_position,
                                 const std::vector<bool>& has_cutout);

}  // namespace lightbench
