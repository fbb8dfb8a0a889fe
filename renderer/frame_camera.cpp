#include "renderer/frame_camera.h"

#include <array>
#include <cmath>

#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

namespace lightbench {
namespace {

glm::dmat4 eye_matrix(const CameraFrame& frame, const glm::dvec3& position) {
  const glm::dvec3 right(frame.right), up(frame.up), back(-frame.forward);
  glm::dmat4 matrix(1.0);
  for (int i = 0; i < 3; ++i) {
    matrix[i][0] = right[i];
    matrix[i][1] = up[i];
    matrix[i][2] = back[i];
  }
  matrix[3] = glm::dvec4(-glm::dot(right, position), -glm::dot(up, position), -glm::dot(back, position), 1.0);
  return matrix;
}

// x and y by the field of view; z = near and w = distance give the reversed depth near / distance.
glm::dmat4 reversed_projection(double tan_half_x, double tan_half_y, double near) {
  glm::dmat4 matrix(0.0);
  matrix[0][0] = 1.0 / tan_half_x;
  matrix[1][1] = 1.0 / tan_half_y;
  matrix[2][3] = -1.0;
  matrix[3][2] = near;
  return matrix;
}

std::array<glm::dvec4, 8> clip_corners(const Bounds& box, const glm::dmat4& clip_from_box) {
  std::array<glm::dvec4, 8> corners;
  for (std::size_t i = 0; i < corners.size(); ++i)
    corners[i] = clip_from_box * glm::dvec4((i & 1) ? box.max.x : box.min.x, (i & 2) ? box.max.y : box.min.y,
                                            (i & 4) ? box.max.z : box.min.z, 1.0);
  return corners;
}

void derive(FrameCamera& camera) {
  const float half_width = camera.far * camera.tan_half_x;
  const float half_height = camera.far * camera.tan_half_y;
  camera.far_u = camera.frame.right * (2 * half_width);
  camera.far_v = camera.frame.up * (2 * half_height);
  camera.far_corner =
      camera.frame.forward * camera.far - camera.frame.right * half_width - camera.frame.up * half_height;
  camera.eye_from_world = eye_matrix(camera.frame, camera.position);
  camera.clip_from_world =
      reversed_projection(camera.tan_half_x, camera.tan_half_y, camera.near) * camera.eye_from_world;
}

}  // namespace

FrameCamera frame_camera(const Camera& camera, float aspect, const DepthRange& range) {
  FrameCamera result;
  result.position = camera.position;
  result.frame = camera_frame(camera);
  result.near = range.near;
  result.far = range.far;
  result.tan_half_y = std::tan(camera.fov / 2);
  result.tan_half_x = result.tan_half_y * aspect;
  derive(result);
  return result;
}

FrameCamera widened(const FrameCamera& camera, float factor) {
  FrameCamera result = camera;
  result.tan_half_x *= factor;
  result.tan_half_y *= factor;
  derive(result);
  return result;
}

FrameCamera turned(const FrameCamera& camera, const CameraFrame& frame, float tan_half) {
  FrameCamera result = camera;
  result.frame = frame;
  result.tan_half_x = tan_half;
  result.tan_half_y = tan_half;
  derive(result);
  return result;
}

bool may_be_visible(const Bounds& box, const glm::dmat4& clip_from_box) {
  // One bit for each side of the clip volume that a corner lies beyond.
  unsigned beyond_all = 0x3f;
  for (const glm::dvec4& c : clip_corners(box, clip_from_box)) {
    const std::array<bool, 6> beyond{c.x<-c.w, c.x> c.w, c.y<-c.w, c.y> c.w, c.z<0, c.z> c.w};
    unsigned bits = 0;
    for (unsigned side = 0; side < beyond.size(); ++side) bits |= unsigned(beyond[side]) << side;
    beyond_all &= bits;
  }
  return beyond_all == 0;
}

PixelRect pixels_of_box(const Bounds& box, const glm::dmat4& clip_from_box, const glm::ivec2& picture) {
  if (!may_be_visible(box, clip_from_box)) return {};
  const glm::dvec2 size(picture);
  glm::dvec2 low = size, high(0);
  for (const glm::dvec4& c : clip_corners(box, clip_from_box)) {
    if (c.z > c.w) return {glm::ivec2(0), picture};
    const glm::dvec2 corner = (glm::dvec2(c) / c.w + 1.0) * 0.5 * size;
    low = glm::min(low, corner);
    high = glm::max(high, corner);
  }
  // A pixel more on each side: OpenGL rounds vertices to parts of pixels, and computes them in floats.
  low = glm::clamp(glm::floor(low) - 1.0, glm::dvec2(0), size);
  high = glm::clamp(glm::ceil(high) + 1.0, low, size);
  return {glm::ivec2(low), glm::ivec2(high - low)};
}

}  // namespace lightbench
