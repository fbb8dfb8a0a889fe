#include "povexport/pov_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace lightbench {
namespace {

/// Digits beyond these cannot be seen and take time to read: a hundred-thousandth of a unit normal, and of a
/// position about a ten-millionth of the mesh, a ten-thousandth where a scene is 1024 large.
constexpr double kNormalStep = 1e-5;
constexpr double kPositionStep = 1e-7;

/// A power of ten near kPositionStep of the mesh; 0 for a mesh without extent.
double position_step(const Mesh& mesh, float scale) {
  Bounds bounds;
  for (const glm::vec3& position : mesh.positions) bounds.add(scale * position);
  const double size = bounds.diagonal();
  return size > 0 && std::isfinite(size) ? kPositionStep * std::pow(10.0, std::floor(std::log10(size))) : 0;
}

glm::vec3 rounded(const glm::vec3& v, double step) {
  return step > 0 ? glm::vec3(glm::round(glm::dvec3(v) / step) * step) : v;
}

/// Distinct vectors in the order of their first use.
template <typename Vector>
class VectorTable {
 public:
  std::uint32_t index(const Vector& v) {
    const auto [entry, added] = index_.try_emplace(v, std::uint32_t(vectors_.size()));
    if (added) vectors_.push_back(v);
    return entry->second;
  }
  const std::vector<Vector>& vectors() const { return vectors_; }
  std::size_t size() const { return vectors_.size(); }

 private:
  struct Hash {
    std::size_t operator()(const Vector& v) const {
      std::size_t hash = 0;
      for (int i = 0; i < Vector::length(); ++i)
        hash = (hash ^ std::hash<typename Vector::value_type>()(v[i])) * 0x9E3779B97F4A7C15u;
      return hash ^ (hash >> 29);
    }
  };
  std::unordered_map<Vector, std::uint32_t, Hash> index_;
  std::vector<Vector> vectors_;
};

struct Face {
  glm::uvec3 corners;           ///< into the table of corners
  std::array<int, 3> textures;  ///< numbers of declarations
};

/// The lists of one mesh2. The fewer numbers they have, the sooner POV-Ray has read them.
class MeshLists {
 public:
  MeshLists(const Mesh& mesh, float scale, PovMaterials& materials, bool smooth)
      : mesh_(mesh),
        scale_(scale),
        step_(position_step(mesh, scale)),
        materials_(materials),
        smooth_(smooth) {}

  void add(const glm::uvec3& triangle, int material);
  bool empty() const { return faces_.empty(); }
  void write(PovWriter& out);

 private:
  /// The components of a corner: where its position, its normal and its uv stand in their tables.
  enum List { kPosition, kNormal, kUv };

  glm::uvec3 indices(const Face& face, List list) const;
  bool has_indices_of_its_own(List list) const;
  bool is_shorter_joined() const;
  template <typename Vector>
  void write_vectors(PovWriter& out, PovWriter::Words keyword, const VectorTable<Vector>& table,
                     List list) const;
  void write_indices(PovWriter& out, PovWriter::Words keyword, List list) const;
  void write_faces(PovWriter& out) const;
  bool has_one_plain_texture() const { return textures_.size() == 1 && !uses_uv_; }

  const Mesh& mesh_;
  float scale_;
  double step_;
  PovMaterials& materials_;
  bool smooth_;
  bool uses_uv_ = false;
  bool joined_ = false;  ///< whether all vectors are listed by corner, so that one index names all of them
  VectorTable<glm::vec3> positions_;
  VectorTable<glm::vec3> normals_;
  VectorTable<glm::vec2> uvs_;
  VectorTable<glm::uvec3> corners_;
  std::vector<Face> faces_;
  std::vector<int> textures_;
  std::unordered_map<int, int> texture_index_;
};

void MeshLists::add(const glm::uvec3& triangle, int material) {
  Face face{};
  const bool textured = materials_.uses_uv(material);
  uses_uv_ |= textured;
  for (int i = 0; i < 3; ++i) {
    const std::size_t vertex = triangle[i];
    const auto position = positions_.index(rounded(scale_ * mesh_.positions[vertex], step_));
    const auto normal = smooth_ ? normals_.index(rounded(mesh_.normals[vertex], kNormalStep)) : 0;
    const auto uv = uvs_.index(textured && !mesh_.uvs.empty() ? mesh_.uvs[vertex] : glm::vec2(0));
    face.corners[i] = corners_.index({position, normal, uv});
    const int texture = mesh_.colors.empty() ? materials_.texture(material)
                                             : materials_.texture(material, mesh_.colors[vertex]);
    face.textures[std::size_t(i)] = texture;
    if (texture_index_.try_emplace(texture, int(textures_.size())).second) textures_.push_back(texture);
  }
  faces_.push_back(face);
}

glm::uvec3 MeshLists::indices(const Face& face, List list) const {
  if (joined_) return face.corners;
  const auto& corners = corners_.vectors();
  return {corners[face.corners.x][list], corners[face.corners.y][list], corners[face.corners.z][list]};
}

/// A list that equals the face list is left out: the face list then stands for it.
bool MeshLists::has_indices_of_its_own(List list) const {
  return std::any_of(faces_.begin(), faces_.end(),
                     [&](const Face& face) { return indices(face, list) != indices(face, kPosition); });
}

/// Whether it takes fewer numbers to repeat vectors than to have an index for each of them.
bool MeshLists::is_shorter_joined() const {
  std::size_t apart = 3 * positions_.size();
  std::size_t joined = 3;
  if (smooth_) {
    apart += 3 * normals_.size() + (has_indices_of_its_own(kNormal) ? 3 * faces_.size() : 0);
    joined += 3;
  }
  if (uses_uv_) {
    apart += 2 * uvs_.size() + (has_indices_of_its_own(kUv) ? 3 * faces_.size() : 0);
    joined += 2;
  }
  return joined * corners_.size() < apart;
}

template <typename Vector>
void MeshLists::write_vectors(PovWriter& out, PovWriter::Words keyword, const VectorTable<Vector>& table,
                              List list) const {
  const std::vector<Vector>& vectors = table.vectors();
  const std::size_t count = joined_ ? corners_.size() : vectors.size();
  out.words(keyword).words("{").integer(static_cast<long long>(count)).words("\n");
  for (std::size_t i = 0; i < count; ++i)
    out.vector(vectors[joined_ ? corners_.vectors()[i][list] : i]).words("\n");
  out.words("}\n");
}

void MeshLists::write_indices(PovWriter& out, PovWriter::Words keyword, List list) const {
  if (!has_indices_of_its_own(list)) return;
  out.words(keyword).words("{").integer(static_cast<long long>(faces_.size())).words("\n");
  for (const Face& face : faces_) out.triple(indices(face, list)).words("\n");
  out.words("}\n");
}

void MeshLists::write_faces(PovWriter& out) const {
  out.words("face_indices{").integer(static_cast<long long>(faces_.size())).words("\n");
  for (const Face& face : faces_) {
    out.triple(indices(face, kPosition));
    if (!has_one_plain_texture()) {
      const auto& t = face.textures;
      out.words(",").integer(texture_index_.at(t[0]));
      if (t[0] != t[1] || t[1] != t[2])
        out.words(",").integer(texture_index_.at(t[1])).words(",").integer(texture_index_.at(t[2]));
    }
    out.words("\n");
  }
  out.words("}\n");
}

void MeshLists::write(PovWriter& out) {
  joined_ = is_shorter_joined();
  out.words("mesh2{\n");
  write_vectors(out, "vertex_vectors", positions_, kPosition);
  if (smooth_) write_vectors(out, "normal_vectors", normals_, kNormal);
  if (uses_uv_) write_vectors(out, "uv_vectors", uvs_, kUv);
  if (!has_one_plain_texture()) {
    out.words("texture_list{").integer(static_cast<long long>(textures_.size())).words("\n");
    for (const int texture : textures_) out.name("texture{T", texture).words("}\n");
    out.words("}\n");
  }
  write_faces(out);
  if (smooth_) write_indices(out, "normal_indices", kNormal);
  if (uses_uv_) write_indices(out, "uv_indices", kUv);
  if (has_one_plain_texture()) out.name("texture{T", textures_.front()).words("}\n");
  out.words("}\n");
}

/// Whether interpolating the vertex normals gives the face normal everywhere, on either side.
bool is_flat(const Mesh& mesh, const glm::uvec3& triangle) {
  const glm::vec3& a = mesh.positions[triangle.x];
  const glm::vec3 face = glm::cross(mesh.positions[triangle.y] - a, mesh.positions[triangle.z] - a);
  const float length = glm::length(face);
  if (length == 0) return true;  // never seen
  for (int i = 0; i < 3; ++i) {
    constexpr float kTolerance = 1e-4f;  // radians; far below what an 8-bit image can show
    const glm::vec3& n = mesh.normals[triangle[i]];
    if (glm::length(glm::cross(n, face / length)) > kTolerance) return false;
    if (glm::dot(n, mesh.normals[triangle.x]) < 0) return false;
  }
  return true;
}

bool is_flat(const Mesh& mesh) {
  return std::all_of(mesh.triangles.begin(), mesh.triangles.end(),
                     [&](const glm::uvec3& triangle) { return is_flat(mesh, triangle); });
}

}  // namespace

PovWriter pov_mesh(const Mesh& mesh, float scale, PovMaterials& materials) {
  MeshLists lists(mesh, scale, materials, !is_flat(mesh));
  for (const MeshPart& part : mesh.parts)
    for (std::uint32_t i = 0; i < part.triangle_count; ++i)
      lists.add(mesh.triangles[part.first_triangle + i], part.material);
  PovWriter out;
  if (!lists.empty()) lists.write(out);
  return out;
}

}  // namespace lightbench
