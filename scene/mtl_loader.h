#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "scene/problem_list.h"
#include "scene/texture_options.h"

namespace lightbench {

/// A texture as an MTL file names it.
struct MtlTexture {
  std::string name;  ///< empty for none
  std::size_t line = 0;
  TexturePlacement placement;
};

/// A material as an MTL file has it.
struct MtlMaterial {
  std::string name;
  std::filesystem::path file;
  std::size_t line = 0;              ///< of its newmtl
  glm::vec3 diffuse{0.8f};           ///< Kd; without one 1 under a texture, else 0.8
  glm::vec3 specular{0};             ///< Ks
  float exponent = 1;                ///< Ns
  glm::vec3 emission{0};             ///< Ke
  MtlTexture diffuse_map;            ///< map_Kd
  MtlTexture cutout_map;             ///< map_d
  std::vector<std::string> unshown;  ///< what lightbench does not show: "map_Bump", "transparency", ...
};

/// The most materials of one MTL file.
inline constexpr std::size_t kMostMaterials = 200'000;

/// Reads an MTL file. What is wrong is listed with its line: as an error in a material that `is_used`, else
/// as a warning. The first of two materials with one name counts. Throws Error where the file cannot be read,
/// or has more than `most` materials.
std::vector<MtlMaterial> load_mtl(
    const std::filesystem::path& file, ProblemList& problems, std::size_t most = kMostMaterials,
    const std::function<bool(const std::string&)>& is_used = [](const std::string&) { return true; });

}  // namespace lightbench
