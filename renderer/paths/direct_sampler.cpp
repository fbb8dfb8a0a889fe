#include "renderer/paths/direct_sampler.h"

#include <limits>

#include <glm/geometric.hpp>

namespace lightbench {
namespace {

// With more light points than the first number, only as many as the second are asked.
constexpr std::size_t kFewLights = 4;
constexpr int kAskedLights = 2;

void add_ray(ShadowQueue& queue, const PathLight& light, const Surfaces8& s, int lane, const Vec8& to_light,
             const glm::vec3& value, std::uint32_t slot) {
  const glm::vec3 way = to_light.lane(lane), position = s.position.lane(lane);
  const glm::vec3 origin = leave(position, s.offset.lane(lane), way);
  if (light.directional())
    queue.add({origin, way}, std::numeric_limits<float>::infinity(), value, slot);
  else
    queue.add({origin, way + (position - origin)}, kShadowEnd, value, slot);
}

}  // namespace

bool DirectSampler::picks() const {
  return scene_.lights.size() > kFewLights;
}

void DirectSampler::ask_all(ShadowQueue& queue, const Surfaces8& surfaces, Int8 mask, const Vec8& viewer,
                            const Vec8& share, UInt8 slots) const {
  for (const PathLight& light : scene_.lights) {
    const Arriving8 arriving = light.reflect(surfaces, viewer);
    const Vec8 value = arriving.reflected * share;
    for_lanes(mask & (largest(value) > 0),
              [&](int i) { add_ray(queue, light, surfaces, i, arriving.to_light, value.lane(i), slots[i]); });
  }
}

void DirectSampler::ask_some(ShadowQueue& queue, const Surfaces8& surfaces, Int8 mask, const Vec8& viewer,
                             const Vec8& share, UInt8 slots, Float8 random) {
  if (!picks()) return ask_all(queue, surfaces, mask, viewer, share, slots);
  Float8 total{};
  for (std::size_t light = 0; light < arriving_.size(); ++light) {
    arriving_[light] = scene_.lights[light].reflect(surfaces, viewer);
    arriving_[light].reflected = arriving_[light].reflected * share;
    total += largest(arriving_[light].reflected);
  }
  const Float8 step = total * (1.0f / kAskedLights);
  Float8 next = random * step, passed{};
  for (std::size_t light = 0; light < arriving_.size(); ++light) {
    const Float8 weight = largest(arriving_[light].reflected);
    passed += weight;
    for_lanes(mask & (weight > 0) & (next < passed), [&](int i) {
      int picked = 0;
      for (; next[i] < passed[i]; next[i] += step[i]) ++picked;
      const glm::vec3 value = arriving_[light].reflected.lane(i) * (float(picked) * step[i] / weight[i]);
      add_ray(queue, scene_.lights[light], surfaces, i, arriving_[light].to_light, value, slots[i]);
    });
  }
}

}  // namespace lightbench
