#include "scene/repeated_faces.h"

#include <algorithm>

#include "scene/index_table.h"

namespace lightbench {
namespace {

using Ring = std::vector<std::uint32_t>;

// The start of the rotation that comes first in order, in linear time (Shiloach's algorithm).
std::size_t least_rotation(const Ring& ring) {
  const std::size_t n = ring.size();
  std::size_t i = 0, j = 1, equal = 0;
  while (i < n && j < n && equal < n) {
    const std::uint32_t a = ring[(i + equal) % n];
    const std::uint32_t b = ring[(j + equal) % n];
    if (a == b) {
      ++equal;
      continue;
    }
    (a > b ? i : j) += equal + 1;
    if (i == j) ++j;
    equal = 0;
  }
  return std::min(i, j);
}

// The same for all rings that differ in where they start and which way they go.
Ring normal_form(Ring ring) {
  std::rotate(ring.begin(), ring.begin() + std::ptrdiff_t(least_rotation(ring)), ring.end());
  Ring reversed(ring.rbegin(), ring.rend());
  std::rotate(reversed.begin(), reversed.begin() + std::ptrdiff_t(least_rotation(reversed)), reversed.end());
  return std::min(ring, reversed);
}

class FaceComparer {
 public:
  FaceComparer(const ObjData& data, const std::vector<std::uint32_t>& point_of_position)
      : data_(data), point_of_position_(point_of_position) {}

  // The points of a face in normal form; one that stands several times in a row counts once.
  Ring ring(const ObjFace& face) const {
    Ring points;
    for (std::uint32_t i = face.first_corner; i < face.first_corner + face.corner_count; ++i) {
      const std::uint32_t point = point_of_position_[std::size_t(data_.corners[i].position)];
      if (points.empty() || points.back() != point) points.push_back(point);
    }
    while (points.size() > 1 && points.front() == points.back()) points.pop_back();
    return normal_form(std::move(points));
  }

 private:
  const ObjData& data_;
  const std::vector<std::uint32_t>& point_of_position_;
};

}  // namespace

bool may_both_show(std::int32_t material_a, std::int32_t material_b, const std::vector<bool>& has_cutout) {
  const auto is_cut_out = [&](std::int32_t m) { return m >= 0 && has_cutout[std::size_t(m)]; };
  return material_a != material_b && (is_cut_out(material_a) || is_cut_out(material_b));
}

std::vector<bool> repeated_faces(const ObjData& data, const std::vector<std::uint32_t>& point_of_position,
                                 const std::vector<bool>& has_cutout) {
  std::vector<bool> repeated(data.faces.size());
  const auto larger = std::count_if(data.faces.begin(), data.faces.end(),
                                    [](const ObjFace& f) { return f.corner_count > 3; });
  if (larger < 2) return repeated;
  const FaceComparer comparer(data, point_of_position);
  std::vector<std::uint64_t> hashes(data.faces.size());
  IndexTable table{std::size_t(larger)};
  for (std::uint32_t i = 0; i < data.faces.size(); ++i) {
    const ObjFace& face = data.faces[i];
    if (face.corner_count <= 3) continue;
    const Ring ring = comparer.ring(face);
    for (const std::uint32_t point : ring) hashes[i] = mix_hash(hashes[i], point);
    const auto is_same = [&](std::uint32_t k) {
      return hashes[k] == hashes[i] && !may_both_show(data.faces[k].material, face.material, has_cutout) &&
             comparer.ring(data.faces[k]) == ring;
    };
    repeated[i] = table.find_or_insert(hashes[i], i, is_same) != i;
  }
  return repeated;
}

}  // namespace lightbench
