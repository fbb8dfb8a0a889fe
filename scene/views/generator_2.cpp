#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "base/error.h"
#include "scene/views/drawing.h"
#include "scene/views/generators.h"
#include "scene/views/judge_2.h"
#include "scene/views/stances.h"

namespace lightbench::views_2 {
namespace {

// Valid places of which the best view is taken.
constexpr int kCandidates = 12;

// With fewer valid places of one stance, the next one is tried too.
constexpr int kEnoughCandidates = 4;

// Views from each place, of which the best one stands for it.
constexpr int kDirections = 3;

// How much it counts that a view looks elsewhere, when its place is compared with those of other views: as
// much as this share of the way across all valid places.
constexpr double kTurnedRound = 0.25;

struct Candidate {
  Camera camera;
  double quality = 0;
};

glm::vec3 direction_of(const Camera& camera) {
  return glm::normalize(camera.look_at - camera.position);
}

class Drawing {
 public:
  Drawing(const Scene& scene, const RandomViewOptions& options, const ClosestHit& closest_hit)
      : scene_(scene),
        options_(options),
        scale_(scene_scale(scene, closest_hit)),
        judge_(scene, scale_, closest_hit),
        stances_(scene, scale_, options.fov, options.aspect, closest_hit),
        random_(options.seed) {}

  Camera draw(const std::vector<Camera>& before);

 private:
  std::vector<Candidate> candidates(const Strictness& strictness, Refusals& refusals);
  std::optional<Candidate> candidate(const Stance& stance, const Strictness& strictness, Refusals& refusals);
  double apart(const Camera& camera, const std::vector<Camera>& others) const;

  const Scene& scene_;
  const RandomViewOptions& options_;
  SceneScale scale_;
  ViewJudge judge_;
  Stances stances_;
  RawRandom random_;
  // What earlier views did not find, later ones need not look for: their strictness, stances without any
  // place. The valid places so far say how far apart views can be, since the bounds may hold a whole sky.
  std::size_t level_ = 0;
  std::array<bool, kStancesInPlaces.size()> fruitless_{};
  Bounds reached_;
};

// The candidate that is best and farthest from all views before.
Camera Drawing::draw(const std::vector<Camera>& before) {
  Refusals refusals;
  for (; level_ < std::size(kStrictness); ++level_, fruitless_ = {}) {
    const auto found = candidates(kStrictness[level_], refusals);
    if (found.empty()) continue;
    for (const Candidate& candidate : found) reached_.add(candidate.camera.position);
    const Candidate* best = nullptr;
    double best_score = -1;
    for (const Candidate& candidate : found) {
      const double score = candidate.quality * apart(candidate.camera, before);
      if (score <= best_score) continue;
      best = &candidate;
      best_score = score;
    }
    return best->camera;
  }
  throw Error(fmt::format("no valid view in {} tries; {}", refusals.tries(), refusals.most_frequent()),
              scene_.name);
}

std::vector<Candidate> Drawing::candidates(const Strictness& strictness, Refusals& refusals) {
  std::vector<Candidate> found;
  const auto& stances = scale_.is_object ? kStancesAroundObject : kStancesInPlaces;
  for (std::size_t s = 0; s < stances.size(); ++s) {
    const Stance& stance = stances[s];
    const std::size_t before = found.size();
    for (int i = 0; i < stance.tries && int(found.size()) < kCandidates && !fruitless_[s]; ++i)
      if (auto one = candidate(stance, strictness, refusals)) found.push_back(*one);
    if (found.size() == before && int(before) < kCandidates) fruitless_[s] = true;
    if (int(found.size()) >= kEnoughCandidates && stance.is_enough) break;
  }
  return found;
}

std::optional<Candidate> Drawing::candidate(const Stance& stance, const Strictness& strictness,
                                            Refusals& refusals) {
  const auto position = (stances_.*stance.position)(random_);
  if (!position) {
    refusals.add(stance.nowhere);
    return std::nullopt;
  }
  if (const auto reason = judge_.why_position_is_invalid(*position, strictness)) {
    refusals.add(*reason);
    return std::nullopt;
  }
  const Place place = judge_.place(*position);
  if (const auto reason = judge_.why_place_is_invalid(place, strictness)) {
    refusals.add(*reason);
    return std::nullopt;
  }
  std::optional<Candidate> best;
  for (int i = 0; i < kDirections; ++i) {
    const Camera camera = stances_.look(*position, stance, i, random_);
    const Verdict verdict = judge_.judge(camera, place, options_.aspect, strictness);
    if (verdict.reason)
      refusals.add(*verdict.reason);
    else if (!best || verdict.quality * stance.quality > best->quality)
      best = Candidate{camera, verdict.quality * stance.quality};
  }
  return best;
}

// The distance from the nearest of the others in shares of the way across all valid places, at most 1.
double Drawing::apart(const Camera& camera, const std::vector<Camera>& others) const {
  const double across = std::max(double(reached_.diagonal()), 1e-3 * scale_.diagonal);
  double nearest = 1;
  for (const Camera& other : others) {
    const double way = double(glm::distance(camera.position, other.position)) / across;
    const double turn = 0.5 * (1 - double(glm::dot(direction_of(camera), direction_of(other))));
    nearest = std::min(nearest, std::sqrt(way * way + kTurnedRound * kTurnedRound * turn));
  }
  return nearest;
}

}  // namespace

std::vector<Camera> draw_cameras(const Scene& scene, const RandomViewOptions& options,
                                 const ClosestHit& closest_hit) {
  Drawing drawing(scene, options, closest_hit);
  std::vector<Camera> cameras;
  for (int i = 0; i < options.count; ++i) cameras.push_back(drawing.draw(cameras));
  return cameras;
}

std::optional<std::string> why_invalid(const Scene& scene, const Camera& camera, float aspect,
                                       const ClosestHit& closest_hit) {
  const SceneScale scale = scene_scale(scene, closest_hit);
  const ViewJudge judge(scene, scale, closest_hit);
  if (auto reason = judge.why_position_is_invalid(camera.position, kStrictness[0])) return reason;
  const Place place = judge.place(camera.position);
  if (auto reason = judge.why_place_is_invalid(place, kStrictness[0])) return reason;
  return judge.judge(camera, place, aspect, kStrictness[0]).reason;
}

}  // namespace lightbench::views_2
