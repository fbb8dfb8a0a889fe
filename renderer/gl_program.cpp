#include "renderer/gl_program.h"

#include <stdexcept>

#include <fmt/format.h>
#include <glad/gl.h>
#include <glm/gtc/type_ptr.hpp>

#include "renderer/shader_log.h"
#include "renderer/shader_source.h"

namespace lightbench {
namespace {

GLuint compile(GLenum stage, const std::string& name, const ShaderDefines& defines) {
  const NumberedShader source = numbered_shader_source(name);
  std::string text = "#version 450 core\n";
  for (const std::string& define : defines) text += "#define " + define + "\n";
  text += source.text;
  const char* pointer = text.c_str();
  const GLuint shader = glCreateShader(stage);
  glShaderSource(shader, 1, &pointer, nullptr);
  glCompileShader(shader);
  GLint ok = 0;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &ok);
  if (ok) return shader;
  GLint length = 0;
  glGetShaderiv(shader, GL_INFO_LOG_LENGTH, &length);
  std::string log(std::size_t(length), '\0');
  glGetShaderInfoLog(shader, length, nullptr, log.data());
  glDeleteShader(shader);
  throw std::logic_error(
      fmt::format("shader {} does not compile:\n{}", name, with_file_names(log, source.files)));
}

void link(GLuint program, const std::string& names) {
  glLinkProgram(program);
  GLint ok = 0;
  glGetProgramiv(program, GL_LINK_STATUS, &ok);
  if (ok) return;
  GLint length = 0;
  glGetProgramiv(program, GL_INFO_LOG_LENGTH, &length);
  std::string log(std::size_t(length), '\0');
  glGetProgramInfoLog(program, length, nullptr, log.data());
  throw std::logic_error(fmt::format("{} does not link:\n{}", names, log));
}

}  // namespace

void delete_program(unsigned id) {
  glDeleteProgram(id);
}

Program::Program(const std::string& vertex, const std::string& fragment, const ShaderDefines& defines)
    : handle_(glCreateProgram()) {
  for (const auto& [stage, name] : {std::pair{GL_VERTEX_SHADER, vertex}, {GL_FRAGMENT_SHADER, fragment}}) {
    const GLuint shader = compile(GLenum(stage), name, defines);
    glAttachShader(id(), shader);
    glDeleteShader(shader);  // lives as long as it is attached
  }
  link(id(), vertex + " and " + fragment);
}

Program Program::compute(const std::string& shader, const ShaderDefines& defines) {
  Program program;
  program.handle_ = GlHandle<delete_program>(glCreateProgram());
  const GLuint compiled = compile(GL_COMPUTE_SHADER, shader, defines);
  glAttachShader(program.id(), compiled);
  glDeleteShader(compiled);
  link(program.id(), shader);
  return program;
}

void Program::use() const {
  glUseProgram(id());
}

int Program::location(const char* name) const {
  const auto found = locations_.find(name);
  if (found != locations_.end()) return found->second;
  return locations_.emplace(name, glGetUniformLocation(id(), name)).first->second;
}

void Program::set(const char* name, bool value) const {
  glProgramUniform1i(id(), location(name), value ? 1 : 0);
}
void Program::set(const char* name, int value) const {
  glProgramUniform1i(id(), location(name), value);
}
void Program::set(const char* name, float value) const {
  glProgramUniform1f(id(), location(name), value);
}
void Program::set(const char* name, const glm::vec2& value) const {
  glProgramUniform2fv(id(), location(name), 1, glm::value_ptr(value));
}
void Program::set(const char* name, const glm::vec3& value) const {
  glProgramUniform3fv(id(), location(name), 1, glm::value_ptr(value));
}
void Program::set(const char* name, const glm::vec4& value) const {
  glProgramUniform4fv(id(), location(name), 1, glm::value_ptr(value));
}
void Program::set(const char* name, const glm::ivec2& value) const {
  glProgramUniform2iv(id(), location(name), 1, glm::value_ptr(value));
}
void Program::set(const char* name, const glm::mat3& value) const {
  glProgramUniformMatrix3fv(id(), location(name), 1, GL_FALSE, glm::value_ptr(value));
}
void Program::set(const char* name, const glm::mat4& value) const {
  glProgramUniformMatrix4fv(id(), location(name), 1, GL_FALSE, glm::value_ptr(value));
}

namespace {

std::string program_key(const std::string& shaders, const ShaderDefines& defines) {
  std::string key = shaders;
  for (const std::string& define : defines) key += "\n" + define;
  return key;
}

}  // namespace

const Program& ProgramCache::get(const std::string& vertex, const std::string& fragment,
                                 const ShaderDefines& defines) {
  const std::string key = program_key(vertex + "\n" + fragment, defines);
  const auto found = programs_.find(key);
  if (found != programs_.end()) return found->second;
  return programs_.emplace(key, Program(vertex, fragment, defines)).first->second;
}

const Program& ProgramCache::get_compute(const std::string& shader, const ShaderDefines& defines) {
  const std::string key = program_key(shader, defines);
  const auto found = programs_.find(key);
  if (found != programs_.end()) return found->second;
  return programs_.emplace(key, Program::compute(shader, defines)).first->second;
}

}  // namespace lightbench
