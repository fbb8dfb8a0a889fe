#include "renderer/paths/sight.h"

namespace lightbench {
namespace {

// From a surface that is not kept the walk goes on just behind it: a share of its distance, and more than
// nothing.
constexpr float kNextShare = 1e-5f;
constexpr float kNextAtLeast = 1e-9f;

/// As modelled, at the hits in the lanes of the mask.
Vec8 normals_at(const SurfaceTable& surfaces, const RTCRayHit8& rays, Int8 mask) {
  Vec8 result{};
  for_lanes(mask, [&](int i) {
    result.set_lane(i, surfaces.normal(rays.hit.instID[0][i], rays.hit.geomID[i], rays.hit.primID[i],
                                       rays.hit.u[i], rays.hit.v[i]));
  });
  return result;
}

}  // namespace

Int8 Sight::spans(const Vec8& directions) const {
  if (limits_.all_around) return Int8{} == 0;
  const CameraFrame& frame = camera_.frame();
  const Float8 forward = dot(directions, splat(frame.forward));
  const Float8 right = abs8(dot(directions, splat(frame.right)));
  const Float8 up = abs8(dot(directions, splat(frame.up)));
  const glm::vec2 half = limits_.wide_factor * camera_.tan_half();
  return (forward > 0) & (right < half.x * forward) & (up < half.y * forward);
}

/// Walks along the ways to the points, measured in shares of them, and counts what is kept before.
Int8 Sight::holds(const Vec8& points, const Vec8& normals, Int8 mask, RayTally& tally) const {
  const Rays8 ways{splat(camera_.position()), points - splat(camera_.position())};
  const auto may_be_kept = [&](const Vec8& n) {
    return limits_.front_faces ? dot(n, ways.direction) <= 0 : Int8{} == 0;
  };
  const Int8 spanned = mask & spans(ways.direction);
  Int8 kept{};
  Float8 near{};
  for (Int8 walking = spanned; any(walking);) {
    const RTCRayHit8 rays =
        closest_hits(scene_.embree.top(), ways, near, splat(1 - kBehindShare), walking, tally);
    walking &= hit_lanes(rays);
    Int8 keeps = walking & (kept == 0);
    if (any(walking & ~keeps)) keeps |= walking & may_be_kept(normals_at(scene_.surfaces, rays, walking));
    kept -= keeps;  // a lane of a mask is -1
    walking &= kept < limits_.layers;
    near = load8(rays.ray.tfar) * (1 + select(keeps, splat(kBehindShare), splat(kNextShare))) + kNextAtLeast;
  }
  return spanned & (kept < limits_.layers) & ((kept == 0) | may_be_kept(normals));
}

}  // namespace lightbench
