#pragma once

#include <vector>

#include "renderer/embree_scene.h"
#include "renderer/paths/emitters.h"
#include "renderer/paths/path_lights.h"
#include "renderer/paths/surfaces.h"

namespace lightbench {

/// Everything that paths look up, built once for a scene and read by all threads. Keeps a reference to it.
struct PathScene {
  explicit PathScene(const Scene& source)
      : scene(source),
        embree(source),
        surfaces(source, embree),
        lights(path_lights(source)),
        emitters(source),
        sky(source.background.lights ? source.background.color : glm::vec3(0)) {}

  const Scene& scene;
  EmbreeScene embree;
  SurfaceTable surfaces;
  std::vector<PathLight> lights;
  Emitters emitters;
  glm::vec3 sky;  ///< what rays bring that miss everything
};

/// The rays of a view through the centres of width * height pixels.
class PathCamera {
 public:
  PathCamera(const Camera& camera, int width, int height);
  /// The unit direction of the ray through a pixel, row 0 on top.
  glm::vec3 direction(int x, int y) const;
  const glm::vec3& position() const { return position_; }
  const CameraFrame& frame() const { return frame_; }
  /// Tangents of half the field of view.
  glm::vec2 tan_half() const { return {tan_half_x_, tan_half_y_}; }

 private:
  glm::vec3 position_;
  CameraFrame frame_;
  double tan_half_x_, tan_half_y_;
  int width_, height_;
};

}  // namespace lightbench
