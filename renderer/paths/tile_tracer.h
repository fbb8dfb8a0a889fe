#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "renderer/paths/direct_sampler.h"
#include "renderer/paths/path_scene.h"
#include "renderer/paths/path_waves.h"
#include "renderer/paths/ray_queues.h"

namespace lightbench {

/// A rectangle of primary rays.
struct RayTile {
  int x, y, width, height;
};

struct RayTallies {
  RayTally primary, shadow, diffuse, sight;
};

/// Traces the primary rays of one tile after another, with their direct light, and gathers indirect light at
/// what they hit. Results depend on the seed and the primary ray only, never on the tile. One for each
/// thread.
class TileTracer {
 public:
  TileTracer(const PathScene& scene, const PathCamera& camera, int bounces, std::uint64_t seed,
             const std::optional<SightLimits>& limits = std::nullopt);

  /// Traces the primary rays and their direct light, and forgets the tile before.
  void start(const RayTile& tile);
  /// Traces the paths first <= index < end of each half of every primary ray.
  void add_samples(int first, int end) { waves_.add_samples(first, end); }

  /// By primary ray, row after row.
  bool covered(int ray) const { return covered_[std::size_t(ray)] != 0; }
  /// Emission and direct light; 0 where nothing is hit.
  const glm::vec3& direct(int ray) const { return direct_[std::size_t(ray)]; }
  /// The reflected indirect light: the mean of a half's samples, or where the limits say so of those that
  /// went to what is known.
  glm::vec3 indirect(int ray, int half) const { return waves_.indirect(ray, half); }
  /// The share of the samples, 0..1, whose first ray went to what no picture holds.
  float unknown(int ray) const { return waves_.unknown(ray); }

  RayTallies tallies() const;

 private:
  void shade_primary(int packet);

  const PathScene& scene_;
  const PathCamera& camera_;
  std::uint32_t seed_;
  RayTile tile_{};
  std::vector<std::uint8_t> covered_;
  std::vector<glm::vec3> direct_;
  DirectSampler lights_;
  HitQueue hits_;
  ShadowQueue shadows_;
  RayTally primary_;
  PathWaves waves_;
};

}  // namespace lightbench
