#pragma once

#include <cstdint>
#include <vector>

#include <embree3/rtcore.h>
#include <glm/vec3.hpp>

#include "renderer/paths/rows.h"

namespace lightbench {

/// How many rays of a class were traced and how long Embree took for them.
struct RayTally {
  std::uint64_t rays = 0;
  double seconds = 0;

  RayTally& operator+=(const RayTally& other) {
    rays += other.rays;
    seconds += other.seconds;
    return *this;
  }
};

/// Eight rays.
struct Rays8 {
  Vec8 origin;
  Vec8 direction;
};

/// The lanes of a traced packet that hit something.
inline Int8 hit_lanes(const RTCRayHit8& packet) {
  return load8(packet.hit.geomID) != RTC_INVALID_GEOMETRY_ID;
}

/// The closest hits of the rays in the lanes of the mask, between `near` and `far` times their directions.
RTCRayHit8 closest_hits(RTCScene scene, const Rays8& rays, Float8 near, Float8 far, Int8 mask,
                        RayTally& tally);

/// Rays to closest hits, in packets of eight.
class HitQueue {
 public:
  /// For `count` rays, of which set() must be called for each packet.
  void resize(int count);
  void set(int packet, const Rays8& rays);
  void trace(RTCScene scene, RayTally& tally);

  int size() const { return size_; }
  int packets() const { return (size_ + 7) / 8; }
  const RTCRayHit8& packet(int index) const { return packets_[std::size_t(index)]; }

 private:
  std::vector<RTCRayHit8> packets_;
  int size_ = 0;
};

/// Shadow rays in packets of eight. What a ray brings is added to a sum if nothing is in its way; the queue
/// is traced whenever it is full.
class ShadowQueue {
 public:
  ShadowQueue(RTCScene scene, std::vector<glm::vec3>& sums);

  /// The rays in the lanes of the mask, from their origins to `far` times their directions; `light` goes to
  /// sums[slot].
  void add(Int8 mask, const Rays8& rays, Float8 far, const Vec8& light, UInt8 slots);
  void flush();
  const RayTally& tally() const { return tally_; }

 private:
  void trace(int packets);

  RTCScene scene_;
  std::vector<glm::vec3>& sums_;
  std::vector<Row> rows_;  ///< rays in the lower half; light and slot in the upper
  std::vector<RTCRay8> packets_;
  int size_ = 0;
  RayTally tally_;
};

}  // namespace lightbench
