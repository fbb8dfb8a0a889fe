#include "povexport/pov_lights.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <glm/trigonometric.hpp>

#include "base/error.h"

namespace lightbench {
namespace {

/// Where 2 / (1 + (d / D)^2) is to be 1 / d^2: D = kTiny makes it 2 D^2 / d^2 but for a part of D^2 / d^2.
constexpr double kTinyFadeDistance = 1e-4;

struct Fade {
  double amplitude = 1;
  double distance = 0;  ///< 0: none
  double power = 2;
};

Fade fade_of(const Attenuation& attenuation) {
  switch (attenuation.kind) {
    case Attenuation::Kind::none:
      return {};
    case Attenuation::Kind::fade:
      return {1, attenuation.distance, attenuation.power};
    case Attenuation::Kind::inverse_square:
      return {0.5 / (kTinyFadeDistance * kTinyFadeDistance), kTinyFadeDistance, 2};
    case Attenuation::Kind::radius: {
      const FadeFit fit = fit_radius_attenuation(attenuation.radius);
      return {fit.amplitude, fit.distance, fit.power};
    }
  }
  return {};
}

/// The best amplitude for a distance and a power (linear least squares), and the mean square error with it.
std::pair<double, double> best_amplitude(double distance, double power) {
  constexpr int kSamples = 128;
  double ff = 0, fg = 0, gg = 0;
  for (int i = 0; i < kSamples; ++i) {
    const double d = 2 * (i + 0.5) / kSamples;
    const double wanted = std::pow(std::max(1 - d, 0.0), 2);
    const double fade = 2 / (1 + std::pow(d / distance, power));
    ff += fade * fade;
    fg += fade * wanted;
    gg += wanted * wanted;
  }
  const double amplitude = fg / ff;
  return {amplitude, gg - amplitude * fg};
}

}  // namespace

FadeFit fit_radius_attenuation(double radius) {
  FadeFit best{};
  double least = std::numeric_limits<double>::max();
  for (int i = 5; i <= 60; ++i)
    for (int j = 10; j <= 60; ++j) {
      const double distance = i / 60.0, power = j / 10.0;
      const auto [amplitude, error] = best_amplitude(distance, power);
      if (error >= least) continue;
      least = error;
      best = {amplitude, distance, power, 0};
    }
  for (int i = 0; i <= 200; ++i) {
    const double d = i / 100.0;
    const double fade = best.amplitude * 2 / (1 + std::pow(d / best.distance, best.power));
    best.worst = std::max(best.worst, std::abs(fade - std::pow(std::max(1 - d, 0.0), 2)));
  }
  best.distance *= radius;
  return best;
}

PovWriter pov_light(const Light& light, const PovSpace& space, bool shadowless) {
  if (light.kind == LightKind::area) throw Error("area lights cannot be exported to POV-Ray yet", light.name);
  PovWriter out;
  const bool directional = light.kind == LightKind::directional;
  const Fade fade = directional ? Fade{} : fade_of(light.attenuation);
  const glm::dvec3 color = glm::dvec3(light.color) * double(light.power) * fade.amplitude;
  // A parallel light shines from its place on: outside of the scene, yet near enough for exact coordinates.
  const glm::dvec3 center(space.bounds.center());
  const glm::dvec3 far_away = center - glm::dvec3(light.direction) * (2.0 * space.bounds.diagonal());
  out.words("light_source{").vector(space.scale * (directional ? far_away : glm::dvec3(light.position)));
  out.words(" rgb").vector(color);
  if (directional) out.words(" parallel point_at").vector(space.scale * center);
  if (light.kind == LightKind::spot) {
    out.words(" spotlight radius ").number(glm::degrees(double(light.inner_angle)));
    out.words(" falloff ").number(glm::degrees(double(light.outer_angle))).words(" tightness 0");
    const glm::dvec3 aim = glm::dvec3(light.position) + glm::dvec3(light.direction);
    out.words(" point_at").vector(space.scale * aim);
  }
  if (fade.distance > 0)
    out.words(" fade_distance ").number(space.scale * fade.distance).words(" fade_power ").number(fade.power);
  if (shadowless) out.words(" shadowless");
  out.words("}\n");
  return out;
}

std::vector<std::string> pov_light_warnings(const Light& light) {
  if (light.kind == LightKind::directional || light.attenuation.kind != Attenuation::Kind::radius) return {};
  const FadeFit fit = fit_radius_attenuation(light.attenuation.radius);
  return {fmt::format(
      "light '{}': POV-Ray has no attenuation by radius; the nearest fade stands for it and is off by "
      "up to {:.0f} % of the light's strength",
      light.name, 100 * fit.worst)};
}

}  // namespace lightbench
