#pragma once

#include <cmath>
#include <map>
#include <numbers>
#include <string>

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
