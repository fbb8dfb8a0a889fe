#pragma once

#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "scene/scene.h"

namespace lightbench {

/// A point on an emitting triangle.
struct EmitterPoint {
  glm::vec3 position;
  glm::vec3 normal;           ///< geometric, unit, on either side: both emit
  glm::vec3 modelled_normal;  ///< of shading, of any length, to whichever side it points
  glm::vec3 emission;
};

/// The triangles that emit light (Ke), to pick points of them by chance. A point's density per unit of area
/// is in proportion to the largest component of its emission.
class Emitters {
 public:
  explicit Emitters(const Scene& scene);

  bool empty() const { return triangles_.empty(); }
  /// The density per unit of area where this is the largest component of the emission: the same factor for
  /// floats and vectors of them.
  template <typename Value>
  Value density(Value largest_component) const {
    return largest_component * per_emission_;
  }
  /// All arguments 0..1. The emission is 0 in the hole of a cut-out.
  EmitterPoint sample(float pick, float u, float v) const;

 private:
  struct Triangle {
    glm::vec3 corner, edge_u, edge_v, normal;
    glm::mat3 modelled_normals;  ///< of the corners
    const Mesh* mesh;
    glm::uvec3 vertices;
    const Material* material;
  };
  void add(const Entity& entity, const Mesh& mesh, const MeshPart& part, const Material& material);

  const Scene& scene_;
  std::vector<Triangle> triangles_;
  float per_emission_ = 0;          ///< 1 over the last of cumulative_
  std::vector<double> cumulative_;  ///< of area * largest component, up to and with each triangle
};

}  // namespace lightbench
