#include "renderer/paths/ray_queues.h"

#include <algorithm>
#include <chrono>
#include <limits>

namespace lightbench {
namespace {

constexpr int kShadowRays = 2048;

class Stopwatch {
 public:
  explicit Stopwatch(RayTally& tally, int rays) : tally_(tally), start_(Clock::now()) {
    tally_.rays += std::uint64_t(rays);
  }
  Stopwatch(const Stopwatch&) = delete;
  Stopwatch& operator=(const Stopwatch&) = delete;
  ~Stopwatch() { tally_.seconds += std::chrono::duration<double>(Clock::now() - start_).count(); }

 private:
  using Clock = std::chrono::steady_clock;
  RayTally& tally_;
  Clock::time_point start_;
};

void set_lane(RTCRay8& packet, int lane, const PathRay& ray, float far) {
  packet.org_x[lane] = ray.origin.x;
  packet.org_y[lane] = ray.origin.y;
  packet.org_z[lane] = ray.origin.z;
  packet.dir_x[lane] = ray.direction.x;
  packet.dir_y[lane] = ray.direction.y;
  packet.dir_z[lane] = ray.direction.z;
  packet.tnear[lane] = 0;
  packet.tfar[lane] = far;
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

/// The lanes of a packet of which `count` rays are left.
void set_valid(int (&valid)[kLanes], int count) {
  for (int i = 0; i < kLanes; ++i) valid[i] = i < count ? -1 : 0;
}

}  // namespace

void HitQueue::resize(int count) {
  size_ = count;
  const auto before = packets_.size();
  if (before < std::size_t(packets())) packets_.resize(std::size_t(packets()));
  for (std::size_t i = before; i < packets_.size(); ++i) prepare(packets_[i].ray);
}

void HitQueue::set(int index, const PathRay& ray) {
  RTCRayHit8& packet = packets_[std::size_t(index / kLanes)];
  const int lane = index % kLanes;
  set_lane(packet.ray, lane, ray, std::numeric_limits<float>::infinity());
  packet.hit.geomID[lane] = RTC_INVALID_GEOMETRY_ID;
  packet.hit.instID[0][lane] = RTC_INVALID_GEOMETRY_ID;
}

void HitQueue::trace(RTCScene scene, RayTally& tally) {
  const Stopwatch watch(tally, size_);
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  alignas(32) int valid[kLanes];
  for (int i = 0; i < packets(); ++i) {
    set_valid(valid, size_ - kLanes * i);
    rtcIntersect8(valid, scene, &context, &packets_[std::size_t(i)]);
  }
}

ShadowQueue::ShadowQueue(RTCScene scene, std::vector<glm::vec3>& sums)
    : scene_(scene), sums_(sums), packets_(kShadowRays / kLanes), lights_(kShadowRays) {
  for (RTCRay8& packet : packets_) prepare(packet);
}

void ShadowQueue::add(const PathRay& ray, float far, const glm::vec3& light, std::uint32_t slot) {
  set_lane(packets_[std::size_t(size_ / kLanes)], size_ % kLanes, ray, far);
  lights_[std::size_t(size_)] = {light, slot};
  if (++size_ == kShadowRays) flush();
}

void ShadowQueue::flush() {
  {
    const Stopwatch watch(tally_, size_);
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    alignas(32) int valid[kLanes];
    for (int i = 0; kLanes * i < size_; ++i) {
      set_valid(valid, size_ - kLanes * i);
      rtcOccluded8(valid, scene_, &context, &packets_[std::size_t(i)]);
    }
  }
  for (int i = 0; i < size_; ++i)
    if (packets_[std::size_t(i / kLanes)].tfar[i % kLanes] >= 0)  // Embree's mark of a hit is below
      sums_[lights_[std::size_t(i)].slot] += lights_[std::size_t(i)].value;
  size_ = 0;
}

}  // namespace lightbench
