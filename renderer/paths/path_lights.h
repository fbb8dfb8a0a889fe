#pragma once

#include <vector>

#include "renderer/paths/surfaces.h"

namespace lightbench {

/// The light that one light point sends to eight surfaces, before anything stands in its way.
struct Arriving8 {
  Vec8 reflected;  ///< towards the viewer: diffuse and specular, without the surfaces' emission
  Vec8 to_light;   ///< to the light's place, or against a directional light; a shadow ray's direction
};

/// What one light point sends to eight surfaces that nothing hides from it.
struct Incident8 {
  Vec8 radiance;  ///< that a white diffuse surface facing the light shows; 0 behind the surface's horizon
  Vec8 to_light;  ///< as in Arriving8
  Vec8 unit;      ///< its direction
  Float8 n_dot_l;
};

/// A light point as paths need it.
class PathLight {
 public:
  /// Not an area light: those are points already (scene/light_points.h).
  explicit PathLight(const Light& light);

  Incident8 incident(const Surfaces8& surfaces) const { return incident(surfaces, splat(light_.position)); }
  /// The same of a light that stands elsewhere, in each lane at a place of its own.
  Incident8 incident(const Surfaces8& surfaces, const Vec8& position) const;
  /// `viewer` is the unit direction from the surfaces to who looks at them. The equations are those of
  /// shaders/direct.frag.glsl.
  Arriving8 reflect(const Surfaces8& surfaces, const Vec8& viewer) const;
  bool directional() const { return light_.kind == LightKind::directional; }

 private:
  Float8 attenuation(Float8 distance) const;
  Float8 cone(const Vec8& to_light) const;

  Light light_;
  glm::vec3 radiance_;  ///< colour * power
  float cos_inner_, cos_outer_;
};

/// The light points of a scene that can send any light.
std::vector<PathLight> path_lights(const Scene& scene);

}  // namespace lightbench
