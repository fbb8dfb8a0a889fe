#pragma once

#include <memory>
#include <string>

#include "renderer/technique.h"

namespace lightbench {

enum class GlBackend { osmesa, egl };

/// Renders frames. The OpenGL context is made for the first frame that needs one, and the last scene stays on
/// the GPU, so tasks that share a scene should follow one another. One thread; fork before the first frame.
class Renderer {
 public:
  explicit Renderer(GlBackend backend);
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;
  ~Renderer();

  /// Throws Error when the technique cannot render the scene (all reasons), an unknown buffer is asked for
  /// (names the nearest), the size is not possible, or OpenGL is out of memory.
  FrameResult render(const Technique& technique, const ParamValues& params, const FrameRequest& request);

  /// Backend, GL_RENDERER and GL_VERSION; makes the context if need be.
  std::string description();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace lightbench
