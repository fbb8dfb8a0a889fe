#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "scene/scene.h"

namespace lightbench {

/// A camera with everything that shaders need. Depth is kept as linear eye-space z divided by `far`; it may
/// exceed 1, since nothing is cut off at `far`, and is 0 where there is no geometry.
struct FrameCamera {
  glm::vec3 position;
  CameraFrame frame;
  float near = 0;
  float far = 0;
  float tan_half_x = 0;  ///< half the image's width at distance 1
  float tan_half_y = 0;
  /// f_o, f_u, f_v of the image-space radiosity thesis (eq. 23-24), turned into world space: the far plane's
  /// lower left corner seen from the camera, and its full edges. World position = position + (f_o + x f_u + y
  /// f_v) z with x to the right and y up in 0..1 and z as kept.
  glm::vec3 far_corner;
  glm::vec3 far_u;
  glm::vec3 far_v;
  glm::dmat4 eye_from_world;   ///< right-handed, looking along -z
  glm::dmat4 clip_from_world;  ///< reversed z without a far plane: depth = near / z, 1 at the near plane, 0
                               ///< at infinity
};

/// `aspect` is width / height.
FrameCamera frame_camera(const Camera& camera, float aspect, const DepthRange& range);

/// The same camera seeing `factor` times as far to each side: for images with a guard band.
FrameCamera widened(const FrameCamera& camera, float factor);

/// A camera at the same place that looks along other axes, with the same field of view, of that tangent of
/// its half, to both sides.
FrameCamera turned(const FrameCamera& camera, const CameraFrame& frame, float tan_half);

/// Whether a box may be in sight of a clip space of reversed z (w >= 0 in front): false only when it
/// certainly is not.
bool may_be_visible(const Bounds& box, const glm::dmat4& clip_from_box);

/// Pixels of a picture; row 0 at the bottom, as OpenGL counts.
struct PixelRect {
  glm::ivec2 low{0};
  glm::ivec2 size{0};
};

/// Holds all pixels of a picture of that size in which something of a box may be seen: none where
/// may_be_visible is false, the whole picture where the box reaches behind the near plane.
PixelRect pixels_of_box(const Bounds& box, const glm::dmat4& clip_from_box, const glm::ivec2& picture);

}  // namespace lightbench
