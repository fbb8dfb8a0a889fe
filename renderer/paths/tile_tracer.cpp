#include "renderer/paths/tile_tracer.h"

#include <algorithm>

#include "renderer/paths/path_draw.h"

namespace lightbench {
namespace {

std::optional<Sight> sight_of(const PathScene& scene, const PathCamera& camera,
                              const std::optional<SightLimits>& limits) {
  return limits ? std::optional<Sight>(std::in_place, scene, camera, *limits) : std::nullopt;
}

}  // namespace

TileTracer::TileTracer(const PathScene& scene, const PathCamera& camera, int bounces, std::uint64_t seed,
                       const std::optional<SightLimits>& limits)
    : scene_(scene),
      camera_(camera),
      seed_(picture_seed(seed)),
      lights_(scene),
      shadows_(scene.embree.top(), direct_),
      waves_(scene, bounces, sight_of(scene, camera, limits), limits && limits->fill_unknown) {}

RayTallies TileTracer::tallies() const {
  RayTally shadow = shadows_.tally();
  shadow += waves_.shadow_rays();
  return {primary_, shadow, waves_.diffuse_rays(), waves_.sight_rays()};
}

void TileTracer::start(const RayTile& tile) {
  tile_ = tile;
  const int rays = tile.width * tile.height;
  covered_.assign(std::size_t(rays), 0);
  direct_.assign(std::size_t(rays), glm::vec3(0));
  waves_.start(rays);
  hits_.resize(rays);
  for (int packet = 0; packet < hits_.packets(); ++packet) {
    Rays8 packed{splat(camera_.position()), {}};
    for (int i = 0; i < kLanes; ++i) {
      const int ray = std::min(kLanes * packet + i, rays - 1);
      packed.direction.set_lane(i, camera_.direction(tile.x + ray % tile.width, tile.y + ray / tile.width));
    }
    hits_.set(packet, packed);
  }
  hits_.trace(scene_.embree.top(), primary_);
  for (int i = 0; i < hits_.packets(); ++i) shade_primary(i);
  shadows_.flush();
}

void TileTracer::shade_primary(int packet) {
  const RTCRayHit8& rays = hits_.packet(packet);
  const Int8 mask = first_lanes(hits_.size() - kLanes * packet) & hit_lanes(rays);
  if (!any(mask)) return;
  const Surfaces8 s = scene_.surfaces.shade(rays, mask);
  const Vec8 viewer = -load_vec8(rays.ray.dir_x, rays.ray.dir_y, rays.ray.dir_z);
  const UInt8 numbers = lane_numbers() + std::uint32_t(kLanes * packet);
  UInt8 seeds{};
  for_lanes(mask, [&](int i) {
    const int ray = kLanes * packet + i;
    covered_[std::size_t(ray)] = 1;
    direct_[std::size_t(ray)] = s.emission.lane(i);
    seeds[i] = primary_seed(seed_, tile_.x + ray % tile_.width, tile_.y + ray / tile_.width);
  });
  // Once what they add to has its first value, since the queue may be full in the midst of them.
  lights_.ask_all(shadows_, s, mask, viewer, splat(glm::vec3(1)), numbers);
  waves_.add_points(s, mask, seeds, numbers);
}

}  // namespace lightbench
