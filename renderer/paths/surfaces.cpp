#include "renderer/paths/surfaces.h"

#include <cmath>
#include <limits>
#include <map>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "base/color.h"

namespace lightbench {
namespace {

// Units in the last place of the largest coordinate that a position on a surface may be off.
constexpr float kOffsetUlps = 32;

template <typename Value>
Value interpolate(const Value& a, const Value& b, const Value& c, float u, float v) {
  return (1 - u - v) * a + u * b + v * c;
}

PathMaterial path_material(const Scene& scene, const Material& material) {
  const Image8* texture = material.diffuse_texture == kNoTexture
                              ? nullptr
                              : &scene.textures[std::size_t(material.diffuse_texture)].pixels;
  if (texture && texture->empty()) texture = nullptr;
  return {material.diffuse,     material.specular, material.exponent,
          material.reflectance, material.emission, texture};
}

float repeated(float coordinate) {
  const float fraction = coordinate - std::floor(coordinate);
  return fraction >= 0 ? fraction : 0;  // NaN too
}

/// Two texels along an axis and how far the place is from the first one's centre to the second's.
struct TexelPair {
  int first, second;
  float share;
};
TexelPair texel_pair(float coordinate, int size) {
  const float place = repeated(coordinate) * float(size) - 0.5f;
  const float before = std::floor(place);
  const int first = int(before);
  return {first < 0 ? size - 1 : first, first + 1 < size ? first + 1 : 0, place - before};
}

}  // namespace

SurfaceTable::SurfaceTable(const Scene& scene, const EmbreeScene& embree) {
  for (const Material& material : scene.materials) materials_.push_back(path_material(scene, material));
  for (std::size_t i = 0; i < linear_.size(); ++i) linear_[i] = srgb_decode8(std::uint8_t(i));
  std::map<const TriangleSet*, std::size_t> shared;  // first sets of instanced meshes
  for (const PlacedGeometry& placed : embree.placed()) {
    const glm::mat3 normal_matrix =
        glm::mat3(glm::transpose(glm::inverse(glm::dmat3(glm::mat3(placed.entity->transform)))));
    const auto [known, added] = shared.try_emplace(placed.sets.data(), first_triangle_.size());
    places_.push_back({known->second, placed.instanced, normal_matrix});
    if (!added) continue;
    for (const TriangleSet& set : placed.sets) add_set(set, placed.instanced ? glm::mat3(1) : normal_matrix);
  }
}

void SurfaceTable::add_set(const TriangleSet& set, const glm::mat3& normal_matrix) {
  const Mesh& mesh = *set.mesh;
  first_triangle_.push_back(triangles_.size());
  colored_.push_back(mesh.colors.empty() ? nullptr : &set);
  for (std::size_t i = 0; i < set.triangles.size(); ++i) {
    const glm::uvec3& t = mesh.triangles[set.triangles[i]];
    Triangle& triangle = triangles_.emplace_back();
    triangle.material = set.materials[i];
    for (int corner = 0; corner < 3; ++corner) {
      triangle.normals[std::size_t(corner)] = normal_matrix * mesh.normals[t[corner]];
      triangle.uvs[std::size_t(corner)] = mesh.uvs.empty() ? glm::vec2(0) : mesh.uvs[t[corner]];
    }
  }
}

glm::vec3 SurfaceTable::texel(const Image8& texture, glm::vec2 uv) const {
  const TexelPair x = texel_pair(uv.x, texture.width);
  const TexelPair y = texel_pair(1 - uv.y, texture.height);
  const auto at = [&](int column, int row) {
    const std::uint8_t* t =
        &texture.data[4 * (std::size_t(row) * std::size_t(texture.width) + std::size_t(column))];
    return glm::vec3(linear_[t[0]], linear_[t[1]], linear_[t[2]]);
  };
  const glm::vec3 above = (1 - x.share) * at(x.first, y.first) + x.share * at(x.second, y.first);
  const glm::vec3 below = (1 - x.share) * at(x.first, y.second) + x.share * at(x.second, y.second);
  return (1 - y.share) * above + y.share * below;
}

SurfaceTable::Found SurfaceTable::find(unsigned instance, unsigned geometry, unsigned primitive) const {
  const bool instanced = instance != RTC_INVALID_GEOMETRY_ID;
  const Place& place = places_[instanced ? instance : geometry];
  const std::size_t set = place.first_set + (instanced ? geometry : 0);
  return {place, set, triangles_[first_triangle_[set] + primitive]};
}

glm::vec3 SurfaceTable::normal(unsigned instance, unsigned geometry, unsigned primitive, float u,
                               float v) const {
  const Found found = find(instance, geometry, primitive);
  const auto& normals = found.triangle.normals;
  return found.in_world(interpolate(normals[0], normals[1], normals[2], u, v));
}

SurfacePoint SurfaceTable::point(unsigned instance, unsigned geometry, unsigned primitive, float u, float v,
                                 const glm::vec3& face) const {
  const Found found = find(instance, geometry, primitive);
  const auto& [place, set, triangle] = found;
  SurfacePoint point;
  point.material = &materials_[std::size_t(triangle.material)];
  point.normal =
      found.in_world(interpolate(triangle.normals[0], triangle.normals[1], triangle.normals[2], u, v));
  point.face = found.in_world(face);
  point.albedo = point.material->diffuse;
  if (point.material->texture)
    point.albedo *=
        texel(*point.material->texture, interpolate(triangle.uvs[0], triangle.uvs[1], triangle.uvs[2], u, v));
  if (const TriangleSet* colored = colored_[set]) {
    const auto& colors = colored->mesh->colors;
    const glm::uvec3& t = colored->mesh->triangles[colored->triangles[primitive]];
    point.albedo *= interpolate(colors[t.x], colors[t.y], colors[t.z], u, v);
  }
  return point;
}

namespace {

/// Unit length and against the ray; without a direction, the other one stands in.
Vec8 towards_origin(const Vec8& n, const Vec8& direction, const Vec8& otherwise) {
  const Float8 square = dot(n, n);
  const Vec8 unit = select(square > 0, n * (1 / sqrt8(square)), otherwise);
  return select(dot(unit, direction) > 0, -unit, unit);
}

}  // namespace

Surfaces8 SurfaceTable::shade(const RTCRayHit8& rays, Int8 mask) const {
  Surfaces8 result{};
  Vec8 normal{}, face{};
  for_lanes(mask, [&](int i) {
    const SurfacePoint p = point(rays.hit.instID[0][i], rays.hit.geomID[i], rays.hit.primID[i], rays.hit.u[i],
                                 rays.hit.v[i], {rays.hit.Ng_x[i], rays.hit.Ng_y[i], rays.hit.Ng_z[i]});
    normal.set_lane(i, p.normal);
    face.set_lane(i, p.face);
    result.albedo.set_lane(i, p.albedo);
    result.emission.set_lane(i, p.material->emission);
    result.specular[i] = p.material->specular;
    result.exponent[i] = p.material->exponent;
    result.reflectance[i] = p.material->reflectance;
  });
  const Vec8 origin = load_vec8(rays.ray.org_x, rays.ray.org_y, rays.ray.org_z);
  const Vec8 direction = load_vec8(rays.ray.dir_x, rays.ray.dir_y, rays.ray.dir_z);
  result.modelled_normal = normal;
  face = towards_origin(face, direction, -direction);
  result.normal = towards_origin(normal, direction, face);
  result.facing = -dot(face, direction);
  result.position = origin + direction * load8(rays.ray.tfar);
  const Float8 magnitude = max8(largest(abs8(origin)), largest(abs8(result.position)));
  result.offset = face * (magnitude * (kOffsetUlps * std::numeric_limits<float>::epsilon()));
  return result;
}

}  // namespace lightbench
