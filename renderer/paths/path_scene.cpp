#include "renderer/paths/path_scene.h"

#include <cmath>

#include <glm/geometric.hpp>

namespace lightbench {

PathCamera::PathCamera(const Camera& camera, int width, int height)
    : position_(camera.position),
      frame_(camera_frame(camera)),
      tan_half_x_(std::tan(double(camera.fov) / 2) * width / height),
      tan_half_y_(std::tan(double(camera.fov) / 2)),
      width_(width),
      height_(height) {}

glm::vec3 PathCamera::direction(int x, int y) const {
  const double right = (2 * (x + 0.5) / width_ - 1) * tan_half_x_;
  const double up = (1 - 2 * (y + 0.5) / height_) * tan_half_y_;
  return glm::vec3(glm::normalize(glm::dvec3(frame_.forward) + right * glm::dvec3(frame_.right) +
                                  up * glm::dvec3(frame_.up)));
}

}  // namespace lightbench
