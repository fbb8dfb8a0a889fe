#pragma once

#include <span>
#include <string>
#include <string_view>

namespace lightbench {

/// A .glsl file below renderer/, embedded by the build.
struct EmbeddedShader {
  std::string_view name;  ///< path relative to renderer/, e.g. "shaders/fullscreen.vert.glsl"
  std::string_view text;
};
std::span<const EmbeddedShader> embedded_shaders();

/// The text of a shader with `#include "path"` lines (relative to renderer/) replaced, each file once.
/// A name that is not there is a bug: asserts.
std::string shader_source(std::string_view name);

}  // namespace lightbench
