#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <glm/mat3x3.hpp>

#include "renderer/embree_scene.h"
#include "renderer/paths/lanes.h"

namespace lightbench {

/// A material as paths need it.
struct PathMaterial {
  glm::vec3 diffuse;
  float specular;
  float exponent;
  float reflectance;
  glm::vec3 emission;
  const Image8* texture;  ///< or null
};

/// What a ray met, eight at a time; lanes that met nothing hold nothing of use.
struct Surfaces8 {
  Vec8 position;
  Vec8 normal;  ///< of shading, unit, towards the ray's origin
  Vec8 offset;  ///< along the geometric normal, towards the ray's origin: as far as rounding may have moved
                ///< the position off the surface
  Vec8 modelled_normal;  ///< of shading, of any length, to whichever side it points
  Float8 facing;         ///< cosine between the ray and the geometric normal, > 0
  Vec8 albedo;
  Vec8 emission;
  Float8 specular;
  Float8 exponent;
  Float8 reflectance;
};

/// What one point of a triangle looks like.
struct SurfacePoint {
  glm::vec3 normal;  ///< interpolated, in world space, of any length
  glm::vec3 face;    ///< the same of the triangle
  glm::vec3 albedo;
  const PathMaterial* material;
};

/// Normals, colours and materials of all triangles, packed by what a hit names.
class SurfaceTable {
 public:
  SurfaceTable(const Scene& scene, const EmbreeScene& embree);

  SurfacePoint point(unsigned instance, unsigned geometry, unsigned primitive, float u, float v,
                     const glm::vec3& face) const;
  /// The same point's normal alone.
  glm::vec3 normal(unsigned instance, unsigned geometry, unsigned primitive, float u, float v) const;
  /// The surfaces that a packet of rays hit, in the lanes of the mask.
  Surfaces8 shade(const RTCRayHit8& rays, Int8 mask) const;

  const std::vector<PathMaterial>& materials() const { return materials_; }

 private:
  /// One cache line for each triangle.
  struct alignas(64) Triangle {
    std::array<glm::vec3, 3> normals;
    std::array<glm::vec2, 3> uvs;
    std::int32_t material;
  };
  struct Place {
    std::size_t first_set;  ///< in first_triangle_ and colored_
    bool instanced;         ///< and so its normals are still in its own space
    glm::mat3 normal_matrix;
  };
  /// What a hit's numbers stand for.
  struct Found {
    const Place& place;
    std::size_t set;
    const Triangle& triangle;
    glm::vec3 in_world(const glm::vec3& normal) const {
      return place.instanced ? place.normal_matrix * normal : normal;
    }
  };
  Found find(unsigned instance, unsigned geometry, unsigned primitive) const;
  void add_set(const TriangleSet& set, const glm::mat3& normal_matrix);
  glm::vec3 texel(const Image8& texture, glm::vec2 uv) const;

  std::vector<PathMaterial> materials_;
  std::vector<Triangle> triangles_;
  std::vector<std::size_t> first_triangle_;  ///< by set
  std::vector<const TriangleSet*> colored_;  ///< by set: with vertex colours, else null
  std::vector<Place> places_;                ///< by geometry number of the top scene
  std::array<float, 256> linear_;            ///< of 8-bit sRGB
};

}  // namespace lightbench
