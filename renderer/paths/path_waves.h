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

/// Gathers the light that arrives at points over other surfaces. Paths are traced in waves: each stage
/// (scatter, trace, shade) runs over thousands of paths before the next, so that packets of rays can be
/// filled with rays that lie close together. Two independent halves of the samples are kept apart. Results
/// depend on a point and its seed only, never on the points beside it. One for each thread.
class PathWaves {
 public:
  /// With `sight`, paths end on what no picture holds; with `fill_unknown`, the mean of the others stands for
  /// them.
  PathWaves(const PathScene& scene, int bounces, std::optional<Sight> sight = std::nullopt,
            bool fill_unknown = false);

  /// Forgets all points; there will be at most `slots`.
  void start(int slots);
  /// Points in the lanes of the mask, each with a seed and a slot of its own.
  void add_points(const Surfaces8& surfaces, Int8 mask, UInt8 seeds, UInt8 slots);
  /// Traces the paths first <= index < end of each half of every point.
  void add_samples(int first, int end);

  /// The reflected indirect light at a slot's point: the mean of a half's samples, or where the limits say so
  /// of those that went to what is known.
  glm::vec3 indirect(int slot, int half) const;
  /// The share of the samples, 0..1, whose first ray went to what no picture holds.
  float unknown(int slot) const;

  const RayTally& shadow_rays() const { return shadows_.tally(); }
  const RayTally& diffuse_rays() const { return diffuse_; }
  const RayTally& sight_rays() const { return sight_tally_; }

 private:
  /// Paths on their way to the next surface, but for their rays.
  struct Flights8 {
    Vec8 throughput;
    Float8 density;  ///< of the direction, per steradian
    UInt8 seed, index, slot;
  };

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
  int bounces_;
  std::optional<Sight> sight_;  ///< empty: unlimited
  bool fill_unknown_;
  std::vector<glm::vec3> indirect_;  ///< sums over samples, by 2 * slot + half
  std::vector<int> unknown_;         ///< samples, likewise
  int samples_ = 0;                  ///< of each half
  std::vector<Row> points_;          ///< Vertices8 of the points
  int point_count_ = 0;

  std::vector<Row> vertices_;  ///< of the wave
  std::vector<Row> next_;      ///< those that its paths went on to
  std::vector<Row> flights_;   ///< rays in the lower half, Flights8 in the upper
  std::vector<std::uint16_t> keys_, order_;
  std::vector<std::uint16_t> astray_;  ///< vertices whose ray is to be drawn anew
  DirectSampler lights_;
  HitQueue hits_;
  ShadowQueue shadows_;
  RayTally diffuse_, sight_tally_;
};

}  // namespace lightbench
