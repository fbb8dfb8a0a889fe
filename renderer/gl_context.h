#pragma once

#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "renderer/renderer.h"

namespace lightbench {

/// An OpenGL 4.5 core context without a window. Only framebuffer objects are drawn to.
class GlContext {
 public:
  virtual ~GlContext() = default;
  GlContext(const GlContext&) = delete;
  GlContext& operator=(const GlContext&) = delete;

  /// Makes the context current on this thread and OpenGL's functions those of its library.
  void make_current();

  /// Throws Error where OpenGL ran out of memory and std::logic_error for any other complaint of it since the
  /// last call.
  void check(const std::string& where);

  /// Forgets complaints that were answered already, by an exception where they arose.
  void forget_complaints();

  /// Backend, GL_RENDERER and GL_VERSION.
  std::string description();
  int max_texture_size();

 protected:
  using Function = void (*)();
  using Loader = Function (*)(const char* name);

  GlContext(std::string name, Loader loader) : name_(std::move(name)), loader_(loader) {}
  /// To be called at the end of a backend's constructor.
  void start();

 private:
  virtual void bind() = 0;

  std::string name_;
  Loader loader_;
  std::mutex mutex_;  // drivers may report from threads of their own
  std::vector<std::string> complaints_;
};

/// Throws Error when the backend is not there or does not give OpenGL 4.5 core. EGL needs no surface: it
/// takes the first graphics device that gives a context, then Mesa's surfaceless platform.
std::unique_ptr<GlContext> make_gl_context(GlBackend backend);

/// Throws Error when the last call ran out of memory; `what` says what could not be made.
void throw_if_out_of_memory(const std::string& what);

}  // namespace lightbench
