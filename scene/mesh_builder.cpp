#include "scene/mesh_builder.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <numeric>

#include <glm/geometric.hpp>

#include "scene/smooth_normals.h"
#include "scene/triangulate.h"

namespace lightbench {
namespace {

// A triangle whose height is below this share of its longest side has no normal worth the name in 32-bit
// floats.
constexpr double kSmallestHeight = 1e-6;

constexpr std::uint32_t kNone = ~0u;

std::uint64_t mix(std::uint64_t hash, std::uint32_t value) {
  hash = (hash ^ value) * 0x9E3779B97F4A7C15ull;
  return hash ^ (hash >> 29);
}

// A hash table from keys that the caller keeps to 32-bit values: open addressing, no removal.
class IndexTable {
 public:
  explicit IndexTable(std::size_t capacity) : slots_(std::bit_ceil(2 * capacity + 2), kNone) {}

  // The stored index for which `equal` holds, or `index`, which is then stored.
  template <typename Equal>
  std::uint32_t find_or_insert(std::uint64_t hash, std::uint32_t index, Equal equal) {
    std::size_t slot = std::size_t(hash) & (slots_.size() - 1);
    while (slots_[slot] != kNone) {
      if (equal(slots_[slot])) return slots_[slot];
      slot = (slot + 1) & (slots_.size() - 1);
    }
    return slots_[slot] = index;
  }

 private:
  std::vector<std::uint32_t> slots_;
};

// Positions that are equal get the same number; `points` holds each once.
struct Welded {
  std::vector<glm::vec3> points;
  std::vector<std::uint32_t> point_of_position;
};

Welded weld(const std::vector<glm::vec3>& positions) {
  Welded result;
  result.point_of_position.reserve(positions.size());
  IndexTable table(positions.size());
  for (const glm::vec3& p : positions) {
    const glm::vec3 q = p + 0.0f;  // -0 becomes 0
    std::uint64_t hash = 0;
    for (int k = 0; k < 3; ++k) hash = mix(hash, std::bit_cast<std::uint32_t>(q[k]));
    const auto next = std::uint32_t(result.points.size());
    const std::uint32_t point =
        table.find_or_insert(hash, next, [&](std::uint32_t i) { return result.points[i] == q; });
    if (point == next) result.points.push_back(q);
    result.point_of_position.push_back(point);
  }
  return result;
}

struct Triangle {
  std::array<std::uint32_t, 3> corners;  // into ObjData::corners
  std::int32_t material;
  std::int32_t shape;
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
      : data_(data), options_(options), welded_(weld(data.positions)) {}

  BuiltMeshes run() {
    cut_faces();
    drop_duplicates();
    compute_normals();
    build();
    return std::move(result_);
  }

 private:
  std::uint32_t point(std::uint32_t corner) const {
    return welded_.point_of_position[std::size_t(data_.corners[corner].position)];
  }

  void cut_faces() {
    std::vector<glm::vec3> polygon;
    std::vector<glm::uvec3> cut;
    triangles_.reserve(data_.faces.size());
    for (const ObjFace& face : data_.faces) {
      polygon.clear();
      cut.clear();
      for (std::uint32_t i = 0; i < face.corner_count; ++i)
        polygon.push_back(welded_.points[point(face.first_corner + i)]);
      triangulate(polygon, cut);
      for (const glm::uvec3& t : cut) {
        if (is_degenerate(polygon[t.x], polygon[t.y], polygon[t.z]))
          ++result_.statistics.degenerate_triangles;
        else
          triangles_.push_back({{face.first_corner + t.x, face.first_corner + t.y, face.first_corner + t.z},
                                face.material,
                                face.shape});
      }
    }
  }

  std::array<std::uint32_t, 3> sorted_points(const Triangle& t) const {
    std::array<std::uint32_t, 3> points{point(t.corners[0]), point(t.corners[1]), point(t.corners[2])};
    std::sort(points.begin(), points.end());
    return points;
  }

  bool has_cutout(const Triangle& t) const {
    return t.material >= 0 && options_.material_has_cutout[std::size_t(t.material)];
  }

  bool same_place(const Triangle& a, const Triangle& b) const {
    const bool may_show_both = a.material != b.material && (has_cutout(a) || has_cutout(b));
    return !may_show_both && sorted_points(a) == sorted_points(b);
  }

  void drop_duplicates() {
    IndexTable table(triangles_.size());
    std::uint32_t kept = 0;
    for (const Triangle& t : triangles_) {
      std::uint64_t hash = 0;
      for (const std::uint32_t p : sorted_points(t)) hash = mix(hash, p);
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
    std::vector<bool> wanted(3 * triangles_.size());
    normals_.resize(wanted.size());
    std::vector<glm::uvec3> points(triangles_.size());
    for (std::size_t i = 0; i < triangles_.size(); ++i)
      for (std::size_t k = 0; k < 3; ++k) {
        points[i][int(k)] = point(triangles_[i].corners[k]);
        wanted[3 * i + k] = !given_normal(triangles_[i].corners[k], normals_[3 * i + k]);
      }
    if (std::find(wanted.begin(), wanted.end(), true) == wanted.end()) return;
    const auto computed = smooth_normals(welded_.points, points, options_.crease_angle, wanted);
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
      const Triangle &s = triangles_[a], &t = triangles_[b];
      return s.shape != t.shape ? s.shape < t.shape : s.material < t.material;
    });
    vertex_head_.assign(data_.positions.size(), kNone);
    for (std::size_t start = 0; start < order.size();) {
      std::size_t end = start;
      while (end < order.size() && triangles_[order[end]].shape == triangles_[order[start]].shape) ++end;
      build_mesh({order.data() + start, order.data() + end});
      start = end;
    }
  }

  void build_mesh(std::span<const std::uint32_t> order) {
    Mesh& mesh = result_.meshes.emplace_back();
    mesh.name = data_.shapes[std::size_t(triangles_[order[0]].shape)];
    mesh_has_uvs_ = std::any_of(order.begin(), order.end(), [&](std::uint32_t i) {
      const auto& c = triangles_[i].corners;
      return std::any_of(c.begin(), c.end(), [&](std::uint32_t k) { return data_.corners[k].uv >= 0; });
    });
    vertex_corner_.clear();
    vertex_next_.clear();
    for (const std::size_t i : order) {
      const Triangle& t = triangles_[i];
      glm::uvec3 indices;
      for (std::size_t k = 0; k < 3; ++k) indices[int(k)] = vertex(mesh, t.corners[k], normals_[3 * i + k]);
      if (mesh.parts.empty() || mesh.parts.back().material != t.material)
        mesh.parts.push_back({t.material, std::uint32_t(mesh.triangles.size()), 0});
      mesh.triangles.push_back(indices);
      ++mesh.parts.back().triangle_count;
    }
    for (const std::uint32_t corner : vertex_corner_)
      vertex_head_[std::size_t(data_.corners[corner].position)] = kNone;
  }

  // The mesh's vertex for a corner: vertices of one position form a chain.
  std::uint32_t vertex(Mesh& mesh, std::uint32_t corner, const glm::vec3& normal) {
    const ObjCorner& c = data_.corners[corner];
    const auto position = std::size_t(c.position);
    for (std::uint32_t i = vertex_head_[position]; i != kNone; i = vertex_next_[i])
      if (data_.corners[vertex_corner_[i]].uv == c.uv && mesh.normals[i] == normal) return i;
    const auto index = std::uint32_t(mesh.positions.size());
    mesh.positions.push_back(data_.positions[position]);
    mesh.normals.push_back(normal);
    if (mesh_has_uvs_) mesh.uvs.push_back(c.uv >= 0 ? data_.uvs[std::size_t(c.uv)] : glm::vec2(0));
    if (!data_.colors.empty()) mesh.colors.push_back(data_.colors[position]);
    vertex_corner_.push_back(corner);
    vertex_next_.push_back(vertex_head_[position]);
    vertex_head_[position] = index;
    return index;
  }

  const ObjData& data_;
  const MeshOptions& options_;
  const Welded welded_;
  BuiltMeshes result_;
  std::vector<Triangle> triangles_;
  std::vector<glm::vec3> normals_;            // three a triangle
  std::vector<std::uint32_t> vertex_head_;    // of each position, in the mesh being built
  std::vector<std::uint32_t> vertex_next_;    // of each vertex
  std::vector<std::uint32_t> vertex_corner_;  // the first corner that needed the vertex
  bool mesh_has_uvs_ = false;
};

}  // namespace

BuiltMeshes build_meshes(const ObjData& data, const MeshOptions& options) {
  return MeshBuilder(data, options).run();
}

}  // namespace lightbench
