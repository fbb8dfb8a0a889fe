#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>

namespace lightbench {

/// Where a texture lies on a surface: it is looked up at uv * scale + offset (-s and -o of MTL files).
struct TexturePlacement {
  glm::dvec2 scale{1};
  glm::dvec2 offset{0};

  bool operator==(const TexturePlacement&) const = default;
};

/// What follows a keyword such as `map_Kd`: options and the name of a file.
struct TextureStatement {
  std::string name;  ///< empty where the statement has none
  TexturePlacement placement;
  std::vector<std::string> unshown;  ///< options that would change the picture, such as "-clamp"
  std::string problem;               ///< "-s has 'nan', which is no finite number"; empty where all is well
};

/// Reads such a statement. -s, -o and -t have one, two or three numbers, and names may have blanks, look like
/// a number or begin with '-'. So where a statement can be read in several ways, one that names a file counts
/// (`is_file` tells); else the one whose options take as much as they may.
TextureStatement read_texture_statement(std::string_view text,
                                        const std::function<bool(const std::string&)>& is_file);

}  // namespace lightbench
