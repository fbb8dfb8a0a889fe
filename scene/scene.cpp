#include "scene/scene.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>

#include "scene/nearest_surface.h"

namespace lightbench {

namespace {

// The near plane is derived for pictures at most this much wider than the view: a guard band around a wide
// picture.
constexpr float kWidestAspect = 2.4f;
constexpr float kWidestGuardBand = 3.0f;

// Bounds of near / far. The lower one is what a 32-bit float depth buffer still resolves.
constexpr float kSmallestNear = 1e-6f;
constexpr float kLargestNear = 1e-2f;

float computed_far(const Scene& scene, const Camera& camera) {
  const Bounds bounds = world_bounds(scene);
  if (bounds.empty()) return 1.0f;
  const glm::vec3 forward = camera_frame(camera).forward;
  float far = 0;
  for (const glm::vec3& corner : corners(bounds))
    far = std::max(far, glm::dot(corner - camera.position, forward));
  // A camera that looks away from everything still needs a volume that is not empty.
  return std::max(1.001f * far, 1e-3f * std::max(bounds.diagonal(), std::numeric_limits<float>::min()));
}

// Whatever stands at distance d from the camera has at least the depth d cos(angle) anywhere in the picture.
float computed_near(const Scene& scene, const Camera& camera, float far) {
  const float tangent = std::tan(0.5f * camera.fov) * kWidestGuardBand;
  const float corner_cosine =
      1.0f / std::sqrt(1.0f + tangent * tangent * (1.0f + kWidestAspect * kWidestAspect));
  const float safe = 0.99f * corner_cosine * distance_to_nearest_surface(scene, camera.position);
  return std::clamp(safe, kSmallestNear * far, kLargestNear * far);
}

}  // namespace

float attenuation_factor(const Attenuation& attenuation, float d) {
  switch (attenuation.kind) {
    case Attenuation::Kind::none:
      return 1.0f;
    case Attenuation::Kind::fade:
      return 2.0f / (1.0f + std::pow(d / attenuation.distance, attenuation.power));
    case Attenuation::Kind::inverse_square:
      return 1.0f / (d * d);
    case Attenuation::Kind::radius: {
      const float part = d / attenuation.radius;
      return std::max(1.0f - part * part, 0.0f);
    }
  }
  return 1.0f;
}

CameraFrame camera_frame(const Camera& camera) {
  CameraFrame frame;
  frame.forward = glm::normalize(camera.look_at - camera.position);
  frame.right = glm::normalize(glm::cross(frame.forward, camera.up));
  frame.up = glm::cross(frame.right, frame.forward);
  return frame;
}

void Bounds::add(const glm::vec3& p) {
  min = glm::min(min, p);
  max = glm::max(max, p);
}

float Bounds::diagonal() const {
  return empty() ? 0.0f : glm::length(max - min);
}

Bounds entity_bounds(const Scene& scene, std::size_t entity) {
  Bounds bounds;
  const Entity& placed = scene.entities[entity];
  for (const glm::vec3& p : scene.meshes[std::size_t(placed.mesh)].positions)
    bounds.add(transform_point(placed.transform, p));
  return bounds;
}

Bounds world_bounds(const Scene& scene) {
  Bounds bounds;
  for (std::size_t i = 0; i < scene.entities.size(); ++i) {
    const Bounds entity = entity_bounds(scene, i);
    if (entity.empty()) continue;
    bounds.add(entity.min);
    bounds.add(entity.max);
  }
  return bounds;
}

std::size_t triangle_count(const Scene& scene) {
  std::size_t count = 0;
  for (const Entity& entity : scene.entities)
    count += scene.meshes[std::size_t(entity.mesh)].triangles.size();
  return count;
}

std::vector<std::filesystem::path> file_paths(const Scene& scene) {
  std::vector<std::filesystem::path> paths;
  for (const SourceFile& file : scene.files) paths.push_back(file.path);
  return paths;
}

std::size_t texture_bytes(const Scene& scene) {
  std::size_t bytes = 0;
  for (const Texture& texture : scene.textures) bytes += texture.pixels.data.size();
  return bytes;
}

DepthRange depth_range(const Scene& scene, const Camera& camera) {
  DepthRange range;
  range.far = scene.far ? *scene.far : computed_far(scene, camera);
  range.near = scene.near ? *scene.near : computed_near(scene, camera, range.far);
  // A given near may lie behind a computed far, or the other way round.
  if (range.near >= range.far) range.far = 2.0f * range.near;
  return range;
}

}  // namespace lightbench
