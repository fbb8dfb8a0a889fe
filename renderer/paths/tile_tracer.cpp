#include "renderer/paths/tile_tracer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include <glm/geometric.hpp>

#include "renderer/paths/cosine_direction.h"
#include "renderer/paths/path_draw.h"

namespace lightbench {
namespace {

constexpr int kWave = 2048;  // paths; their state fits the second-level cache

bool is_black(const glm::vec3& v) {
  return !(v.x > 0 || v.y > 0 || v.z > 0);
}

/// Eight by eight by eight cells of the cube around the sphere of directions, in Morton order.
std::uint16_t direction_key(const glm::vec3& d) {
  constexpr std::array<std::uint16_t, 8> spread{0, 1, 8, 9, 64, 65, 72, 73};
  const auto cell = [&](float v) { return spread[std::size_t(std::clamp(int(4 * v + 4), 0, 7))]; };
  return std::uint16_t(cell(d.x) | cell(d.y) << 1 | cell(d.z) << 2);
}
constexpr int kDirectionKeys = 512;

}  // namespace

void TileTracer::Vertices8::copy_lane(int lane, const Vertices8& from, int from_lane) {
  position.set_lane(lane, from.position.lane(from_lane));
  normal.set_lane(lane, from.normal.lane(from_lane));
  offset.set_lane(lane, from.offset.lane(from_lane));
  throughput.set_lane(lane, from.throughput.lane(from_lane));
  seed[lane] = from.seed[from_lane];
  index[lane] = from.index[from_lane];
  slot[lane] = from.slot[from_lane];
}

TileTracer::TileTracer(const PathScene& scene, const PathCamera& camera, int bounces, std::uint64_t seed)
    : scene_(scene),
      camera_(camera),
      bounces_(bounces),
      seed_(picture_seed(seed)),
      vertices_(kWave / kLanes),
      flights_(kWave),
      keys_(kWave),
      order_(kWave),
      lights_(scene),
      direct_shadows_(scene.embree.top(), direct_),
      indirect_shadows_(scene.embree.top(), indirect_) {}

RayTallies TileTracer::tallies() const {
  RayTally shadow = direct_shadows_.tally();
  shadow += indirect_shadows_.tally();
  return {primary_, shadow, diffuse_};
}

void TileTracer::start(const RayTile& tile) {
  tile_ = tile;
  const int rays = tile.width * tile.height;
  covered_.assign(std::size_t(rays), 0);
  direct_.assign(std::size_t(rays), glm::vec3(0));
  indirect_.assign(std::size_t(2 * rays), glm::vec3(0));
  points_.resize(std::size_t((rays + kLanes - 1) / kLanes));
  point_count_ = 0;
  hits_.resize(rays);
  for (int i = 0; i < rays; ++i)
    hits_.set(i, {camera_.position(), camera_.direction(tile.x + i % tile.width, tile.y + i / tile.width)});
  hits_.trace(scene_.embree.top(), primary_);
  for (int i = 0; i < hits_.packets(); ++i) shade_primary(i);
  direct_shadows_.flush();
}

void TileTracer::shade_primary(int packet) {
  const RTCRayHit8& rays = hits_.packet(packet);
  const Int8 mask = first_lanes(hits_.size() - kLanes * packet) & hit_lanes(rays);
  if (!any(mask)) return;
  const Surfaces8 s = scene_.surfaces.shade(rays, mask);
  const Vec8 viewer = -load_vec8(rays.ray.dir_x, rays.ray.dir_y, rays.ray.dir_z);
  const UInt8 numbers = lane_numbers() + std::uint32_t(kLanes * packet);
  lights_.ask_all(direct_shadows_, s, mask, viewer, splat(glm::vec3(1)), numbers);
  Vertices8 vertices{s.position, s.normal, s.offset, s.albedo * s.reflectance, {}, {}, {}};
  for_lanes(mask, [&](int i) {
    const int ray = kLanes * packet + i;
    covered_[std::size_t(ray)] = 1;
    direct_[std::size_t(ray)] = s.emission.lane(i);
    if (is_black(vertices.throughput.lane(i))) return;
    vertices.seed[i] = primary_seed(seed_, tile_.x + ray % tile_.width, tile_.y + ray / tile_.width);
    vertices.slot[i] = std::uint32_t(2 * ray);
    points_[std::size_t(point_count_ / kLanes)].copy_lane(point_count_ % kLanes, vertices, i);
    ++point_count_;
  });
}

void TileTracer::add_samples(int first, int end) {
  if (bounces_ == 0) return;
  const std::int64_t paths = std::int64_t{point_count_} * 2 * (end - first);
  for (std::int64_t path = 0; path < paths; path += kWave) {
    const int count = int(std::min<std::int64_t>(kWave, paths - path));
    begin_wave(path, count, first, end - first);
    trace_wave(count);
  }
  indirect_shadows_.flush();
}

/// Paths are numbered point by point, so that those of a wave start close together.
void TileTracer::begin_wave(std::int64_t first_path, int count, int first_sample, int samples) {
  for (int i = 0; i < count; ++i) {
    const std::int64_t path = first_path + i;
    const int point = int(path / (2 * samples)), sample = int(path % (2 * samples));
    const int half = sample / samples;
    Vertices8& v = vertices_[std::size_t(i / kLanes)];
    const int lane = i % kLanes;
    v.copy_lane(lane, points_[std::size_t(point / kLanes)], point % kLanes);
    v.seed[lane] = half_seed(v.seed[lane], half);
    v.index[lane] = std::uint32_t(first_sample + sample % samples);
    v.slot[lane] += std::uint32_t(half);
  }
}

void TileTracer::trace_wave(int count) {
  for (int bounce = 1; bounce <= bounces_ && count > 0; ++bounce) {
    scatter(count, bounce);
    sort_flights(count);
    hits_.resize(count);
    for (int i = 0; i < count; ++i) hits_.set(i, flights_[order_[std::size_t(i)]].ray);
    hits_.trace(scene_.embree.top(), diffuse_);
    count = gather(bounce);
  }
}

/// Next-event estimation. Its weight is the balance heuristic's (Veach 1997, section 9.2): emission * density
/// of the cosine over the sum of both densities, the other half of which add_emission has.
void TileTracer::sample_emitters(const Vertices8& from, Int8 mask, int bounce) {
  const SobolPair<UInt8> pick = draw(from.index, from.seed, bounce, Draw::emitter_pick);
  const SobolPair<UInt8> place = draw(from.index, from.seed, bounce, Draw::emitter_place);
  for_lanes(mask, [&](int i) {
    const EmitterPoint point =
        scene_.emitters.sample(unit_float(pick.x[i]), unit_float(place.x[i]), unit_float(place.y[i]));
    const glm::vec3 position = from.position.lane(i);
    const glm::vec3 way = point.position - position;
    const float square = glm::dot(way, way);
    const float cosine = glm::dot(from.normal.lane(i), way),
                cosine_there = std::abs(glm::dot(point.normal, way));
    if (!(cosine > 0 && cosine_there > 0)) return;
    const float length = std::sqrt(square);
    const float density = scene_.emitters.density(point.emission) * square * length / cosine_there;
    const float density_of_cosine = cosine / (length * std::numbers::pi_v<float>);
    const glm::vec3 light =
        from.throughput.lane(i) * point.emission * (density_of_cosine / (density_of_cosine + density));
    if (is_black(light)) return;
    const glm::vec3 origin = leave(position, from.offset.lane(i), way);
    indirect_shadows_.add({origin, point.position - origin}, kShadowEnd, light, from.slot[i]);
  });
}

void TileTracer::scatter(int count, int bounce) {
  for (int block = 0; kLanes * block < count; ++block) {
    const Vertices8& from = vertices_[std::size_t(block)];
    const Int8 mask = first_lanes(count - kLanes * block);
    if (!scene_.emitters.empty()) sample_emitters(from, mask, bounce);
    const SobolPair<UInt8> point = draw(from.index, from.seed, bounce, Draw::direction);
    const CosineDirection8 direction =
        cosine_direction(unit_float(point.x), unit_float(point.y), from.normal);
    const Vec8 origin = select(dot(from.offset, direction.unit) >= 0, from.position + from.offset,
                               from.position - from.offset);
    for_lanes(mask, [&](int i) {
      const auto path = std::size_t(kLanes * block + i);
      flights_[path] = {{origin.lane(i), direction.unit.lane(i)},
                        from.throughput.lane(i),
                        direction.density[i],
                        from.seed[i],
                        from.index[i],
                        from.slot[i]};
      keys_[path] = direction_key(flights_[path].ray.direction);
    });
  }
}

/// By direction, so that packets are of nearly parallel rays; a counting sort.
void TileTracer::sort_flights(int count) {
  std::array<std::uint16_t, kDirectionKeys + 1> start{};
  for (int i = 0; i < count; ++i) ++start[keys_[std::size_t(i)] + 1u];
  for (std::size_t key = 1; key <= kDirectionKeys; ++key)
    start[key] = std::uint16_t(start[key] + start[key - 1]);
  for (int i = 0; i < count; ++i) order_[start[keys_[std::size_t(i)]]++] = std::uint16_t(i);
}

int TileTracer::gather(int bounce) {
  int kept = 0;
  for (int packet = 0; packet < hits_.packets(); ++packet) {
    const RTCRayHit8& rays = hits_.packet(packet);
    const Int8 valid = first_lanes(hits_.size() - kLanes * packet);
    const Int8 mask = valid & hit_lanes(rays);
    Vertices8 paths{};
    for_lanes(valid, [&](int i) {
      const Flight& flight = flights_[order_[std::size_t(kLanes * packet + i)]];
      paths.throughput.set_lane(i, flight.throughput);
      paths.seed[i] = flight.seed;
      paths.index[i] = flight.index;
      paths.slot[i] = flight.slot;
    });
    if (!is_black(scene_.sky))
      for_lanes(valid & ~mask,
                [&](int i) { indirect_[paths.slot[i]] += paths.throughput.lane(i) * scene_.sky; });
    if (!any(mask)) continue;
    Surfaces8 s = scene_.surfaces.shade(rays, mask);
    s.specular =
        Float8{};  // POV-Ray's radiosity sees no highlights (measured: a mirror of Phong's lights nothing)
    add_emission(s, mask, packet);
    const Vec8 viewer = -load_vec8(rays.ray.dir_x, rays.ray.dir_y, rays.ray.dir_z);
    const Float8 random =
        lights_.picks() ? unit_float(draw(paths.index, paths.seed, bounce, Draw::light_pick).x) : Float8{};
    lights_.ask_some(indirect_shadows_, s, mask, viewer, paths.throughput, paths.slot, random);
    if (bounce == bounces_) continue;
    paths.position = s.position;
    paths.normal = s.normal;
    paths.offset = s.offset;
    paths.throughput = paths.throughput * s.albedo * s.reflectance;
    for_lanes(mask & (largest(paths.throughput) > 0), [&](int i) {
      vertices_[std::size_t(kept / kLanes)].copy_lane(kept % kLanes, paths, i);
      ++kept;
    });
  }
  return kept;
}

/// The part of the balance heuristic that sample_emitters leaves.
void TileTracer::add_emission(const Surfaces8& surfaces, Int8 mask, int packet) {
  const RTCRayHit8& rays = hits_.packet(packet);
  for_lanes(mask & (largest(surfaces.emission) > 0), [&](int i) {
    const Flight& flight = flights_[order_[std::size_t(kLanes * packet + i)]];
    const glm::vec3 emission = surfaces.emission.lane(i);
    const float distance = rays.ray.tfar[i];
    const float density = scene_.emitters.density(emission) * distance * distance / surfaces.facing[i];
    indirect_[flight.slot] += flight.throughput * emission * (flight.density / (flight.density + density));
  });
}

}  // namespace lightbench
