#pragma once

#include "renderer/path_tracer.h"
#include "renderer/paths/path_scene.h"
#include "renderer/paths/ray_queues.h"

namespace lightbench {

/// What the pictures hold that SightLimits tell of, found by rays from the camera's place. The rule is that
/// of renderer/surround.h: along a ray the first surface is kept, and behind it, up to `layers`, those at
/// least kBehindShare farther off; with `front_faces` only those whose shading normal, as modelled, faces the
/// camera. Keeps references to its arguments but the limits.
class Sight {
 public:
  Sight(const PathScene& scene, const PathCamera& camera, const SightLimits& limits)
      : scene_(scene), camera_(camera), limits_(limits) {}

  /// Which points of surfaces, in the lanes of the mask, are held. `normals` are of shading, as modelled, of
  /// any length.
  Int8 holds(const Vec8& points, const Vec8& normals, Int8 mask, RayTally& tally) const;
  /// Which directions, of any length, lie in the pictures: whether a background infinitely far is held.
  Int8 spans(const Vec8& directions) const;

 private:
  const PathScene& scene_;
  const PathCamera& camera_;
  SightLimits limits_;
};

/// By how much, as a share, a surface has to lie behind another one to be a layer of its own: kBehind of
/// shaders/surface.frag.glsl.
inline constexpr float kBehindShare = 1e-3f;

}  // namespace lightbench
