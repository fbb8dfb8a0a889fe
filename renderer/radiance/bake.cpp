#include "renderer/radiance/bake.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cassert>
#include <cmath>
#include <cstring>
#include <future>
#include <mutex>

#include <glm/gtc/packing.hpp>

#include "base/image.h"
#include "renderer/paths/direct_sampler.h"
#include "renderer/paths/half_error.h"
#include "renderer/paths/path_draw.h"
#include "renderer/paths/path_waves.h"
#include "renderer/paths/power.h"
#include "renderer/radiance/bake_lights.h"

namespace lightbench {
namespace {

constexpr int kBlock = 64;  // texels whose rays are traced together
constexpr float kFaintest =
    1e-5f;  // highlights below are left out: a fiftieth of the smallest step of 8 bits

using HalfTexel = std::array<std::uint16_t, 3>;
using Halves8 = std::array<std::uint16_t, kLanes>;

Halves8 halves(Float8 v) {
  Halves8 result;
  const Float8 kept = min8(v, splat(kLargestHalf));
#ifdef __F16C__
  const __m128i bits = _mm256_cvtps_ph(kept, _MM_FROUND_TO_NEAREST_INT);
  std::memcpy(result.data(), &bits, sizeof bits);
#else
  for (int i = 0; i < kLanes; ++i) result[std::size_t(i)] = glm::packHalf1x16(kept[i]);
#endif
  return result;
}

/// Eight colours as halves, side by side.
void store_halves(HalfTexel* to, const Vec8& color) {
  const Halves8 x = halves(color.x), y = halves(color.y), z = halves(color.z);
  for (std::size_t i = 0; i < kLanes; ++i) to[i] = {x[i], y[i], z[i]};
}

/// What a light point does at a texel where it is not hidden.
struct Arrival {
  glm::vec3 mirrored;  ///< the light's mirror direction in the texel's local frame
  float n_dot_l;
};

/// All directions of the grid in the local frame, eight by eight; the last ones may repeat.
std::vector<Vec8> packed_directions(const DirectionGrid& grid) {
  std::vector<Vec8> packed(std::size_t((grid.layers() + kLanes - 1) / kLanes));
  for (int i = 0; i < int(packed.size()) * kLanes; ++i) {
    const glm::ivec2 place = grid.place(std::min(i, grid.layers() - 1));
    packed[std::size_t(i / kLanes)].set_lane(i % kLanes, grid.direction(place.x, place.y));
  }
  return packed;
}

/// What all texels share.
struct BakeSetting {
  const ObjectSurface& surface;
  const std::vector<BakeLight>& lights;
  const std::vector<Vec8>& directions;
  std::span<const BakeTexel> texels;
  const BakeOptions& options;
  std::uint32_t seed;
};

/// Bakes one block of texels after another; one for each thread.
class BlockBaker {
 public:
  BlockBaker(const PathScene& scene, const BakeSetting& setting, HalfStack& stack)
      : setting_(setting),
        stack_(stack),
        surfaces_(kBlock / kLanes),
        arrivals_(kBlock * setting.lights.size()),
        arriving_(arrivals_.size()),
        shadows_(scene.embree.top(), arriving_),
        waves_(scene, setting.options.bounces),
        baked_(kBlock * setting.directions.size() * kLanes) {}

  void bake(std::size_t first, int count);

  double error_sum() const { return error_sum_; }
  bool lit() const { return lit_; }
  const RayTally& shadow_rays() const { return shadows_.tally(); }
  RayTally path_shadow_rays() const { return waves_.shadow_rays(); }
  const RayTally& diffuse_rays() const { return waves_.diffuse_rays(); }

 private:
  const BakeTexel& texel(int i) const { return setting_.texels[first_ + std::size_t(i)]; }
  UInt8 seeds(int packet) const;
  Surfaces8 surfaces(int packet) const;
  void ask_lights(int packet, const Surfaces8& s, UInt8 seeds);
  void shade(int i);
  glm::vec3 matte(int i, const Surfaces8& s, int lane);
  void add_highlights(int i, float specular, float exponent);
  bool is_dark() const;
  void keep() const;

  const BakeSetting& setting_;
  HalfStack& stack_;
  std::size_t first_ = 0;
  int count_ = 0;
  std::vector<Surfaces8> surfaces_;
  std::vector<Arrival> arrivals_;    ///< by texel of the block, then light
  std::vector<glm::vec3> arriving_;  ///< likewise: the radiance of what is not hidden
  ShadowQueue shadows_;
  PathWaves waves_;
  std::vector<Vec8> sums_;        ///< of one texel, by packet of directions
  std::vector<HalfTexel> baked_;  ///< by texel of the block, then direction
  double error_sum_ = 0;
  bool lit_ = false;
};

UInt8 BlockBaker::seeds(int packet) const {
  UInt8 seeds{};
  for (int lane = 0; lane < kLanes; ++lane)
    seeds[lane] = hash_pair(setting_.seed, texel(std::min(kLanes * packet + lane, count_ - 1)).number);
  return seeds;
}

/// The sides of a packet's texels may differ; those of the front are looked at first.
Surfaces8 BlockBaker::surfaces(int packet) const {
  std::array<MeshPoint, kLanes> points;
  Int8 back{};
  for (int lane = 0; lane < kLanes; ++lane) {
    const BakeTexel& t = texel(std::min(kLanes * packet + lane, count_ - 1));
    points[std::size_t(lane)] = t.point;
    back[lane] = t.side == Side::back ? -1 : 0;
  }
  Surfaces8 result = setting_.surface.at(points, Side::front);
  if (!any(back)) return result;
  const Surfaces8 behind = setting_.surface.at(points, Side::back);
  result.normal = select(back, behind.normal, result.normal);
  result.offset = select(back, behind.offset, result.offset);
  result.position = select(back, behind.position, result.position);
  return result;
}

void BlockBaker::ask_lights(int packet, const Surfaces8& s, UInt8 seeds) {
  const Int8 mask = first_lanes(count_ - kLanes * packet);
  std::array<glm::mat3, kLanes> to_local;
  for (int lane = 0; lane < kLanes; ++lane)
    to_local[std::size_t(lane)] = glm::transpose(frame_of_normal(s.normal.lane(lane)));
  const UInt8 texels = lane_numbers() + std::uint32_t(kLanes * packet);
  for (std::size_t light = 0; light < setting_.lights.size(); ++light) {
    const BakeLight& asked = setting_.lights[light];
    const Incident8 incident = asked.incident(s, seeds);
    const UInt8 slots = texels * std::uint32_t(setting_.lights.size()) + std::uint32_t(light);
    const Vec8 mirrored = s.normal * (2 * incident.n_dot_l) - incident.unit;
    const Int8 lit = mask & (largest(incident.radiance) > 0);
    for_lanes(lit, [&](int lane) {
      arrivals_[slots[lane]] = {to_local[std::size_t(lane)] * mirrored.lane(lane), incident.n_dot_l[lane]};
    });
    ask_shadow(shadows_, s, lit, incident.to_light, asked.directional(), incident.radiance, slots);
  }
}

glm::vec3 BlockBaker::matte(int i, const Surfaces8& s, int lane) {
  glm::vec3 irradiance(0);
  const std::size_t lights = setting_.lights.size(), begin = std::size_t(i) * lights;
  for (std::size_t light = begin; light < begin + lights; ++light)
    irradiance += arriving_[light] * arrivals_[light].n_dot_l;
  const glm::vec3 direct = s.emission.lane(lane) + s.albedo.lane(lane) * irradiance;
  if (setting_.options.bounces == 0) return direct;
  const glm::vec3 halves[2]{direct + waves_.indirect(i, 0), direct + waves_.indirect(i, 1)};
  error_sum_ += half_error(halves[0], halves[1]);
  return 0.5f * (halves[0] + halves[1]);
}

/// Phong's: ks max(R.V, 0)^Ns. Where r is below the cosine at which a highlight is too faint to be kept,
/// powers are not taken.
void BlockBaker::add_highlights(int i, float specular, float exponent) {
  const std::size_t lights = setting_.lights.size(), begin = std::size_t(i) * lights;
  for (std::size_t light = begin; light < begin + lights; ++light) {
    const Vec8 strength = splat(specular * arriving_[light]);
    const float brightest = largest(strength)[0];
    if (!(brightest > kFaintest)) continue;
    const float least = std::pow(kFaintest / brightest, 1 / std::max(exponent, 1e-6f));
    const Vec8 mirrored = splat(arrivals_[light].mirrored);
    for (std::size_t d = 0; d < sums_.size(); ++d) {
      const Float8 cosine = dot(mirrored, setting_.directions[d]);
      const Int8 shines = cosine > least;
      if (!any(shines)) continue;
      const Float8 base = min8(select(shines, cosine, splat(1)), splat(1));
      const Float8 power = select(shines, power8(base, splat(exponent)), splat(0));
      sums_[d] = sums_[d] + strength * power;
    }
  }
}

void BlockBaker::shade(int i) {
  const Surfaces8& s = surfaces_[std::size_t(i / kLanes)];
  const int lane = i % kLanes;
  sums_.assign(setting_.directions.size(), splat(matte(i, s, lane)));
  if (s.specular[lane] > 0) add_highlights(i, s.specular[lane], s.exponent[lane]);
  HalfTexel* to = baked_.data() + std::size_t(i) * sums_.size() * kLanes;
  const Float8 share = splat(1 / setting_.options.scale);
  for (std::size_t d = 0; d < sums_.size(); ++d) store_halves(to + d * kLanes, sums_[d] * share);
}

/// Texels of a block are mostly neighbours, so that layers are written a run at a time.
/// Whether nothing leaves the block.
bool BlockBaker::is_dark() const {
  const std::size_t stride = setting_.directions.size() * kLanes;
  return std::all_of(baked_.begin(), baked_.begin() + std::ptrdiff_t(std::size_t(count_) * stride),
                     [](const HalfTexel& texel) { return texel == HalfTexel{}; });
}

void BlockBaker::keep() const {
  const std::size_t stride = setting_.directions.size() * kLanes;
  for (int layer = 0; layer < stack_.grid.layers(); ++layer) {
    HalfTexel* to = stack_.texels.data() + std::size_t(layer) * stack_.layer_size();
    for (int i = 0; i < count_; ++i)
      to[texel(i).place] = baked_[std::size_t(i) * stride + std::size_t(layer)];
  }
}

void BlockBaker::bake(std::size_t first, int count) {
  first_ = first, count_ = count;
  std::ranges::fill(arriving_, glm::vec3(0));
  waves_.start(count);
  for (int packet = 0; kLanes * packet < count; ++packet) {
    const Surfaces8& s = surfaces_[std::size_t(packet)] = surfaces(packet);
    ask_lights(packet, s, seeds(packet));
    waves_.add_points(s, first_lanes(count - kLanes * packet), seeds(packet),
                      lane_numbers() + std::uint32_t(kLanes * packet));
  }
  shadows_.flush();
  waves_.add_samples(0, (setting_.options.bounce_samples + 1) / 2);
  for (int i = 0; i < count; ++i) shade(i);
  if (is_dark()) return;  // as the stack is: of a back that nobody lights no memory is ever touched
  lit_ = true;
  keep();
}

/// Hands out blocks and tells of what is done.
class Blocks {
 public:
  Blocks(std::size_t texels, const std::function<void(double)>& progress)
      : texels_(texels), progress_(progress) {}

  /// Nothing where `first` is the number of texels.
  struct Block {
    std::size_t first;
    int count;
  };
  Block next() {
    const std::size_t first = std::min(texels_, kBlock * next_++);
    return {first, int(std::min<std::size_t>(kBlock, texels_ - first))};
  }
  void done(const Block& block) {
    if (!progress_) return;
    const std::lock_guard lock(mutex_);
    done_ += std::size_t(block.count);
    progress_(double(done_) / double(texels_));
  }

 private:
  std::size_t texels_;
  const std::function<void(double)>& progress_;
  std::atomic<std::size_t> next_ = 0;
  std::mutex mutex_;
  std::size_t done_ = 0;
};

}  // namespace

BakeNews bake_texels(const PathScene& scene, std::size_t entity, std::span<const BakeTexel> texels,
                     const BakeOptions& options, HalfStack& stack,
                     const std::function<void(double)>& progress) {
  assert(stack.grid == options.grid && stack.scale == options.scale &&
         stack.texels.size() == stack.layer_size() * std::size_t(stack.grid.layers()));
  const ObjectSurface surface(scene, entity);
  const std::vector<BakeLight> lights = bake_lights(scene.scene, options.light_samples);
  const std::vector<Vec8> directions = packed_directions(options.grid);
  const std::uint32_t seed = hash_pair(picture_seed(options.seed), std::uint32_t(entity));
  const BakeSetting setting{surface, lights, directions, texels, options, seed};
  Blocks blocks(texels.size(), progress);
  BakeNews news;
  RayTally shadow, diffuse;
  double errors = 0;
  std::mutex mutex;
  const auto work = [&] {
    BlockBaker baker(scene, setting, stack);
    for (Blocks::Block block = blocks.next(); block.count > 0; block = blocks.next()) {
      baker.bake(block.first, block.count);
      blocks.done(block);
    }
    const std::lock_guard lock(mutex);
    shadow += baker.shadow_rays(), shadow += baker.path_shadow_rays(), diffuse += baker.diffuse_rays();
    errors += baker.error_sum();
    news.lit |= baker.lit();
  };
  std::vector<std::future<void>> helpers;
  for (int i = 1; i < options.threads; ++i) helpers.push_back(std::async(std::launch::async, work));
  work();
  for (std::future<void>& helper : helpers) helper.get();  // with the errors that it met
  news.rays = {{"shadow", shadow.rays, shadow.seconds}, {"diffuse", diffuse.rays, diffuse.seconds}};
  if (!texels.empty()) news.noise = errors / double(texels.size());
  return news;
}

}  // namespace lightbench
