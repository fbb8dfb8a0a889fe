#include "renderer/radiance/buried_texels.h"

#include <algorithm>

#include <glm/common.hpp>
#include <glm/gtc/packing.hpp>

#include "renderer/radiance/object_surface.h"

namespace lightbench {
namespace {

/// Where in a layer a buried texel lies, and those around it that are there before it.
struct Filling {
  std::size_t place;
  std::vector<std::size_t> from;
};

constexpr int kNever = -1, kLater = -2;  // of places without a texel; of those that wait

/// Rounds in which places get their value: 0 for what was traced.
class Rounds {
 public:
  Rounds(const ChartAtlas& atlas, const std::vector<bool>& buried)
      : size_(atlas.width, atlas.height),
        rounds_(std::size_t(atlas.width) * std::size_t(atlas.height), kNever) {
    for (std::size_t i = 0; i < buried.size(); ++i) {
      const glm::ivec2 place = atlas.surface[i].place;
      rounds_[index(place)] = buried[i] ? kLater : 0;
      if (buried[i]) waiting_.push_back(place);
    }
  }

  /// In the order in which they can be filled.
  std::vector<Filling> fillings() {
    std::vector<Filling> fillings;
    for (int round = 1; !waiting_.empty(); ++round) {
      const std::size_t before = fillings.size();
      std::vector<glm::ivec2> still;
      for (const glm::ivec2& place : waiting_) {
        std::vector<std::size_t> from = known_around(place, round);
        if (from.empty())
          still.push_back(place);
        else
          rounds_[index(place)] = round, fillings.push_back({index(place), std::move(from)});
      }
      if (fillings.size() == before) break;
      waiting_ = std::move(still);
    }
    return fillings;
  }

 private:
  std::size_t index(const glm::ivec2& place) const {
    return std::size_t(place.y) * std::size_t(size_.x) + std::size_t(place.x);
  }
  std::vector<std::size_t> known_around(const glm::ivec2& place, int round) const {
    std::vector<std::size_t> known;
    const glm::ivec2 low = glm::max(place - 1, glm::ivec2(0)), high = glm::min(place + 1, size_ - 1);
    for (int y = low.y; y <= high.y; ++y)
      for (int x = low.x; x <= high.x; ++x)
        if (const std::size_t i = index({x, y}); rounds_[i] >= 0 && rounds_[i] < round) known.push_back(i);
    return known;
  }

  glm::ivec2 size_;
  std::vector<int> rounds_;
  std::vector<glm::ivec2> waiting_;
};

}  // namespace

std::vector<bool> buried_texels(const PathScene& scene, const Solids& solids, std::size_t entity,
                                std::span<const BakeTexel> texels, float above) {
  std::vector<bool> buried(texels.size(), false);
  if (solids.empty()) return buried;
  const ObjectSurface surface(scene, entity);
  for (std::size_t first = 0; first < texels.size(); first += kLanes) {
    const std::size_t count = std::min<std::size_t>(kLanes, texels.size() - first);
    std::array<MeshPoint, kLanes> points;
    for (std::size_t lane = 0; lane < kLanes; ++lane)
      points[lane] = texels[first + std::min(lane, count - 1)].point;
    const Surfaces8 s = surface.at(points, texels[first].side);
    const Vec8 places = s.position + s.offset + s.normal * splat(above);
    for (std::size_t lane = 0; lane < count; ++lane)
      buried[first + lane] = solids.contain(places.lane(int(lane)), s.normal.lane(int(lane)));
  }
  return buried;
}

void fill_buried(const ChartAtlas& atlas, const std::vector<bool>& buried, HalfStack& stack) {
  const std::vector<Filling> fillings = Rounds(atlas, buried).fillings();
  for (int layer = 0; layer < stack.grid.layers(); ++layer) {
    const std::size_t first = std::size_t(layer) * stack.layer_size();
    for (const Filling& filling : fillings)
      for (std::size_t c = 0; c < 3; ++c) {
        float sum = 0;
        for (const std::size_t place : filling.from)
          sum += glm::unpackHalf1x16(stack.texels[first + place][c]);
        stack.texels[first + filling.place][c] = glm::packHalf1x16(sum / float(filling.from.size()));
      }
  }
}

}  // namespace lightbench
