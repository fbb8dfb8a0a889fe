#pragma once

#include <memory>

#include "renderer/frame_context.h"
#include "renderer/gl_context.h"
#include "renderer/gpu_scene.h"
#include "tests/renderer/render_scene.h"

namespace lightbench::test {

/// What is needed to draw maps of a scene outside of a technique. The scene must outlive it.
class GlFrame {
 public:
  explicit GlFrame(const Scene& scene)
      : request_{scene, view_, 64, 48, 1, {}}, gpu_scene_(scene), frame_(request_, &gpu_, &gpu_scene_) {}

  FrameContext& context() { return frame_; }

 private:
  std::unique_ptr<GlContext> gl_ = make_gl_context(GlBackend::osmesa);
  View view_ = top_view(3);
  FrameRequest request_;
  GpuState gpu_;
  GpuScene gpu_scene_;
  FrameContext frame_;
};

}  // namespace lightbench::test
