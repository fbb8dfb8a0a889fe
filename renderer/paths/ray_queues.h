#pragma once

#include <cstdint>
#include <vector>

#include <embree3/rtcore.h>
#include <glm/vec3.hpp>

#include "renderer/paths/lanes.h"

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

struct PathRay {
  glm::vec3 origin;
  glm::vec3 direction;
};

/// The lanes of a traced packet that hit something.
inline Int8 hit_lanes(const RTCRayHit8& packet) {
  return load8(packet.hit.geomID) != RTC_INVALID_GEOMETRY_ID;
}

/// Rays to closest hits, in packets of eight.
class HitQueue {
 public:
  /// For `count` rays, of which set() must be called for each.
  void resize(int count);
  void set(int index, const PathRay& ray);
  void trace(RTCScene scene, RayTally& tally);

  int size() const { return size_; }
  int packets() const { return (size_ + 7) / 8; }
  const RTCRayHit8& packet(int index) const { return packets_[std::size_t(index)]; }
  RTCRayHit8& packet(int index) { return packets_[std::size_t(index)]; }

 private:
  std::vector<RTCRayHit8> packets_;
  int size_ = 0;
};

/// Shadow rays in packets of eight. What a ray brings is added to a sum if nothing is in its way; the queue
/// is traced whenever it is full.
class ShadowQueue {
 public:
  ShadowQueue(RTCScene scene, std::vector<glm::vec3>& sums);

  /// From the ray's origin to `far` times its direction; `light` goes to sums[slot].
  void add(const PathRay& ray, float far, const glm::vec3& light, std::uint32_t slot);
  void flush();
  const RayTally& tally() const { return tally_; }

 private:
  struct Light {
    glm::vec3 value;
    std::uint32_t slot;
  };
  RTCScene scene_;
  std::vector<glm::vec3>& sums_;
  std::vector<RTCRay8> packets_;
  std::vector<Light> lights_;
  int size_ = 0;
  RayTally tally_;
};

}  // namespace lightbench
