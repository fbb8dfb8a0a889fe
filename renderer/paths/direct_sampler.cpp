#include "renderer/paths/direct_sampler.h"

#include <limits>

#include <glm/geometric.hpp>

namespace lightbench {
namespace {

// With more light points than the first number, only as many as the second are asked.
constexpr std::size_t kFewLights = 4;
constexpr int kAskedLights = 2;

void add_rays(ShadowQueue& queue, const PathLight& light, const Surfaces8& s, Int8 mask, const Vec8& to_light,
              const Vec8& value, UInt8 slots) {
  if (!any(mask)) return;
  const Vec8 origin = leave(s.position, s.offset, to_light);
  if (light.directional())
    queue.add(mask, {origin, to_light}, splat(std::numeric_limits<float>::infinity()), value, slots);
  else
    queue.add(mask, {origin, to_light + (s.position - origin)}, splat(kShadowEnd), value, slots);
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
    add_rays(queue, light, surfaces, mask & (largest(value) > 0), arriving.to_light, value, slots);
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
    add_rays(queue, scene_.lights[light], surfaces, picked, arriving_[light].to_light, value, slots);
  }
}

}  // namespace lightbench
