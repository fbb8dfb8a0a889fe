#pragma once

#include <string>
#include <string_view>

#include "renderer/technique.h"

namespace lightbench {

/// Another engine's pictures, found by a pattern of scene and view names, to be scored like any variant.
/// Needs no OpenGL.
Technique images_technique();

/// The pattern with {scene} and {view} replaced, and {{ by a brace that is meant as one. A name becomes a
/// single path component by `escape_file_name`, so that names of letters, digits, '.', '_' and '-' stand as
/// they are and no name can leave the pattern's folder. Throws Error for another word in braces.
std::string picture_path(std::string_view pattern, std::string_view scene, std::string_view view);

}  // namespace lightbench
