#include "renderer/radiance/bake_lights.h"

#include "renderer/paths/sobol.h"
#include "scene/light_points.h"

namespace lightbench {
namespace {

constexpr std::uint32_t kLightDraws = 0x6c696768;  // apart from what else a texel draws

Light one_of(const Light& area, int samples) {
  Light point = area;
  point.kind = LightKind::point;
  point.power /= float(samples);
  return point;
}

bool sends_light(const Light& light) {
  return light.power != 0 && light.color != glm::vec3(0);
}

}  // namespace

BakeLight::BakeLight(const Light& area, int light, int sample, int samples)
    : light_(one_of(area, samples)),
      area_(&area),
      number_(std::uint32_t(light)),
      sample_(std::uint32_t(sample)) {}

/// A quad's points are even over its parallelogram; a triangle's are those of the parallelogram with the far
/// half folded over.
Vec8 BakeLight::position(UInt8 seeds) const {
  const SobolPair<UInt8> pair = sobol_pair(UInt8{} + sample_, hash_pair(seeds, kLightDraws + number_));
  Float8 u = unit_float(pair.x), v = unit_float(pair.y);
  if (area_->shape == AreaShape::quad) {
    u -= 0.5f, v -= 0.5f;
  } else {
    const Int8 far = u + v > 1;
    u = select(far, 1 - u, u), v = select(far, 1 - v, v);
  }
  return splat(area_->position) + splat(area_->edge_u) * u + splat(area_->edge_v) * v;
}

Incident8 BakeLight::incident(const Surfaces8& surfaces, UInt8 seeds) const {
  return area_ ? light_.incident(surfaces, position(seeds)) : light_.incident(surfaces);
}

std::vector<BakeLight> bake_lights(const Scene& scene, int samples) {
  std::vector<BakeLight> result;
  for (std::size_t i = 0; i < scene.lights.size(); ++i) {
    const Light& light = scene.lights[i];
    if (!sends_light(light)) continue;
    if (light.kind == LightKind::area && samples > 0)
      for (int sample = 0; sample < samples; ++sample) result.emplace_back(light, int(i), sample, samples);
    else
      for (const Light& point : light_points(light)) result.emplace_back(point);
  }
  return result;
}

}  // namespace lightbench
