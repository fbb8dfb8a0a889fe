#pragma once

#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <utility>

#include "tests/renderer/render_scene.h"

/// Scenes whose indirect light is known, for the tests of image-space radiosity.
namespace lightbench::test {

inline Material glowing(float radiance) {
  Material material = matte(glm::vec3(0));
  material.emission = glm::vec3(radiance);
  return material;
}

inline View view_from(const glm::vec3& position, const glm::vec3& look_at, float fov) {
  View view;
  view.name = "view";
  view.camera.position = position;
  view.camera.look_at = look_at;
  view.camera.fov = fov;
  return view;
}

inline FrameResult render_isr(const Scene& scene, const View& view,
                              std::map<std::string, ParamValue> params = {}, int width = 128,
                              int height = 96) {
  return render(scene, view,
                {.technique = "isr",
                 .params = std::move(params),
                 .width = width,
                 .height = height,
                 .buffers = {"indirect", "occlusion"}});
}

using Params = std::map<std::string, ParamValue>;

/// With visibility, all around the camera.
inline Params bitmask(const Params& more = {}) {
  Params params{{"visibility", "bitmask"}, {"cameras", "cube"}, {"camera_size", 64LL}};
  for (const auto& [name, value] : more) params[name] = value;
  return params;
}

/// A closed box, -1..1 along each axis; all normals look inside.
inline void add_box_inside(Scene& scene, int material) {
  add_quad(scene, {-1, -1, 1}, {2, 0, 0}, {0, 0, -2}, material);
  add_quad(scene, {-1, 1, -1}, {2, 0, 0}, {0, 0, 2}, material);
  add_quad(scene, {-1, -1, -1}, {2, 0, 0}, {0, 2, 0}, material);
  add_quad(scene, {1, -1, 1}, {-2, 0, 0}, {0, 2, 0}, material);
  add_quad(scene, {-1, -1, 1}, {0, 0, -2}, {0, 2, 0}, material);
  add_quad(scene, {1, -1, -1}, {0, 0, 2}, {0, 2, 0}, material);
}

/// A solid block on the floor of that box; normals look outwards.
inline void add_block(Scene& scene, int material) {
  const glm::vec3 low(-0.4f, -1, -0.5f), high(0.2f, -0.2f, 0);
  const glm::vec3 size = high - low;
  add_quad(scene, {low.x, high.y, high.z}, {size.x, 0, 0}, {0, 0, -size.z}, material);
  add_quad(scene, {low.x, low.y, high.z}, {size.x, 0, 0}, {0, size.y, 0}, material);
  add_quad(scene, {high.x, low.y, low.z}, {-size.x, 0, 0}, {0, size.y, 0}, material);
  add_quad(scene, {low.x, low.y, low.z}, {0, 0, size.z}, {0, size.y, 0}, material);
  add_quad(scene, {high.x, low.y, high.z}, {0, 0, -size.z}, {0, size.y, 0}, material);
}

/// All surfaces glow with radiance 1 and send back 0.6 of what arrives.
inline Scene furnace() {
  Scene scene;
  scene.name = "furnace";
  scene.materials = {glowing(1)};
  scene.materials[0].diffuse = glm::vec3(0.6f);
  add_box_inside(scene, 0);
  return scene;
}
inline View furnace_view() {
  return view_from({0.3f, 0.2f, 0.8f}, {-0.2f, -0.4f, -1}, 1.1f);
}

/// Smallest and largest value of the first component.
inline std::pair<float, float> range_of(const Image& image) {
  std::pair<float, float> range{1e30f, -1e30f};
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const float value = image.pixel(x, y)[0];
      range = {std::min(range.first, value), std::max(range.second, value)};
    }
  return range;
}

inline double mean_of(const Image& image) {
  double sum = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) sum += image.pixel(x, y)[0];
  return sum / (double(image.width) * image.height);
}

/// Form factor from a point to a rectangle in a parallel plane at distance `h` that spans 0..a, 0..b from the
/// point's foot: signed, so that rectangles elsewhere are sums of four.
inline double corner_parallel(double a, double b, double h) {
  const double x = a / h;
  const double y = b / h;
  const double u = std::sqrt(1 + x * x);
  const double v = std::sqrt(1 + y * y);
  return (x / u * std::atan(y / u) + y / v * std::atan(x / v)) / (2 * std::numbers::pi);
}

/// Two unit squares that face each other at distance 1, the upper one glowing with radiance 1, the lower one
/// white, seen from the side.
inline Scene plates() {
  Scene scene;
  scene.name = "plates";
  scene.materials = {matte(glm::vec3(1)), glowing(1)};
  add_quad(scene, {-0.5f, 0, 0.5f}, {1, 0, 0}, {0, 0, -1}, 0);
  add_quad(scene, {-0.5f, 1, -0.5f}, {1, 0, 0}, {0, 0, 1}, 1);
  return scene;
}

/// What the lower plate shows relative to what its form factor says, over its pixels: radiance 1 times
/// albedo 1.
inline double plates_ratio(std::map<std::string, ParamValue> params, int height = 192) {
  const View view = view_from({0, 0.5f, 2.2f}, {0, 0.5f, 0}, 0.9f);
  const int width = height * 4 / 3;
  const FrameResult result = render_isr(plates(), view, std::move(params), width, height);
  const Image& indirect = result.buffers.at("indirect");
  double shown = 0;
  double expected = 0;
  for (int y = height / 2; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      if (result.image.pixel(x, y)[3] < 1) continue;
      const double tan_half = std::tan(0.45);
      const double down = tan_half * (2 * (y + 0.5) / height - 1);
      const double depth = 0.5 / down;  // of the plate's plane at this row
      const double px = depth * tan_half * width / height * (2 * (x + 0.5) / width - 1);
      const double pz = 2.2 - depth;
      expected += corner_parallel(0.5 - px, 0.5 - pz, 1) + corner_parallel(0.5 + px, 0.5 - pz, 1) +
                  corner_parallel(0.5 - px, 0.5 + pz, 1) + corner_parallel(0.5 + px, 0.5 + pz, 1);
      shown += indirect.pixel(x, y)[0];
    }
  return shown / expected;
}

}  // namespace lightbench::test
