#include "renderer/paths/path_lights.h"

#include <cmath>

#include "scene/light_points.h"

namespace lightbench {
namespace {

Float8 clamp01(Float8 v) {
  return min8(max8(v, splat(0)), splat(1));
}

/// ks max(R.V, 0)^Ns; powers are taken only where something shines.
Float8 phong(const Surfaces8& s, const Vec8& to_light, Float8 n_dot_l, const Vec8& viewer) {
  const Vec8 reflected = s.normal * (2 * n_dot_l) - to_light;
  const Float8 r_dot_v = dot(reflected, viewer);
  Float8 result{};
  for_lanes((s.specular > 0) & (r_dot_v > 0) & (n_dot_l > 0),
            [&](int i) { result[i] = s.specular[i] * std::pow(r_dot_v[i], s.exponent[i]); });
  return result;
}

}  // namespace

PathLight::PathLight(const Light& light)
    : light_(light),
      radiance_(light.color * light.power),
      cos_inner_(std::cos(light.inner_angle)),
      cos_outer_(std::cos(light.outer_angle)) {}

Float8 PathLight::attenuation(Float8 distance) const {
  const Attenuation& a = light_.attenuation;
  if (a.kind == Attenuation::Kind::none) return splat(1);
  if (a.kind == Attenuation::Kind::fade && a.power == 2) {
    const Float8 part = distance * (1 / a.distance);
    return 2 / (1 + part * part);
  }
  Float8 result{};
  for (int i = 0; i < kLanes; ++i) result[i] = attenuation_factor(a, distance[i]);
  return result;
}

Float8 PathLight::cone(const Vec8& to_light) const {
  if (light_.kind != LightKind::spot) return splat(1);
  const Float8 cosine = -dot(to_light, splat(light_.direction));
  if (cos_inner_ <= cos_outer_) return select(cosine >= cos_outer_, splat(1), splat(0));
  const Float8 t = clamp01((cosine - cos_outer_) * (1 / (cos_inner_ - cos_outer_)));
  return t * t * (3 - 2 * t);
}

Incident8 PathLight::incident(const Surfaces8& s, const Vec8& position) const {
  Incident8 result;
  Float8 strength;
  if (directional()) {
    result.unit = result.to_light = splat(-light_.direction);
    strength = splat(1);
  } else {
    result.to_light = position - s.position;
    const Float8 distance = max8(sqrt8(dot(result.to_light, result.to_light)), splat(1e-12f));
    result.unit = result.to_light * (1 / distance);
    strength = attenuation(distance) * cone(result.unit);
  }
  result.n_dot_l = dot(s.normal, result.unit);
  result.radiance = splat(radiance_) * select(result.n_dot_l > 0, strength, splat(0));
  return result;
}

Arriving8 PathLight::reflect(const Surfaces8& s, const Vec8& viewer) const {
  const Incident8 light = incident(s);
  Arriving8 result{light.radiance * s.albedo * light.n_dot_l, light.to_light};
  if (any(s.specular > 0))
    result.reflected = result.reflected + light.radiance * phong(s, light.unit, light.n_dot_l, viewer);
  return result;
}

std::vector<PathLight> path_lights(const Scene& scene) {
  std::vector<PathLight> result;
  for (const Light& light : light_points(scene))
    if (light.power != 0 && light.color != glm::vec3(0)) result.emplace_back(light);
  return result;
}

}  // namespace lightbench
