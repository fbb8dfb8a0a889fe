#pragma once

#include <map>
#include <string>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "renderer/gl_objects.h"

namespace lightbench {

void delete_program(unsigned id);

/// "NAME" or "NAME value", put as #define lines before the shader's text.
using ShaderDefines = std::vector<std::string>;

/// A linked program of embedded shaders (renderer/shader_source.h). The files have no #version line: 4.50
/// core is put before them. Samplers and blocks carry explicit bindings in GLSL. A shader that does not
/// compile is a bug: throws std::logic_error with the messages, in which files and lines are those of the
/// .glsl files.
class Program {
 public:
  Program() = default;
  Program(const std::string& vertex, const std::string& fragment, const ShaderDefines& defines = {});

  /// Of one compute shader.
  static Program compute(const std::string& shader, const ShaderDefines& defines = {});

  unsigned id() const { return handle_.id(); }
  void use() const;

  /// Sets a uniform by name. A name that this variant of the shader does not use is passed over.
  void set(const char* name, bool value) const;
  void set(const char* name, int value) const;
  void set(const char* name, float value) const;
  void set(const char* name, const glm::vec2& value) const;
  void set(const char* name, const glm::vec3& value) const;
  void set(const char* name, const glm::vec4& value) const;
  void set(const char* name, const glm::ivec2& value) const;
  void set(const char* name, const glm::mat3& value) const;
  void set(const char* name, const glm::mat4& value) const;

 private:
  int location(const char* name) const;
  GlHandle<delete_program> handle_;
  mutable std::map<std::string, int, std::less<>> locations_;
};

/// Compiles each combination of shaders and defines once.
class ProgramCache {
 public:
  const Program& get(const std::string& vertex, const std::string& fragment,
                     const ShaderDefines& defines = {});
  const Program& get_compute(const std::string& shader, const ShaderDefines& defines = {});

 private:
  std::map<std::string, Program> programs_;
};

}  // namespace lightbench
