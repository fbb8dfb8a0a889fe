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

/// Sum of fades nearest to saturate(1 - d^2) in what an sRGB image shows of it, at all distances: found by
/// damped least squares over all numbers from many random starts, weighted anew towards the smallest
/// maximum. Pairs of opposite sign make ever steeper steps at the radius, where the curve has its
/// corner.
constexpr Fade kRadiusFades[] = {
    {0.338976334, 0.603727829, 2.56180934},  {-0.122016065, 0.957857016, 2.67496532},
    {0.30874744, 0.811326473, 6.41281381},   {-0.112683446, 1.02778482, 6.94687567},
    {0.217329688, 0.950602287, 18.1783203},  {-0.15081064, 0.993948861, 18.799315},
    {0.111508741, 0.989337664, 63.2610895},  {-0.0956394417, 0.996983777, 63.4485397},
    {-0.235855865, 0.999171502, 268.203499}, {0.238786554, 0.998950101, 268.240546},
    {0.144931211, 0.999982889, 1705.11276},  {-0.144723391, 0.999995541, 1705.7886},
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
                 const PovLightOptions& options) {
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
  if (options.shadowless) out.words(" shadowless");
  if (options.photons) out.words(" photons{refraction on reflection off}");
  out.words("}\n");
}

}  // namespace

double radius_attenuation_by_fades(double part) {
  double sum = 0;
  for (const Fade& fade : kRadiusFades)
    sum += fade.amplitude * 2 / (1 + std::pow(part / fade.distance, fade.power));
  return sum;
}

PovWriter pov_light(const Light& light, const PovSpace& space, const PovLightOptions& options) {
  PovWriter out;
  for (const Light& point : light_points(light))
    for (const Fade& fade : fades_of(point, space.scale)) write_light(out, point, fade, space, options);
  return out;
}

double radius_attenuation_error() {
  constexpr int kDecades = 4, kSteps = 5000;  // to each side of the radius; per decade
  double largest = 0;
  for (int i = -kDecades * kSteps; i <= kDecades * kSteps; ++i) {
    const double part = std::pow(10.0, double(i) / kSteps);
    const double wanted = std::max(1 - part * part, 0.0);
    largest = std::max(largest, std::abs(radius_attenuation_by_fades(part) - wanted));
  }
  return largest;
}

std::vector<std::string> pov_light_warnings(const Light& light) {
  if (light.kind == LightKind::directional || light.attenuation.kind != Attenuation::Kind::radius) return {};
  return {
      fmt::format("light '{}': POV-Ray has no attenuation by radius; a sum of fades stands for it, off by "
                  "up to {:.2f} % of the light at its place",
                  light.name, 100 * radius_attenuation_error())};
}

}  // namespace lightbench
