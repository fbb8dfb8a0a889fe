#include "renderer/paths/path_waves.h"

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

constexpr int kWave = 2048;      // paths; their state fits the second-level cache
constexpr int kTries = 16;       // of a ray, until it goes to what is known
constexpr int kDrawsOfTry = 32;  // more than there are bounces

bool is_black(const glm::vec3& v) {
  return !(v.x > 0 || v.y > 0 || v.z > 0);
}

/// Three bits in every third place.
Int8 spread_bits(Int8 n) {
  return (n & 1) | (n & 2) << 2 | (n & 4) << 4;
}

/// Eight by eight by eight cells of the cube around the sphere of directions, in Morton order.
Int8 direction_keys(const Vec8& d) {
  const auto cell = [](Float8 v) {
    return spread_bits(__builtin_convertvector(min8(4 * v + 4, splat(7)), Int8) & 7);
  };
  return cell(d.x) | cell(d.y) << 1 | cell(d.z) << 2;
}
constexpr int kDirectionKeys = 512;

}  // namespace

PathWaves::PathWaves(const PathScene& scene, int bounces, std::optional<Sight> sight, bool fill_unknown)
    : scene_(scene),
      bounces_(bounces),
      sight_(std::move(sight)),
      fill_unknown_(fill_unknown),
      vertices_(kWave),
      next_(kWave),
      flights_(kWave),
      keys_(kWave),
      order_(kWave),
      lights_(scene),
      shadows_(scene.embree.top(), indirect_) {}

glm::vec3 PathWaves::indirect(int slot, int half) const {
  const std::size_t place = 2 * std::size_t(slot) + std::size_t(half);
  const int samples = fill_unknown_ ? samples_ - unknown_[place] : samples_;
  return samples > 0 ? indirect_[place] / float(samples) : glm::vec3(0);
}

float PathWaves::unknown(int slot) const {
  const std::size_t place = 2 * std::size_t(slot);
  return samples_ > 0 ? float(unknown_[place] + unknown_[place + 1]) / float(2 * samples_) : 0;
}

void PathWaves::start(int slots) {
  indirect_.assign(2 * std::size_t(slots), glm::vec3(0));
  unknown_.assign(2 * std::size_t(slots), 0);
  samples_ = 0;
  points_.resize(std::size_t(slots) + kLanes);
  point_count_ = 0;
}

void PathWaves::add_points(const Surfaces8& surfaces, Int8 mask, UInt8 seeds, UInt8 slots) {
  const Vec8 throughput = surfaces.albedo * surfaces.reflectance;
  Vertices8{surfaces.position, surfaces.normal, surfaces.offset, throughput, seeds, {}, 2 * slots}.append_to(
      points_, point_count_, mask & (largest(throughput) > 0));
}

void PathWaves::add_samples(int first, int end) {
  if (bounces_ == 0) return;
  const std::int64_t paths = std::int64_t{point_count_} * 2 * (end - first);
  for (std::int64_t path = 0; path < paths; path += kWave) {
    const int count = int(std::min<std::int64_t>(kWave, paths - path));
    begin_wave(path, count, first, end - first);
    trace_wave(count);
  }
  shadows_.flush();
  samples_ = end;
}

/// Paths are numbered point by point, so that those of a wave start close together.
void PathWaves::begin_wave(std::int64_t first_path, int count, int first_sample, int samples) {
  const std::int64_t both_halves = std::int64_t{2} * samples;
  int point = int(first_path / both_halves), sample = int(first_path % both_halves);
  for (int i = 0; i < count; ++i, ++sample) {
    if (sample == both_halves) sample = 0, ++point;
    const int half = sample < samples ? 0 : 1;
    Row& row = vertices_[std::size_t(i)] = points_[std::size_t(point)];
    UInt8 high = as_numbers(row.high);
    high[kSeedField] = half_seed(high[kSeedField], half);
    high[kIndexField] = std::uint32_t(first_sample + sample - half * samples);
    high[kSlotField] += std::uint32_t(half);
    row.high = as_floats(high);
  }
}

void PathWaves::trace_wave(int count) {
  for (int bounce = 1; bounce <= bounces_ && count > 0; ++bounce) {
    int kept = 0;
    for (int attempt = 0; attempt < kTries && count > 0; ++attempt) {
      scatter(count, bounce + kDrawsOfTry * attempt);
      sort_flights(count);
      queue_rays(count);
      hits_.trace(scene_.embree.top(), diffuse_);
      kept = gather(bounce, kept);
      count = take_back_unknown();
    }
    std::swap(vertices_, next_);
    count = kept;
  }
}

/// Next-event estimation. Its weight is the balance heuristic's (Veach 1997, section 9.2): emission * density
/// of the cosine over the sum of both densities, the other half of which add_emission has. A ray that is
/// drawn anew has emitters asked anew: as often, on average, as one over the share of what is known.
void PathWaves::sample_emitters(const Vertices8& from, Int8 mask, int draws) {
  const SobolPair<UInt8> pick = draw(from.index, from.seed, draws, Draw::emitter_pick);
  const SobolPair<UInt8> place = draw(from.index, from.seed, draws, Draw::emitter_place);
  Vec8 position{}, normal{}, modelled_normal{}, emission{};
  for_lanes(mask, [&](int i) {
    const EmitterPoint point =
        scene_.emitters.sample(unit_float(pick.x[i]), unit_float(place.x[i]), unit_float(place.y[i]));
    position.set_lane(i, point.position);
    normal.set_lane(i, point.normal);
    modelled_normal.set_lane(i, point.modelled_normal);
    emission.set_lane(i, point.emission);
  });
  const Vec8 way = position - from.position;
  const Float8 square = dot(way, way), length = sqrt8(square);
  const Float8 cosine = dot(from.normal, way), cosine_there = abs8(dot(normal, way));  // times length
  const Float8 density = scene_.emitters.density(largest(emission)) * square * length / cosine_there;
  const Float8 density_of_cosine = cosine / (length * std::numbers::pi_v<float>);
  const Vec8 light = from.throughput * emission * (density_of_cosine / (density_of_cosine + density));
  const Vec8 origin = leave(from.position, from.offset, way);
  Int8 asked = mask & (cosine > 0) & (cosine_there > 0) & (largest(light) > 0);
  if (sight_) asked = sight_->holds(position, modelled_normal, asked, sight_tally_);
  shadows_.add(asked, {origin, position - origin}, splat(kShadowEnd), light, from.slot);
}

void PathWaves::scatter(int count, int draws) {
  for (int block = 0; kLanes * block < count; ++block) {
    const Vertices8 from = Vertices8::load(vertices_.data() + std::ptrdiff_t{kLanes} * block);
    if (!scene_.emitters.empty()) sample_emitters(from, first_lanes(count - kLanes * block), draws);
    const SobolPair<UInt8> point = draw(from.index, from.seed, draws, Draw::direction);
    const CosineDirection8 direction =
        cosine_direction(unit_float(point.x), unit_float(point.y), from.normal);
    Fields8 ray{}, rest{};
    set_fields(ray, 0, leave(from.position, from.offset, direction.unit));
    set_fields(ray, 3, direction.unit);
    set_fields(rest, 0, from.throughput);
    rest.v[3] = direction.density;
    rest.v[kSeedField] = as_floats(from.seed);
    rest.v[kIndexField] = as_floats(from.index);
    rest.v[kSlotField] = as_floats(from.slot);
    const Int8 keys = direction_keys(direction.unit);
    for (int i = 0; i < kLanes; ++i)
      keys_[std::size_t(kLanes) * std::size_t(block) + std::size_t(i)] = std::uint16_t(keys[i]);
    int first = kLanes * block;
    append(flights_, first, ray, rest, first_lanes(kLanes));
  }
}

/// By direction, so that packets are of nearly parallel rays; a counting sort.
void PathWaves::sort_flights(int count) {
  std::array<std::uint16_t, kDirectionKeys + 1> start{};
  for (int i = 0; i < count; ++i) ++start[keys_[std::size_t(i)] + 1u];
  for (std::size_t key = 1; key <= kDirectionKeys; ++key)
    start[key] = std::uint16_t(start[key] + start[key - 1]);
  for (int i = 0; i < count; ++i) order_[start[keys_[std::size_t(i)]]++] = std::uint16_t(i);
}

/// Lanes behind the last path repeat it.
void PathWaves::queue_rays(int count) {
  hits_.resize(count);
  for (int packet = 0; packet < hits_.packets(); ++packet) {
    const Fields8 ray = load_half<&Row::low>(flights_.data(), [&](int i) {
      return order_[std::size_t(std::min(kLanes * packet + i, count - 1))];
    });
    hits_.set(packet, {vec_of(ray, 0), vec_of(ray, 3)});
  }
}

PathWaves::Flights8 PathWaves::flights(int packet) const {
  const Fields8 rest = load_half<&Row::high>(flights_.data(), [&](int i) {
    return order_[std::size_t(std::min(kLanes * packet + i, hits_.size() - 1))];
  });
  return {vec_of(rest, 0), rest.v[3], as_numbers(rest.v[kSeedField]), as_numbers(rest.v[kIndexField]),
          as_numbers(rest.v[kSlotField])};
}

/// Which flights went to what the pictures hold.
Int8 PathWaves::known_lanes(const RTCRayHit8& rays, const Surfaces8& surfaces, Int8 valid, Int8 hit) {
  const Vec8 direction = load_vec8(rays.ray.dir_x, rays.ray.dir_y, rays.ray.dir_z);
  return (valid & ~hit & sight_->spans(direction)) |
         sight_->holds(surfaces.position, surfaces.modelled_normal, hit, sight_tally_);
}

/// The first rays are counted, so that their mean can leave the unknown ones out; later ones have no mean of
/// their own, and are drawn until one is known, which comes to the same.
void PathWaves::note_unknown(Int8 unknown, const Flights8& flights, int packet, int bounce) {
  for_lanes(unknown, [&](int i) {
    const int ray = kLanes * packet + i;
    if (bounce == 1)
      ++unknown_[flights.slot[i]];
    else if (fill_unknown_)
      astray_.push_back(order_[std::size_t(ray)]);
  });
}

/// Leaves as the wave's vertices those from which rays are to be drawn anew.
int PathWaves::take_back_unknown() {
  std::ranges::sort(astray_);  // so that none is overwritten before its turn
  for (std::size_t i = 0; i < astray_.size(); ++i) vertices_[i] = vertices_[astray_[i]];
  const int count = int(astray_.size());
  astray_.clear();
  return count;
}

/// Returns how many of the next vertices there are, with those before.
int PathWaves::gather(int bounce, int kept) {
  for (int packet = 0; packet < hits_.packets(); ++packet) {
    const RTCRayHit8& rays = hits_.packet(packet);
    const Int8 valid = first_lanes(hits_.size() - kLanes * packet);
    const Int8 hit = valid & hit_lanes(rays);
    const Flights8 paths = flights(packet);
    Surfaces8 s{};
    if (any(hit)) s = scene_.surfaces.shade(rays, hit);
    const Int8 known = sight_ ? known_lanes(rays, s, valid, hit) : valid;
    note_unknown(valid & ~known, paths, packet, bounce);
    if (!is_black(scene_.sky))
      for_lanes(known & ~hit,
                [&](int i) { indirect_[paths.slot[i]] += paths.throughput.lane(i) * scene_.sky; });
    const Int8 mask = known & hit;
    if (!any(mask)) continue;
    s.specular =
        Float8{};  // POV-Ray's radiosity sees no highlights (measured: a mirror of Phong's lights nothing)
    if (any(largest(s.emission) > 0)) add_emission(s, mask, paths, packet);
    const Vec8 viewer = -load_vec8(rays.ray.dir_x, rays.ray.dir_y, rays.ray.dir_z);
    const Float8 random =
        lights_.picks() ? unit_float(draw(paths.index, paths.seed, bounce, Draw::light_pick).x) : Float8{};
    lights_.ask_some(shadows_, s, mask, viewer, paths.throughput, paths.slot, random);
    if (bounce == bounces_) continue;
    const Vertices8 next{s.position, s.normal,    s.offset,  paths.throughput * s.albedo * s.reflectance,
                         paths.seed, paths.index, paths.slot};
    next.append_to(next_, kept, mask & (largest(next.throughput) > 0));
  }
  return kept;
}

/// The part of the balance heuristic that sample_emitters leaves.
void PathWaves::add_emission(const Surfaces8& surfaces, Int8 mask, const Flights8& flights, int packet) {
  const Float8 distance = load8(hits_.packet(packet).ray.tfar);
  const Float8 density =
      scene_.emitters.density(largest(surfaces.emission)) * distance * distance / surfaces.facing;
  const Vec8 light = flights.throughput * surfaces.emission * (flights.density / (flights.density + density));
  for_lanes(mask & (largest(surfaces.emission) > 0),
            [&](int i) { indirect_[flights.slot[i]] += light.lane(i); });
}

}  // namespace lightbench
