#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "scene/obj_text.h"
#include "scene/problem_list.h"

namespace lightbench {

/// A model of more objects and groups becomes a single mesh, so that no more of their names are kept.
inline constexpr std::size_t kMostMeshes = 2000;

/// Indices from 0 into the arrays of ObjData; -1 where the file gives none.
struct ObjCorner {
  std::int32_t position = -1;
  std::int32_t uv = -1;
  std::int32_t normal = -1;
};

/// What the last `s` before a face says; larger values are numbers of smoothing groups.
inline constexpr std::int32_t kSmoothingUnsaid = -1;
inline constexpr std::int32_t kSmoothingOff = 0;

struct ObjFace {
  std::uint32_t first_corner = 0;
  std::uint32_t corner_count = 0;  ///< 3 or more
  std::int32_t material = -1;      ///< into ObjData::materials, or -1 where no usemtl names one
  std::int32_t shape = 0;          ///< into ObjData::shapes
  std::int32_t smoothing = kSmoothingUnsaid;
};

/// An OBJ file's polygons as they stand in it, with all indices in range. Doubles, because map coordinates of
/// millions of units with centimetres behind the point are lost in floats.
struct ObjData {
  std::vector<glm::dvec3> positions;
  std::vector<glm::vec3> normals;  ///< as given: neither unit nor surely not zero
  std::vector<glm::dvec2> uvs;
  std::vector<glm::vec3> colors;  ///< of each position, as written but not above 1, or empty
  std::vector<ObjCorner> corners;
  std::vector<ObjFace> faces;
  std::vector<std::string> shapes;  ///< names of objects and groups, each once; kMostMeshes + 1 for any more
  std::vector<TextLine> materials;  ///< those that faces have, by the line of the usemtl before the first one
  std::vector<TextLine> material_libraries;
};

/// Reads an OBJ file without its materials. What is wrong is listed with its line, and left out. Throws Error
/// where the file cannot be read, or has more than `limits` allows.
ObjData parse_obj(const std::filesystem::path& file, ProblemList& problems, const ObjLimits& limits = {});

}  // namespace lightbench
