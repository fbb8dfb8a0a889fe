#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace lightbench {

/// A .glsl file below renderer/, embedded by the build.
struct EmbeddedShader {
  std::string_view name;  ///< path relative to renderer/, e.g. "shaders/fullscreen.vert.glsl"
  std::string_view text;
};
std::span<const EmbeddedShader> embedded_shaders();

/// The text of a shader with `#include "path"` lines (relative to renderer/) replaced, each file once.
/// A name that is not there is a bug: throws std::logic_error.
std::string shader_source(std::string_view name);

/// The same text with `#line` directives in which file i of `files` has the number i, for readable messages.
struct NumberedShader {
  std::string text;
  std::vector<std::string> files;
};
NumberedShader numbered_shader_source(std::string_view name);

}  // namespace lightbench
