#include "scene/mesh_builder.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <numeric>
#include <span>
#include <utility>

#include <glm/geometric.hpp>

#include "scene/index_table.h"
#include "scene/model_origin.h"
#include "scene/placed_uvs.h"
#include "scene/repeated_faces.h"
#include "scene/smooth_normals.h"
#include "scene/smoothing_groups.h"
#include "scene/triangulate.h"
#include "scene/welded_points.h"

namespace lightbench {
namespace {

// A triangle whose height is below this share of its longest side has no normal worth the name in 32-bit
// floats.
constexpr double kSmallestHeight = 1e-6;

std::vector<glm::vec3> positions_from(const ObjData& data, const glm::dvec3& origin) {
  std::vector<glm::vec3> positions;
  positions.reserve(data.positions.size());
  for (const glm::dvec3& p : data.positions) positions.emplace_back(p - origin);
  return positions;
}

struct Triangle {
  std::array<std::uint32_t, 3> corners;  // into ObjData::corners
  std::uint32_t face;                    // into ObjData::faces
};

bool is_degenerate(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
  const glm::dvec3 ab = glm::dvec3(b) - glm::dvec3(a);
  const glm::dvec3 ac = glm::dvec3(c) - glm::dvec3(a);
  const glm::dvec3 bc = glm::dvec3(c) - glm::dvec3(b);
  const double longest = std::max({glm::dot(ab, ab), glm::dot(ac, ac), glm::dot(bc, bc)});
  return !(glm::length(glm::cross(ab, ac)) > kSmallestHeight * longest);
}

class MeshBuilder {
 public:
  MeshBuilder(const ObjData& data, const MeshOptions& options)
      : data_(data),
        options_(options),
        origin_(model_origin(data)),
        positions_(positions_from(data, origin_)),
        welded_(weld(positions_)),
        uvs_(data, options.material_placement) {}

  BuiltMeshes run() {
    cut_faces();
    drop_duplicates();
    compute_normals();
    build();
    result_.origin = origin_;
    return std::move(result_);
  }

 private:
  std::uint32_t point(std::uint32_t corner) const {
    return welded_.point_of_position[std::size_t(data_.corners[corner].position)];
  }

  const ObjFace& face(const Triangle& t) const { return data_.faces[t.face]; }

  void cut_faces() {
    const std::vector<bool> repeated =
        repeated_faces(data_, welded_.point_of_position, options_.material_has_cutout);
    triangles_.reserve(data_.faces.size());
    for (std::uint32_t i = 0; i < data_.faces.size(); ++i) {
      if (repeated[i])
        result_.statistics.duplicate_triangles += data_.faces[i].corner_count - 2;
      else
        cut_face(i);
    }
  }

  void cut_face(std::uint32_t index) {
    const ObjFace& face = data_.faces[index];
    polygon_.clear();
    cut_.clear();
    for (std::uint32_t i = 0; i < face.corner_count; ++i)
      polygon_.push_back(welded_.points[point(face.first_corner + i)]);
    if (!triangulate(polygon_, cut_, budget_)) ++result_.statistics.crossing_faces;
    for (const glm::uvec3& t : cut_) {
      const std::uint32_t first = face.first_corner;
      if (is_degenerate(polygon_[t.x], polygon_[t.y], polygon_[t.z]))
        ++result_.statistics.degenerate_triangles;
      else
        triangles_.push_back({{first + t.x, first + t.y, first + t.z}, index});
    }
  }

  std::array<std::uint32_t, 3> sorted_points(const Triangle& t) const {
    std::array<std::uint32_t, 3> points{point(t.corners[0]), point(t.corners[1]), point(t.corners[2])};
    std::sort(points.begin(), points.end());
    return points;
  }

  bool same_place(const Triangle& a, const Triangle& b) const {
    return !may_both_show(face(a).material, face(b).material, options_.material_has_cutout) &&
           sorted_points(a) == sorted_points(b);
  }

  void drop_duplicates() {
    IndexTable table(triangles_.size());
    std::uint32_t kept = 0;
    for (const Triangle& t : triangles_) {
      std::uint64_t hash = 0;
      for (const std::uint32_t p : sorted_points(t)) hash = mix_hash(hash, p);
      const std::uint32_t found =
          table.find_or_insert(hash, kept, [&](std::uint32_t i) { return same_place(triangles_[i], t); });
      if (found == kept)
        triangles_[kept++] = t;
      else
        ++result_.statistics.duplicate_triangles;
    }
    triangles_.resize(kept);
  }

  void compute_normals() {
    normals_.resize(3 * triangles_.size());
    std::vector<bool> by_crease(normals_.size());
    std::vector<bool> by_group(normals_.size());
    std::vector<glm::uvec3> points(triangles_.size());
    std::vector<std::int32_t> groups;
    for (std::size_t i = 0; i < triangles_.size(); ++i) {
      const std::int32_t smoothing = face(triangles_[i]).smoothing;
      groups.push_back(smoothing);
      for (std::size_t k = 0; k < 3; ++k) {
        points[i][int(k)] = point(triangles_[i].corners[k]);
        if (!given_normal(triangles_[i].corners[k], normals_[3 * i + k]))
          (smoothing == kSmoothingUnsaid ? by_crease : by_group)[3 * i + k] = true;
      }
    }
    if (std::find(by_crease.begin(), by_crease.end(), true) != by_crease.end())
      fill_normals(by_crease, smooth_normals(welded_.points, points, options_.crease_angle, by_crease));
    if (std::find(by_group.begin(), by_group.end(), true) != by_group.end())
      fill_normals(by_group, smoothing_group_normals(welded_.points, points, groups, by_group));
  }

  void fill_normals(const std::vector<bool>& wanted, const std::vector<glm::vec3>& computed) {
    for (std::size_t i = 0; i < normals_.size(); ++i)
      if (wanted[i]) normals_[i] = computed[i];
  }

  // The file's own normal of a corner, if it has a usable one.
  bool given_normal(std::uint32_t corner, glm::vec3& normal) {
    const std::int32_t index = data_.corners[corner].normal;
    if (index < 0) return false;
    const glm::dvec3 given(data_.normals[std::size_t(index)]);
    const double length = glm::length(given);
    if (length > 1e-12) {
      normal = glm::vec3(given / length);
      return true;
    }
    ++result_.statistics.bad_normals;
    return false;
  }

  void build() {
    std::vector<std::uint32_t> order(triangles_.size());
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
      const ObjFace &s = face(triangles_[a]), &t = face(triangles_[b]);
      return s.shape != t.shape ? s.shape < t.shape : s.material < t.material;
    });
    for (std::size_t start = 0; start < order.size();) {
      std::size_t end = start;
      const std::int32_t shape = face(triangles_[order[start]]).shape;
      while (end < order.size() && face(triangles_[order[end]]).shape == shape) ++end;
      build_mesh({order.data() + start, order.data() + end});
      start = end;
    }
  }

  void build_mesh(std::span<const std::uint32_t> order) {
    Mesh& mesh = result_.meshes.emplace_back();
    mesh.name = data_.shapes[std::size_t(face(triangles_[order[0]]).shape)];
    mesh_has_uvs_ = std::any_of(order.begin(), order.end(), [&](std::uint32_t i) {
      const auto& c = triangles_[i].corners;
      return std::any_of(c.begin(), c.end(), [&](std::uint32_t k) { return data_.corners[k].uv >= 0; });
    });
    vertex_corner_.clear();
    IndexTable vertices(3 * order.size());
    for (const std::size_t i : order) {
      const Triangle& t = triangles_[i];
      const std::int32_t material = face(t).material;
      glm::uvec3 indices;
      for (std::size_t k = 0; k < 3; ++k)
        indices[int(k)] =
            vertex(mesh, vertices, t.corners[k], uvs_.at(t.corners[k], t.face), normals_[3 * i + k]);
      if (mesh.parts.empty() || mesh.parts.back().material != material)
        mesh.parts.push_back({material, std::uint32_t(mesh.triangles.size()), 0});
      mesh.triangles.push_back(indices);
      ++mesh.parts.back().triangle_count;
    }
  }

  // The mesh's vertex for a corner.
  std::uint32_t vertex(Mesh& mesh, IndexTable& vertices, std::uint32_t corner, const glm::vec2& uv,
                       const glm::vec3& normal) {
    const ObjCorner& c = data_.corners[corner];
    const auto is_same = [&](std::uint32_t i) {
      const ObjCorner& other = data_.corners[vertex_corner_[i]];
      return other.position == c.position && other.uv == c.uv && mesh.normals[i] == normal &&
             (!mesh_has_uvs_ || mesh.uvs[i] == uv);
    };
    std::uint64_t hash = mix_hash(mix_hash(0, std::uint32_t(c.position)), std::uint32_t(c.uv));
    // -0 is 0. Where a face is moved to another repeat of its texture, corners with one uv differ in it.
    for (const float x : {normal.x, normal.y, normal.z, mesh_has_uvs_ ? uv.x : 0, mesh_has_uvs_ ? uv.y : 0})
      hash = mix_hash(hash, std::bit_cast<std::uint32_t>(x + 0.0f));
    const auto next = std::uint32_t(mesh.positions.size());
    const std::uint32_t index = vertices.find_or_insert(hash, next, is_same);
    if (index != next) return index;
    const auto position = std::size_t(c.position);
    mesh.positions.push_back(positions_[position]);
    mesh.normals.push_back(normal);
    if (mesh_has_uvs_) mesh.uvs.push_back(uv);
    if (!data_.colors.empty()) mesh.colors.push_back(data_.colors[position]);
    vertex_corner_.push_back(corner);
    return index;
  }

  const ObjData& data_;
  const MeshOptions& options_;
  const glm::dvec3 origin_;
  const std::vector<glm::vec3> positions_;
  const WeldedPoints welded_;
  const PlacedUvs uvs_;
  BuiltMeshes result_;
  std::vector<glm::vec3> polygon_;  // of the face being cut
  std::vector<glm::uvec3> cut_;
  ClippingBudget budget_;
  std::vector<Triangle> triangles_;
  std::vector<glm::vec3> normals_;            // three a triangle
  std::vector<std::uint32_t> vertex_corner_;  // the first corner that needed a vertex of the mesh being built
  bool mesh_has_uvs_ = false;
};

}  // namespace

BuiltMeshes build_meshes(const ObjData& data, const MeshOptions& options) {
  return MeshBuilder(data, options).run();
}

}  // namespace lightbench
