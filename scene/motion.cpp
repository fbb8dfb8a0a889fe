#include "scene/motion.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "base/error.h"
#include "scene/nearest_surface.h"
#include "scene/transform.h"

namespace lightbench {
namespace {

// A view direction and an up vector closer than this (sine of the angle) give no usable frame in 32-bit
// floats.
constexpr float kSmallestSine = 1e-4f;

/// The two keyframes that a time lies between, and which part of the way it is from the first to the second.
template <typename Key>
struct Span {
  const Key& from;
  const Key& to;
  double part;
};

template <typename Key>
Span<Key> span_at(const std::vector<Key>& keys, double time) {
  const auto after = std::ranges::find_if(keys, [&](const Key& key) { return key.time > time; });
  if (after == keys.begin()) return {keys.front(), keys.front(), 0};
  if (after == keys.end()) return {keys.back(), keys.back(), 0};
  const Key& before = *(after - 1);
  return {before, *after, (time - before.time) / (after->time - before.time)};
}

glm::dmat4 placement(const MotionKey& key) {
  return glm::scale(glm::translate(glm::dmat4(1), key.translate) * rotation_degrees(key.rotate), key.scale);
}

}  // namespace

Camera camera_at(const std::vector<CameraKey>& keys, double time) {
  const auto [from, to, part] = span_at(keys, time);
  const auto t = float(part);
  // Rounding must not lead out of the range that each keyframe's fov lies in.
  const auto [narrow, wide] = std::minmax(from.camera.fov, to.camera.fov);
  return {.position = glm::mix(from.camera.position, to.camera.position, t),
          .look_at = glm::mix(from.camera.look_at, to.camera.look_at, t),
          .up = glm::mix(from.camera.up, to.camera.up, t),
          .fov = std::clamp(glm::mix(from.camera.fov, to.camera.fov, t), narrow, wide)};
}

std::string camera_problem(const Camera& camera) {
  const glm::vec3 view = camera.look_at - camera.position;
  if (!(glm::length(view) > 0)) return "the camera's position is its look_at";
  if (!(glm::length(camera.up) > 0)) return "the camera's up is zero";
  const float sine = glm::length(glm::cross(glm::normalize(view), glm::normalize(camera.up)));
  return sine > kSmallestSine ? "" : "the camera's up is along its view";
}

View view_at(const View& view, double time) {
  View result = view;
  result.time = time;
  if (view.keyframes.empty()) return result;
  result.camera = camera_at(view.keyframes, time);
  const std::string problem = camera_problem(result.camera);
  if (!problem.empty()) throw Error(fmt::format("at {} s {}", time, problem), view.where);
  return result;
}

glm::mat4 transform_at(const Motion& motion, double time) {
  const auto [from, to, part] = span_at(motion.keys, time);
  const MotionKey key{.time = time,
                      .translate = glm::mix(from.translate, to.translate, part),
                      .rotate = glm::mix(from.rotate, to.rotate, part),
                      .scale = glm::mix(from.scale, to.scale, part)};
  return glm::mat4(placement(key) * glm::dmat4(motion.rest));
}

bool moves(const Scene& scene) {
  return std::ranges::any_of(scene.entities, [](const Entity& e) { return !e.motion.keys.empty(); });
}

void set_time(Scene& scene, double time) {
  scene.time = time;
  for (Entity& entity : scene.entities)
    if (!entity.motion.keys.empty()) entity.transform = transform_at(entity.motion, time);
}

Bounds swept_bounds(const Scene& scene) {
  Bounds bounds;
  for (const Entity& entity : scene.entities) {
    const std::vector<glm::vec3>& positions = scene.meshes[std::size_t(entity.mesh)].positions;
    if (entity.motion.keys.empty()) {
      for (const glm::vec3& p : positions) bounds.add(transform_point(entity.transform, p));
      continue;
    }
    // However it turns, the entity stays in a sphere around what its origin is moved to.
    float radius = 0;
    for (const glm::vec3& p : positions)
      radius = std::max(radius, glm::length(transform_point(entity.motion.rest, p)));
    for (const MotionKey& key : entity.motion.keys) {
      const glm::vec3 scale(glm::abs(key.scale));
      const float reach = radius * std::max({scale.x, scale.y, scale.z});
      bounds.add(glm::vec3(key.translate) - reach);
      bounds.add(glm::vec3(key.translate) + reach);
    }
  }
  return bounds;
}

}  // namespace lightbench
