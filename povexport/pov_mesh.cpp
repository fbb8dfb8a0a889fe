#include "povexport/pov_mesh.h"

#include <array>
#include <cstring>
#include <unordered_map>

#include <glm/geometric.hpp>

namespace lightbench {
namespace {

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

 private:
  struct Hash {
    std::size_t operator()(const Vector& v) const {
      std::size_t hash = 0;
      for (int i = 0; i < Vector::length(); ++i)
        hash = (hash ^ std::hash<float>()(v[i])) * 0x9E3779B97F4A7C15u;
      return hash ^ (hash >> 29);
    }
  };
  std::unordered_map<Vector, std::uint32_t, Hash> index_;
  std::vector<Vector> vectors_;
};

struct Face {
  glm::uvec3 positions;
  glm::uvec3 normals;
  glm::uvec3 uvs;
  std::array<int, 3> textures;  ///< numbers of declarations
};

/// The lists of one mesh2.
class MeshLists {
 public:
  MeshLists(const Mesh& mesh, float scale, PovMaterials& materials, bool smooth)
      : mesh_(mesh), scale_(scale), materials_(materials), smooth_(smooth) {}

  void add(const glm::uvec3& triangle, int material) {
    Face face{};
    const bool textured = materials_.uses_uv(material);
    uses_uv_ |= textured;
    for (int i = 0; i < 3; ++i) {
      const std::size_t vertex = triangle[i];
      face.positions[i] = positions_.index(scale_ * mesh_.positions[vertex]);
      if (smooth_) face.normals[i] = normals_.index(mesh_.normals[vertex]);
      face.uvs[i] = uvs_.index(textured && !mesh_.uvs.empty() ? mesh_.uvs[vertex] : glm::vec2(0));
      face.textures[std::size_t(i)] = mesh_.colors.empty()
                                          ? materials_.texture(material)
                                          : materials_.texture(material, mesh_.colors[vertex]);
    }
    faces_.push_back(face);
  }

  bool empty() const { return faces_.empty(); }
  void write(PovWriter& out) const;

 private:
  void write_faces(PovWriter& out, const std::unordered_map<int, int>& texture_index) const;
  void write_indices(PovWriter& out, PovWriter::Words keyword, glm::uvec3 Face::*indices) const;

  const Mesh& mesh_;
  float scale_;
  PovMaterials& materials_;
  bool smooth_;
  bool uses_uv_ = false;
  VectorTable<glm::vec3> positions_;
  VectorTable<glm::vec3> normals_;
  VectorTable<glm::vec2> uvs_;
  std::vector<Face> faces_;
};

template <typename Vector>
void write_vectors(PovWriter& out, PovWriter::Words keyword, const std::vector<Vector>& vectors) {
  out.words(keyword).words("{").integer(static_cast<long long>(vectors.size())).words("\n");
  for (const Vector& v : vectors) out.vector(v).words("\n");
  out.words("}\n");
}

/// A list that equals the face list is left out: the face list then stands for it.
void MeshLists::write_indices(PovWriter& out, PovWriter::Words keyword, glm::uvec3 Face::*indices) const {
  bool same = true;
  for (const Face& face : faces_) same = same && face.*indices == face.positions;
  if (same) return;
  out.words(keyword).words("{").integer(static_cast<long long>(faces_.size())).words("\n");
  for (const Face& face : faces_) out.triple(face.*indices).words("\n");
  out.words("}\n");
}

void MeshLists::write_faces(PovWriter& out, const std::unordered_map<int, int>& texture_index) const {
  out.words("face_indices{").integer(static_cast<long long>(faces_.size())).words("\n");
  for (const Face& face : faces_) {
    const auto& t = face.textures;
    out.triple(face.positions).words(",").integer(texture_index.at(t[0]));
    if (t[0] != t[1] || t[1] != t[2])
      out.words(",").integer(texture_index.at(t[1])).words(",").integer(texture_index.at(t[2]));
    out.words("\n");
  }
  out.words("}\n");
}

void MeshLists::write(PovWriter& out) const {
  std::unordered_map<int, int> texture_index;
  std::vector<int> textures;
  for (const Face& face : faces_)
    for (const int texture : face.textures)
      if (texture_index.try_emplace(texture, int(textures.size())).second) textures.push_back(texture);

  out.words("mesh2{\n");
  write_vectors(out, "vertex_vectors", positions_.vectors());
  if (smooth_) write_vectors(out, "normal_vectors", normals_.vectors());
  if (uses_uv_) write_vectors(out, "uv_vectors", uvs_.vectors());
  out.words("texture_list{").integer(static_cast<long long>(textures.size())).words("\n");
  for (const int texture : textures) out.name("texture{T", texture).words("}\n");
  out.words("}\n");
  write_faces(out, texture_index);
  if (smooth_) write_indices(out, "normal_indices", &Face::normals);
  if (uses_uv_) write_indices(out, "uv_indices", &Face::uvs);
  out.words("}\n");
}

/// Whether interpolating the vertex normals gives the face normal everywhere, on either side.
bool is_flat(const Mesh& mesh, const glm::uvec3& triangle) {
  const glm::vec3& a = mesh.positions[triangle.x];
  const glm::vec3 face = glm::cross(mesh.positions[triangle.y] - a, mesh.positions[triangle.z] - a);
  const float length = glm::length(face);
  if (!(length > 0)) return false;
  for (int i = 0; i < 3; ++i) {
    constexpr float kTolerance = 1e-4f;  // radians; far below what an 8-bit image can show
    const glm::vec3& n = mesh.normals[triangle[i]];
    if (glm::length(glm::cross(n, face / length)) > kTolerance) return false;
    if (glm::dot(n, mesh.normals[triangle.x]) < 0) return false;
  }
  return true;
}

}  // namespace

PovWriter pov_mesh(const Mesh& mesh, float scale, PovMaterials& materials) {
  MeshLists flat(mesh, scale, materials, false);
  MeshLists smooth(mesh, scale, materials, true);
  for (const MeshPart& part : mesh.parts)
    for (std::uint32_t i = 0; i < part.triangle_count; ++i) {
      const glm::uvec3& triangle = mesh.triangles[part.first_triangle + i];
      (is_flat(mesh, triangle) ? flat : smooth).add(triangle, part.material);
    }
  PovWriter out;
  if (flat.empty() && smooth.empty()) return out;
  out.words("union{\n");
  if (!flat.empty()) flat.write(out);
  if (!smooth.empty()) smooth.write(out);
  out.words("}\n");
  return out;
}

}  // namespace lightbench
