#pragma once

#include <vector>

#include "renderer/paths/path_scene.h"
#include "renderer/paths/ray_queues.h"

namespace lightbench {

/// Asks, in the lanes of the mask, whether anything hides the light that `to_light` leads to; what it brings
/// if not, `value`, goes to the slots.
void ask_shadow(ShadowQueue& queue, const Surfaces8& surfaces, Int8 mask, const Vec8& to_light,
                bool directional, const Vec8& value, UInt8 slots);

/// Shadow rays from surfaces to light points.
class DirectSampler {
 public:
  explicit DirectSampler(const PathScene& scene) : scene_(scene), arriving_(scene.lights.size()) {}

  /// A ray to every light for each lane of the mask; `share` of what is reflected goes to the slots.
  void ask_all(ShadowQueue& queue, const Surfaces8& surfaces, Int8 mask, const Vec8& viewer,
               const Vec8& share, UInt8 slots) const;
  /// The same where lights are few. Else only some rays, by a number 0..1 in each lane: lights are picked in
  /// proportion to what they would bring if unoccluded, at even steps along their list, and weighted by what
  /// the pick left out, so that the mean is that of all.
  void ask_some(ShadowQueue& queue, const Surfaces8& surfaces, Int8 mask, const Vec8& viewer,
                const Vec8& share, UInt8 slots, Float8 random);
  bool picks() const;

 private:
  const PathScene& scene_;
  std::vector<Arriving8> arriving_;  ///< by light, for ask_some
};

/// Where rays in these directions start: on the side of the surface towards which they go.
inline Vec8 leave(const Vec8& position, const Vec8& offset, const Vec8& direction) {
  return select(dot(offset, direction) >= 0, position + offset, position - offset);
}

/// Where shadow rays end before a light or an emitter, as a share of the way.
inline constexpr float kShadowEnd = 1 - 1e-4f;

}  // namespace lightbench
