#include "povexport/pov_lights.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>
#include <glm/trigonometric.hpp>

#include "scene/light_points.h"

namespace lightbench {
namespace {

/// Where 2 / (1 + (d / D)^2) is to be 1 / d^2, the power makes up for a small D; what is missing is a part of
/// (D / d)^2. In POV-Ray's units, in which a scene is 512 to 1024 large.
constexpr double kTinyFadeDistance = 1e-3;

struct Fade {
  double amplitude;
  double distance;  ///< 0: none
  double power;
};

/// Sum of fades nearest to saturate(1 - d)^2 in what an sRGB image shows of it, found by a search over 0..3.
constexpr Fade kRadiusFades[] = {
    {-0.0334692, 1.02044, 8.10217}, {-0.0687347, 1.17456, 4.56477}, {0.0959899, 0.0658654, 1.48387},
    {0.0581167, 0.872568, 4.45513}, {-0.106759, 1.48268, 2.04582},  {-0.00650634, 1.00507, 24},
    {0.559678, 0.479725, 1.77346},
};

std::vector<Fade> fades_of(const Light& light, double scale) {
  const Attenuation& attenuation = light.attenuation;
  if (light.kind == LightKind::directional) return {{1, 0, 0}};
  switch (attenuation.kind) {
    case Attenuation::Kind::none:
      return {{1, 0, 0}};
    case Attenuation::Kind::fade:
      return {{1, attenuation.distance, attenuation.power}};
    case Attenuation::Kind::inverse_square: {
      const double distance = kTinyFadeDistance / scale;
      return {{0.5 / (distance * distance), distance, 2}};
    }
    case Attenuation::Kind::radius:
      break;
  }
  std::vector<Fade> fades(std::begin(kRadiusFades), std::end(kRadiusFades));
  for (Fade& fade : fades) fade.distance *= attenuation.radius;
  return fades;
}

void write_light(PovWriter& out, const Light& light, const Fade& fade, const PovSpace& space,
                 bool shadowless) {
  const bool directional = light.kind == LightKind::directional;
  // A parallel light shines from its place on: outside of the scene, yet near enough for exact coordinates.
  const glm::dvec3 center(space.bounds.center());
  const glm::dvec3 far_away = center - glm::dvec3(light.direction) * (2.0 * space.bounds.diagonal());
  out.words("light_source{").vector(space.scale * (directional ? far_away : glm::dvec3(light.position)));
  out.words(" rgb").vector(glm::dvec3(light.color) * double(light.power) * fade.amplitude);
  if (directional) out.words(" parallel point_at").vector(space.scale * center);
  if (light.kind == LightKind::spot) {
    out.words(" spotlight radius ").number(glm::degrees(double(light.inner_angle)));
    out.words(" falloff ").number(glm::degrees(double(light.outer_angle))).words(" tightness 0");
    const glm::dvec3 aim = glm::dvec3(light.position) + glm::dvec3(light.direction);
    out.words(" point_at").vector(space.scale * aim);
  }
  if (fade.distance > 0) {
    out.words(" fade_distance ").number(space.scale * fade.distance);
    out.words(" fade_power ").number(fade.power);
  }
  if (shadowless) out.words(" shadowless");
  out.words("}\n");
}

}  // namespace

double radius_attenuation_by_fades(double part) {
  double sum = 0;
  for (const Fade& fade : kRadiusFades)
    sum += fade.amplitude * 2 / (1 + std::pow(part / fade.distance, fade.power));
  return sum;
}

PovWriter pov_light(const Light& light, const PovSpace& space, bool shadowless) {
  PovWriter out;
  for (const Light& point : light_points(light))
    for (const Fade& fade : fades_of(point, space.scale)) write_light(out, point, fade, space, shadowless);
  return out;
}

std::vector<std::string> pov_light_warnings(const Light& light) {
  if (light.kind == LightKind::directional || light.attenuation.kind != Attenuation::Kind::radius) return {};
  return {"light '" + light.name +
          "': POV-Ray has no attenuation by radius; a sum of fades stands for it, off by up to 0.5 of 255"};
}

}  // namespace lightbench
