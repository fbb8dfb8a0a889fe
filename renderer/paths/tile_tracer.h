#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "renderer/paths/direct_sampler.h"
#include "renderer/paths/lanes.h"
#include "renderer/paths/path_scene.h"
#include "renderer/paths/ray_queues.h"
#include "renderer/paths/sight.h"
#include "renderer/paths/vertices.h"

namespace lightbench {

/// A rectangle of primary rays.
struct RayTile {
  int x, y, width, height;
};

struct RayTallies {
  RayTally primary, shadow, diffuse, sight;
};

/// Traces the paths of one tile after another, in waves: each stage (scatter, trace, shade) runs over
/// thousands of paths before the next, so that packets of rays can be filled with rays that lie close
/// together. Primary rays and their direct light are traced once; samples are of the light that arrives over
/// other surfaces. Two independent halves of the samples are kept apart. Results depend on the seed and the
/// primary ray only, never on the tile. Where sight is limited, paths end on what no picture holds. One for
/// each thread.
class TileTracer {
 public:
  TileTracer(const PathScene& scene, const PathCamera& camera, int bounces, std::uint64_t seed,
             const std::optional<SightLimits>& limits = std::nullopt);

  /// Traces the primary rays and their direct light, and forgets the tile before.
  void start(const RayTile& tile);
  /// Traces the paths first <= index < end of each half of every primary ray.
  void add_samples(int first, int end);

  /// By primary ray, row after row.
  bool covered(int ray) const { return covered_[std::size_t(ray)] != 0; }
  /// Emission and direct light; 0 where nothing is hit.
  const glm::vec3& direct(int ray) const { return direct_[std::size_t(ray)]; }
  /// The reflected indirect light: the mean of a half's samples, or where the limits say so of those that
  /// went to what is known.
  glm::vec3 indirect(int ray, int half) const;
  /// The share of the samples, 0..1, whose first ray went to what no picture holds.
  float unknown(int ray) const;

  RayTallies tallies() const;

 private:
  /// Paths on their way to the next surface, but for their rays.
  struct Flights8 {
    Vec8 throughput;
    Float8 density;  ///< of the direction, per steradian
    UInt8 seed, index, slot;
  };

  void shade_primary(int packet);
  void begin_wave(std::int64_t first_path, int count, int first_sample, int samples);
  void trace_wave(int count);
  void sample_emitters(const Vertices8& from, Int8 mask, int draws);
  void scatter(int count, int draws);
  void sort_flights(int count);
  void queue_rays(int count);
  int gather(int bounce, int kept);
  Flights8 flights(int packet) const;
  Int8 known_lanes(const RTCRayHit8& rays, const Surfaces8& surfaces, Int8 valid, Int8 hit);
  void note_unknown(Int8 unknown, const Flights8& flights, int packet, int bounce);
  int take_back_unknown();
  void add_emission(const Surfaces8& surfaces, Int8 mask, const Flights8& flights, int packet);

  const PathScene& scene_;
  const PathCamera& camera_;
  int bounces_;
  std::uint32_t seed_;
  std::optional<Sight> sight_;  ///< empty: unlimited
  bool fill_unknown_;
  RayTile tile_{};

  std::vector<std::uint8_t> covered_;
  std::vector<glm::vec3> direct_, indirect_;  ///< the latter sums over samples, by 2 * ray + half
  std::vector<int> unknown_;                  ///< samples, likewise
  int samples_ = 0;                           ///< of each half
  std::vector<Row> points_;                   ///< Vertices8 of primary hits that reflect light
  int point_count_ = 0;

  std::vector<Row> vertices_;  ///< of the wave
  std::vector<Row> next_;      ///< those that its paths went on to
  std::vector<Row> flights_;   ///< rays in the lower half, Flights8 in the upper
  std::vector<std::uint16_t> keys_, order_;
  std::vector<std::uint16_t> astray_;  ///< vertices whose ray is to be drawn anew
  DirectSampler lights_;
  HitQueue hits_;
  ShadowQueue direct_shadows_, indirect_shadows_;
  RayTally primary_, diffuse_, sight_tally_;
};

}  // namespace lightbench
