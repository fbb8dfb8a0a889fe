#include "renderer/paths/direct_sampler.h"

#include <limits>

#include <glm/geometric.hpp>

namespace lightbench {
namespace {

// With more light points than the first number, only as many as the second are asked.
constexpr std::size_t kFewLights = 4;
constexpr int kAskedLights = 2;

}  // namespace

void ask_shadow(ShadowQueue& queue, const Surfaces8& s, Int8 mask, const Vec8& to_light, bool directional,
                const Vec8& value, UInt8 slots) {
  if (!any(mask)) return;
  const Vec8 origin = leave(s.position, s.offset, to_light);
  if (directional)
    queue.add(mask, {origin, to_light}, splat(std::numeric_limits<float>::infinity()), value, slots);
  else
    queue.add(mask, {origin, to_light + (s.position - origin)}, splat(kShadowEnd), value, slots);
}

bool DirectSampler::picks() const {
  return scene_.lights.size() > kFewLights;
}

void DirectSampler::ask_all(ShadowQueue& queue, const Surfaces8& surfaces, Int8 mask, const Vec8& viewer,
                            const Vec8& share, UInt8 slots) const {
  for (const PathLight& light : scene_.lights) {
    const Arriving8 arriving = light.reflect(surfaces, viewer);
    const Vec8 value = arriving.reflected * share;
    ask_shadow(queue, surfaces, mask & (largest(value) > 0), arriving.to_light, light.directional(), value,
               slots);
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
    const Int8 picked = mask & (weight > 0) & (next < passed);
    Float8 times{};
    for (Int8 more = picked; any(more); more = picked & (next < passed)) {
      times += select(more, splat(1), splat(0));
      next += select(more, step, splat(0));
    }
    const Vec8 value = arriving_[light].reflected * (times * step / weight);
    ask_shadow(queue, surfaces, picked, arriving_[light].to_light, scene_.lights[light].directional(), value,
               slots);
  }
}

}  // namespace lightbench
