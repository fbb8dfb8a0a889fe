#include "renderer/caustics/water_view.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <glad/gl.h>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>

#include "renderer/caustics/caustics_shaders.h"
#include "renderer/frame_context.h"
#include "renderer/gpu_scene.h"
#include "scene/water.h"

namespace lightbench {
namespace {

/// The way that flat water sends a ray of the camera on into the water: refracted from above, reflected from
/// below.
glm::dvec3 sent_on(const Water& water, const glm::dvec3& direction) {
  if (direction.y < 0) return *refracted(direction, {0, 1, 0}, 1 / double(water.ior));
  return {direction.x, -direction.y, direction.z};
}

/// A ray that the surface sends on.
struct SentRay {
  glm::dvec3 start, way;
};

/// From the vertices in sight, as from flat water.
std::vector<SentRay> sent_rays(const Water& water, const Mesh& mesh, const FrameCamera& camera) {
  std::vector<SentRay> rays;
  for (const glm::vec3& position : mesh.positions) {
    const glm::dvec3 start(position);
    const glm::dvec4 clip = camera.clip_from_world * glm::dvec4(start, 1);
    // A little more than the picture, so that a surface whose vertices lie around it counts.
    if (clip.w <= 0 || std::abs(clip.x) > 1.2 * clip.w || std::abs(clip.y) > 1.2 * clip.w) continue;
    rays.push_back({start, sent_on(water, glm::normalize(start - glm::dvec3(camera.position)))});
  }
  return rays;
}

/// What of the scene lies in the water.
Bounds bounds_below(const Bounds& scene, const Water& water) {
  Bounds bounds = scene;
  bounds.max.y = std::min(bounds.max.y, float(highest_crest(water)));
  return bounds;
}

/// The point that the rays seem to come from: nearest to all their lines, in the sense of least squares.
/// Where they are all but parallel, far away.
glm::dvec3 seeming_origin(const std::vector<SentRay>& rays, const glm::dvec3& mean, const Bounds& bounds) {
  constexpr double kFarthest = 40;  // radii of what is seen
  constexpr double kPull = 1e-6;    // towards the farthest place, of a ray's own
  const double count = double(rays.size());
  const glm::dvec3 farthest =
      glm::dvec3(bounds.center()) - kFarthest * 0.5 * double(bounds.diagonal()) * mean;
  glm::dmat3 sum(kPull * count);
  glm::dvec3 right = kPull * count * farthest;
  for (const SentRay& ray : rays) {
    const glm::dmat3 across = glm::dmat3(1) - glm::outerProduct(ray.way, ray.way);
    sum += across;
    right += across * ray.start;
  }
  return glm::inverse(sum) * right;
}

FrameCamera camera_for(const std::vector<SentRay>& rays, const Bounds& bounds) {
  glm::dvec3 mean(0);
  for (const SentRay& ray : rays) mean += ray.way;
  mean = glm::normalize(mean);
  Camera camera;
  camera.position = glm::vec3(seeming_origin(rays, mean, bounds));
  camera.look_at = camera.position + glm::vec3(double(bounds.diagonal()) * mean);
  camera.up = std::abs(mean.y) > 0.9 ? glm::vec3(0, 0, 1) : glm::vec3(0, 1, 0);
  const CameraFrame frame = camera_frame(camera);
  double widest = 0, nearest = std::numeric_limits<double>::max(), farthest = 0;
  const auto hold = [&](const glm::dvec3& point) {
    const glm::dvec3 d = point - glm::dvec3(camera.position);
    const double depth = glm::dot(d, glm::dvec3(frame.forward));
    nearest = std::min(nearest, depth);
    farthest = std::max(farthest, depth);
    if (depth > 0)
      widest = std::max({widest, std::abs(glm::dot(d, glm::dvec3(frame.right))) / depth,
                         std::abs(glm::dot(d, glm::dvec3(frame.up))) / depth});
  };
  for (const SentRay& ray : rays) {
    hold(ray.start);
    // Down to the lowest that there is, but no farther than all that there is.
    const double deepest = (double(bounds.min.y) - ray.start.y) / std::min(ray.way.y, -1e-3);
    hold(ray.start + std::clamp(deepest, 0.0, double(bounds.diagonal())) * ray.way);
  }
  constexpr double kWaves = 1.15, kWidest = 3;  // room for what waves bend aside; the tangent of 72 degrees
  camera.fov = float(2 * std::atan(std::min(kWaves * widest, kWidest)));
  const double least = 1e-3 * farthest;
  return frame_camera(camera, 1, {float(std::max(0.5 * nearest, least)), float(1.1 * farthest)});
}

/// Of surfaces to the map that are told from edges.
constexpr float kSteepest = 8;

}  // namespace

WaterView::WaterView(FrameContext& frame, const Mesh& mesh) : frame_(frame) {
  const Water& water = *frame.scene().water;
  const Bounds below = bounds_below(frame.gpu_scene().bounds(), water);
  const std::vector<SentRay> rays = sent_rays(water, mesh, frame.camera());
  if (rays.empty() || below.min.y > below.max.y) return;
  camera_ = camera_for(rays, below);
  std::vector<glm::vec3> positions;
  for (const glm::vec3& position : mesh.positions) positions.push_back(position - frame.camera().position);
  positions_ = buffer_of(positions);
  normals_ = buffer_of(mesh.normals);
  indices_ = buffer_of(mesh.triangles);
  triangle_count_ = int(mesh.triangles.size());
  vertices_.attribute(0, positions_, 3);
  vertices_.attribute(1, normals_, 3);
  vertices_.indices(indices_);
}

GlTexture WaterView::draw(const GBuffer& gbuffer, const CausticsPicture& picture,
                          const GBuffer& below_gbuffer, const CausticsPicture& below) const {
  const Water& water = *frame_.scene().water;
  GlTexture seen(TexelFormat::rgba32f, gbuffer.width, gbuffer.height);
  const Framebuffer target({&picture.image(), &seen}, &gbuffer.depth_stencil);
  target.bind();
  target.clear_color(1, 0, 0, 0, 0);
  set_surface_state();
  glDisable(GL_STENCIL_TEST);
  const Program& program = frame_.program(kWaterVertex, kWaterFragment);
  const glm::dvec3 eye(frame_.camera().position);
  const glm::dmat4 world_from_relative = glm::translate(glm::dmat4(1), eye);
  program.use();
  program.set("clip_from_relative", glm::mat4(frame_.camera().clip_from_world * world_from_relative));
  program.set("map_from_relative", glm::mat4(camera_->clip_from_world * world_from_relative));
  program.set("map_camera", glm::vec3(glm::dvec3(camera_->position) - eye));
  program.set("map_forward", camera_->frame.forward);
  program.set("map_far", camera_->far);
  program.set("reach", 2 * frame_.gpu_scene().bounds().diagonal());
  program.set("texel_slope", 2 * kSteepest * camera_->tan_half_y / float(kSize));
  program.set("ior", water.ior);
  program.set("absorption", water.absorption);
  program.set("background", frame_.scene().background.color);
  below_gbuffer.depth.bind(0);
  below.image().bind(1);
  glBindVertexArray(vertices_.id());
  glDrawElements(GL_TRIANGLES, 3 * triangle_count_, GL_UNSIGNED_INT, nullptr);
  return seen;
}

}  // namespace lightbench
