#pragma once

#include <optional>

#include "renderer/caustics/caustics_cast.h"
#include "renderer/frame_camera.h"
#include "renderer/gl_framebuffer.h"

namespace lightbench {

class FrameContext;

/// The scene in the water as the water's surface shows it: refracted to a camera above it, and where it
/// reflects all light, to one below. What is shown does not depend on the direction that it is seen from, so
/// that it is drawn once, from the point that the rays which flat water sends on seem to come from, and each
/// pixel's own ray looks for what it meets there.
class WaterView {
 public:
  /// `mesh` is the water's.
  WaterView(FrameContext& frame, const Mesh& mesh);

  /// Where the scene is to be drawn from; none where the surface is not in the picture.
  const std::optional<FrameCamera>& camera() const { return camera_; }
  /// The picture's edge, in pixels.
  static constexpr int kSize = 1024;

  /// Draws the surface over `picture`, whose depth hides it; `below` is the scene from camera(), of kSize.
  /// Returns RGBA32F: relative to the camera, what a pixel of the surface shows; a: 1 where there is any.
  GlTexture draw(const GBuffer& gbuffer, const CausticsPicture& picture, const GBuffer& below_gbuffer,
                 const CausticsPicture& below) const;

 private:
  FrameContext& frame_;
  std::optional<FrameCamera> camera_;
  int triangle_count_ = 0;
  Buffer positions_, normals_, indices_;
  VertexArray vertices_;
};

}  // namespace lightbench
