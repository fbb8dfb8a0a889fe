#include "renderer/paths/ray_queues.h"

#include <algorithm>
#include <iterator>
#include <limits>

#include "base/stopwatch.h"

namespace lightbench {
namespace {

constexpr int kShadowRays = 2048;

/// Adds rays and the time while it lives to a tally.
class RayTimer {
 public:
  explicit RayTimer(RayTally& tally, int rays) : tally_(tally) { tally_.rays += std::uint64_t(rays); }
  RayTimer(const RayTimer&) = delete;
  RayTimer& operator=(const RayTimer&) = delete;
  ~RayTimer() { tally_.seconds += watch_.seconds(); }

 private:
  RayTally& tally_;
  Stopwatch watch_;
};

void set_packet(RTCRay8& packet, const Rays8& rays, Float8 near, Float8 far) {
  store8(packet.org_x, rays.origin.x);
  store8(packet.org_y, rays.origin.y);
  store8(packet.org_z, rays.origin.z);
  store8(packet.dir_x, rays.direction.x);
  store8(packet.dir_y, rays.direction.y);
  store8(packet.dir_z, rays.direction.z);
  store8(packet.tnear, near);
  store8(packet.tfar, far);
}

/// What all rays share. Fields that Embree does not read for our scenes are set once, so that nothing is
/// uninitialised.
void prepare(RTCRay8& packet) {
  for (int i = 0; i < kLanes; ++i) {
    packet.time[i] = 0;
    packet.mask[i] = 0xffffffffu;
    packet.id[i] = 0;
    packet.flags[i] = 0;
  }
}

void forget_hits(RTCHit8& hits) {
  std::fill(std::begin(hits.geomID), std::end(hits.geomID), RTC_INVALID_GEOMETRY_ID);
  std::fill(std::begin(hits.instID[0]), std::end(hits.instID[0]), RTC_INVALID_GEOMETRY_ID);
}

/// The lanes of a packet of which `count` rays are left.
void set_valid(int (&valid)[kLanes], int count) {
  for (int i = 0; i < kLanes; ++i) valid[i] = i < count ? -1 : 0;
}

}  // namespace

RTCRayHit8 closest_hits(RTCScene scene, const Rays8& rays, Float8 near, Float8 far, Int8 mask,
                        RayTally& tally) {
  const RayTimer timer(tally, __builtin_popcount(bits_of(mask)));
  RTCRayHit8 packet;
  prepare(packet.ray);
  set_packet(packet.ray, rays, near, far);
  forget_hits(packet.hit);
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  alignas(32) int valid[kLanes];
  for (int i = 0; i < kLanes; ++i) valid[i] = mask[i];
  rtcIntersect8(valid, scene, &context, &packet);
  return packet;
}

void HitQueue::resize(int count) {
  size_ = count;
  const auto before = packets_.size();
  if (before < std::size_t(packets())) packets_.resize(std::size_t(packets()));
  for (std::size_t i = before; i < packets_.size(); ++i) prepare(packets_[i].ray);
}

void HitQueue::set(int index, const Rays8& rays) {
  RTCRayHit8& packet = packets_[std::size_t(index)];
  set_packet(packet.ray, rays, Float8{}, splat(std::numeric_limits<float>::infinity()));
  forget_hits(packet.hit);
}

void HitQueue::trace(RTCScene scene, RayTally& tally) {
  const RayTimer timer(tally, size_);
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  alignas(32) int valid[kLanes];
  for (int i = 0; i < packets(); ++i) {
    set_valid(valid, size_ - kLanes * i);
    rtcIntersect8(valid, scene, &context, &packets_[std::size_t(i)]);
  }
}

ShadowQueue::ShadowQueue(RTCScene scene, std::vector<glm::vec3>& sums)
    : scene_(scene), sums_(sums), rows_(kShadowRays), packets_(kShadowRays / kLanes) {
  for (RTCRay8& packet : packets_) prepare(packet);
}

void ShadowQueue::add(Int8 mask, const Rays8& rays, Float8 far, const Vec8& light, UInt8 slots) {
  if (size_ + kLanes > kShadowRays) flush();
  Fields8 low{}, high{};
  set_fields(low, 0, rays.origin);
  set_fields(low, 3, rays.direction);
  low.v[6] = far;
  set_fields(high, 0, light);
  high.v[3] = as_floats(slots);
  append(rows_, size_, low, high, mask);
}

void ShadowQueue::flush() {
  const int packets = (size_ + kLanes - 1) / kLanes;
  for (int i = 0; i < packets; ++i) {
    const Fields8 fields =
        load_half<&Row::low>(rows_.data() + std::ptrdiff_t{kLanes} * i, [](int lane) { return lane; });
    set_packet(packets_[std::size_t(i)], {vec_of(fields, 0), vec_of(fields, 3)}, Float8{}, fields.v[6]);
  }
  trace(packets);
  for (int i = 0; i < size_; ++i)
    if (packets_[std::size_t(i / kLanes)].tfar[i % kLanes] >= 0) {  // Embree's mark of a hit is below
      const Float8& light = rows_[std::size_t(i)].high;
      sums_[as_numbers(light)[3]] += glm::vec3(light[0], light[1], light[2]);
    }
  size_ = 0;
}

void ShadowQueue::trace(int packets) {
  const RayTimer timer(tally_, size_);
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  alignas(32) int valid[kLanes];
  for (int i = 0; i < packets; ++i) {
    set_valid(valid, size_ - kLanes * i);
    rtcOccluded8(valid, scene_, &context, &packets_[std::size_t(i)]);
  }
}

}  // namespace lightbench
