#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include <glm/geometric.hpp>
#include <rapidcheck.h>

#include "renderer/radiance/chart_atlas.h"
#include "scene/scene.h"

/// Meshes that charts are cut from, and what must hold for every atlas.
namespace lightbench {

/// Flat, of one part; normals are those of the first triangle that uses a vertex.
inline Mesh mesh_of(std::vector<glm::vec3> positions, std::vector<glm::uvec3> triangles) {
  Mesh mesh;
  mesh.positions = std::move(positions);
  mesh.triangles = std::move(triangles);
  mesh.normals.assign(mesh.positions.size(), glm::vec3(0));
  for (const glm::uvec3& t : mesh.triangles) {
    const glm::vec3 normal =
        glm::cross(mesh.positions[t.y] - mesh.positions[t.x], mesh.positions[t.z] - mesh.positions[t.x]);
    for (int i = 0; i < 3; ++i)
      if (mesh.normals[t[i]] == glm::vec3(0))
        mesh.normals[t[i]] = glm::length(normal) > 0 ? glm::normalize(normal) : glm::vec3(0, 1, 0);
  }
  mesh.parts = {{0, 0, std::uint32_t(mesh.triangles.size())}};
  return mesh;
}

/// origin, + u, + u + v, + v.
inline Mesh quad_mesh(const glm::vec3& origin, const glm::vec3& u, const glm::vec3& v) {
  return mesh_of({origin, origin + u, origin + u + v, origin + v}, {{0, 1, 2}, {0, 2, 3}});
}

inline void append(Mesh& mesh, const Mesh& other) {
  const std::uint32_t first = std::uint32_t(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), other.positions.begin(), other.positions.end());
  mesh.normals.insert(mesh.normals.end(), other.normals.begin(), other.normals.end());
  mesh.uvs.insert(mesh.uvs.end(), other.uvs.begin(), other.uvs.end());
  for (const glm::uvec3& t : other.triangles) mesh.triangles.push_back(t + first);
  mesh.parts = {{0, 0, std::uint32_t(mesh.triangles.size())}};
}

/// From (0, 0, 0) to (1, 1, 1).
inline Mesh cube_mesh() {
  const glm::vec3 x(1, 0, 0), y(0, 1, 0), z(0, 0, 1), one(1);
  Mesh mesh = quad_mesh({0, 0, 0}, x, y);
  append(mesh, quad_mesh({0, 0, 0}, y, z));
  append(mesh, quad_mesh({0, 0, 0}, z, x));
  append(mesh, quad_mesh(one, -x, -y));
  append(mesh, quad_mesh(one, -y, -z));
  append(mesh, quad_mesh(one, -z, -x));
  return mesh;
}

/// Of unit radius, with smooth normals, in rings from pole to pole.
inline Mesh sphere_mesh(int rings, int segments) {
  Mesh mesh;
  for (int i = 0; i <= rings; ++i)
    for (int j = 0; j <= segments; ++j) {
      const float theta = std::numbers::pi_v<float> * float(i) / float(rings);
      const float phi = 2 * std::numbers::pi_v<float> * float(j % segments) / float(segments);
      mesh.positions.emplace_back(std::sin(theta) * std::cos(phi), std::cos(theta),
                                  std::sin(theta) * std::sin(phi));
      mesh.uvs.emplace_back(float(j) / float(segments), 1 - float(i) / float(rings));
    }
  mesh.normals = mesh.positions;
  const auto at = [&](int i, int j) { return std::uint32_t(i * (segments + 1) + j); };
  for (int i = 0; i < rings; ++i)
    for (int j = 0; j < segments; ++j) {
      if (i > 0) mesh.triangles.emplace_back(at(i, j), at(i, j + 1), at(i + 1, j));
      if (i + 1 < rings) mesh.triangles.emplace_back(at(i, j + 1), at(i + 1, j + 1), at(i + 1, j));
    }
  mesh.parts = {{0, 0, std::uint32_t(mesh.triangles.size())}};
  return mesh;
}

inline glm::dvec2 texel_coordinate(const ChartAtlas& atlas, std::size_t triangle, const glm::dvec2& b) {
  const auto& c = atlas.coordinates[triangle];
  return (1 - b.x - b.y) * glm::dvec2(c[0]) + b.x * glm::dvec2(c[1]) + b.y * glm::dvec2(c[2]);
}

inline glm::dvec3 surface_point(const Mesh& mesh, std::size_t triangle, const glm::dvec2& b) {
  const glm::uvec3& t = mesh.triangles[triangle];
  return (1 - b.x - b.y) * glm::dvec3(mesh.positions[t.x]) + b.x * glm::dvec3(mesh.positions[t.y]) +
         b.y * glm::dvec3(mesh.positions[t.z]);
}

/// What a texture of an atlas holds.
class FilledAtlas {
 public:
  static constexpr std::uint32_t kEmpty = 0xfffffffe;

  /// `value` is a function of triangle and barycentrics.
  template <typename Function>
  FilledAtlas(const ChartAtlas& atlas, const Function& value)
      : width_(atlas.width),
        values_(std::size_t(atlas.width) * std::size_t(atlas.height)),
        charts_(values_.size(), kEmpty) {
    std::vector<double> surface;
    for (const SurfaceTexel& texel : atlas.surface) {
      surface.push_back(value(texel.triangle, glm::dvec2(texel.beta, texel.gamma)));
      put(texel.place, surface.back(), atlas.charts[texel.triangle]);
    }
    const std::vector<double> gutters = gutter_values(atlas, surface);
    for (std::size_t i = 0; i < gutters.size(); ++i) {
      const std::uint32_t chart = atlas.charts[atlas.surface[atlas.gutters[i].a].triangle];
      put(atlas.gutters[i].place, gutters[i], chart);
    }
  }

  bool is_clean() const { return clean_; }  ///< no texel is listed twice

  /// Whether all texels with a weight are the chart's.
  bool holds(const glm::dvec2& point, std::uint32_t chart) const {
    bool all = true;
    visit(point, [&](std::size_t i, double) { all = all && charts_[i] == chart; });
    return all;
  }

  double lookup(const glm::dvec2& point) const {
    double sum = 0;
    visit(point, [&](std::size_t i, double weight) { sum += weight * values_[i]; });
    return sum;
  }

 private:
  std::size_t index(const glm::ivec2& p) const {
    return std::size_t(p.y) * std::size_t(width_) + std::size_t(p.x);
  }

  void put(const glm::ivec2& place, double value, std::uint32_t chart) {
    clean_ = clean_ && charts_[index(place)] == kEmpty;
    values_[index(place)] = value;
    charts_[index(place)] = chart;
  }

  template <typename Visitor>
  void visit(const glm::dvec2& point, const Visitor& visitor) const {
    constexpr double kWeight = 1e-5;  // below it is rounding of coordinates on a border
    const glm::dvec2 base = glm::floor(point - 0.5), part = point - 0.5 - base;
    for (int y = 0; y < 2; ++y)
      for (int x = 0; x < 2; ++x)
        if (const double weight = (x ? part.x : 1 - part.x) * (y ? part.y : 1 - part.y); weight > kWeight)
          visitor(index(glm::ivec2(base) + glm::ivec2(x, y)), weight);
  }

  int width_;
  std::vector<double> values_;
  std::vector<std::uint32_t> charts_;
  bool clean_ = true;
};

/// Inside a triangle.
inline glm::dvec2 arbitrary_barycentrics() {
  const auto part = [] { return double(*rc::gen::inRange(1, 1000)) / 1000; };
  const glm::dvec2 b(part(), part());
  return b.x + b.y < 1 ? b : 1.0 - b;
}

}  // namespace lightbench
