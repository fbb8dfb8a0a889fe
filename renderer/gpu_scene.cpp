#include "renderer/gpu_scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include <fmt/format.h>
#include <glad/gl.h>
#include <glm/gtc/matrix_inverse.hpp>

#include "base/color.h"
#include "base/error.h"
#include "base/hash.h"

namespace lightbench {
namespace {

constexpr std::uint32_t kClusterTriangles = 1024;

enum Attribute : unsigned { kPosition, kNormal, kUv, kColor };

// One element of the block Materials in shaders/surface.frag.glsl, std430.
struct MaterialBlock {
  glm::vec4 diffuse_reflectance;
  glm::vec4 emission_specular;
  glm::vec4 exponent_texture;  // exponent, has a diffuse texture, unused, unused
};
static_assert(sizeof(MaterialBlock) == 48);

glm::vec3 centroid(const Mesh& mesh, std::uint32_t triangle) {
  const glm::uvec3& t = mesh.triangles[triangle];
  return (mesh.positions[t.x] + mesh.positions[t.y] + mesh.positions[t.z]) / 3.0f;
}

Bounds box_of(const Mesh& mesh, std::span<const std::uint32_t> triangles) {
  Bounds box;
  for (const std::uint32_t i : triangles)
    for (int corner = 0; corner < 3; ++corner) box.add(mesh.positions[mesh.triangles[i][corner]]);
  return box;
}

void split(const Mesh& mesh, std::span<std::uint32_t> triangles, std::uint32_t max_triangles,
           std::uint32_t first, std::vector<TriangleCluster>& clusters) {
  if (triangles.size() <= max_triangles) {
    std::sort(triangles.begin(), triangles.end());
    clusters.push_back({box_of(mesh, triangles), first * 3, std::uint32_t(triangles.size()) * 3});
    return;
  }
  const Bounds box = box_of(mesh, triangles);
  const glm::vec3 size = box.max - box.min;
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : (size.y >= size.z ? 1 : 2);
  const std::size_t half = triangles.size() / 2;
  std::nth_element(triangles.begin(), triangles.begin() + std::ptrdiff_t(half), triangles.end(),
                   [&](std::uint32_t a, std::uint32_t b) {
                     const float ca = centroid(mesh, a)[axis], cb = centroid(mesh, b)[axis];
                     return ca < cb || (ca == cb && a < b);
                   });
  split(mesh, triangles.first(half), max_triangles, first, clusters);
  split(mesh, triangles.subspan(half), max_triangles, first + std::uint32_t(half), clusters);
}

using LinearTable = std::array<std::uint16_t, 256>;

LinearTable linear_table() {
  LinearTable linear{};
  for (std::size_t i = 0; i < linear.size(); ++i)
    linear[i] = std::uint16_t(std::lround(srgb_decode8(std::uint8_t(i)) * 65535.0f));
  return linear;
}

// Row `y` of the picture; alpha is linear already.
void append_linear_row(std::vector<std::uint16_t>& texels, const Image8& pixels, int y,
                       const LinearTable& linear) {
  const std::size_t row_size = std::size_t(pixels.width) * 4;
  const auto row = std::span(pixels.data).subspan(std::size_t(y) * row_size, row_size);
  for (std::size_t i = 0; i < row.size(); ++i)
    texels.push_back(i % 4 == 3 ? std::uint16_t(row[i] * 257) : linear[row[i]]);
}

// Linear light in 16 bits: drivers may decode sRGB texels coarsely (to 1/500 in llvmpipe), and filtering is
// to be done in linear light. In strips, since copies of large textures would take gigabytes.
void upload_linear(GlTexture& texture, const Image8& pixels) {
  constexpr std::size_t kStripBytes = std::size_t{1} << 24;
  const LinearTable linear = linear_table();
  const int strip = std::max(1, int(kStripBytes / (std::size_t(pixels.width) * 4 * sizeof(std::uint16_t))));
  std::vector<std::uint16_t> texels;
  for (int first = 0; first < pixels.height; first += strip) {
    texels.clear();
    for (int row = first; row < std::min(first + strip, pixels.height); ++row)
      append_linear_row(texels, pixels, pixels.height - 1 - row, linear);
    texture.upload_rows(first, texels);
  }
}

// Index ranges to draw, neighbours joined.
class Ranges {
 public:
  void add(const TriangleCluster& cluster) {
    if (!counts_.empty() && end_ == cluster.first_index) {
      counts_.back() += GLsizei(cluster.index_count);
    } else {
      counts_.push_back(GLsizei(cluster.index_count));
      starts_.push_back(
          reinterpret_cast<const void*>(std::uintptr_t{cluster.first_index} * sizeof(std::uint32_t)));
    }
    end_ = cluster.first_index + cluster.index_count;
  }
  bool empty() const { return counts_.empty(); }
  void draw_and_clear() {
    if (!empty())
      glMultiDrawElements(GL_TRIANGLES, counts_.data(), GL_UNSIGNED_INT, starts_.data(),
                          GLsizei(counts_.size()));
    counts_.clear();
    starts_.clear();
  }

 private:
  std::vector<GLsizei> counts_;
  std::vector<const void*> starts_;
  std::uint32_t end_ = 0;
};

void add_visible(Ranges& ranges, const std::vector<TriangleCluster>& clusters,
                 const glm::dmat4& clip_from_object, FrustumCulling culling) {
  for (const TriangleCluster& cluster : clusters)
    if (culling == FrustumCulling::off || may_be_visible(cluster.box, clip_from_object)) ranges.add(cluster);
}

}  // namespace

std::vector<TriangleCluster> cluster_triangles(const Mesh& mesh, const MeshPart& part,
                                               std::uint32_t max_triangles,
                                               std::vector<std::uint32_t>& order) {
  const std::size_t start = order.size();
  order.resize(start + part.triangle_count);
  const std::span<std::uint32_t> triangles = std::span(order).subspan(start);
  std::iota(triangles.begin(), triangles.end(), part.first_triangle);
  std::vector<TriangleCluster> clusters;
  if (!triangles.empty()) split(mesh, triangles, max_triangles, std::uint32_t(start), clusters);
  return clusters;
}

GpuScene::GpuScene(const Scene& scene) {
  GLint limit = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &limit);
  for (const Texture& source : scene.textures) {
    const Image8& pixels = source.pixels;
    if (pixels.width > limit || pixels.height > limit)
      throw Error(fmt::format("a texture of {} x {} texels; OpenGL takes {} here", pixels.width,
                              pixels.height, limit),
                  source.file.string());
    textures_.emplace_back(TexelFormat::rgba16, pixels.width, pixels.height, Filter::linear, Wrap::repeat);
    upload_linear(textures_.back(), pixels);
  }
  for (const Mesh& mesh : scene.meshes) upload_mesh(scene, mesh);
  upload_materials(scene);
  place(scene);
}

void GpuScene::place(const Scene& scene) {
  std::vector<Instance> instances;
  for (const Entity& entity : scene.entities)
    instances.push_back({entity.mesh, glm::dmat4(entity.transform)});
  if (instances == instances_) return;  // the bounds of large scenes take their time
  instances_ = std::move(instances);
  entity_bounds_.clear();
  for (std::size_t i = 0; i < scene.entities.size(); ++i)
    entity_bounds_.push_back(lightbench::entity_bounds(scene, i));
  bounds_ = {};
  for (const Bounds& entity : entity_bounds_) {
    if (entity.empty()) continue;
    bounds_.add(entity.min);
    bounds_.add(entity.max);
  }
}

void GpuScene::upload_mesh(const Scene& scene, const Mesh& mesh) {
  GpuMesh& gpu = meshes_.emplace_back();
  gpu.positions = buffer_of(mesh.positions);
  gpu.normals = buffer_of(mesh.normals);
  gpu.vertices.attribute(kPosition, gpu.positions, 3);
  gpu.vertices.attribute(kNormal, gpu.normals, 3);
  if (!mesh.uvs.empty()) {
    gpu.uvs = buffer_of(mesh.uvs);
    gpu.vertices.attribute(kUv, gpu.uvs, 2);
  }
  if (!mesh.colors.empty()) {
    gpu.colors = buffer_of(mesh.colors);
    gpu.vertices.attribute(kColor, gpu.colors, 3);
  }
  std::vector<std::uint32_t> order;
  order.reserve(mesh.triangles.size());
  for (const MeshPart& part : mesh.parts) {
    const Material& material = scene.materials.at(std::size_t(part.material));
    gpu.parts.push_back({part.material, material.diffuse_texture, material.cutout_texture,
                         cluster_triangles(mesh, part, kClusterTriangles, order)});
  }
  std::vector<glm::uvec3> triangles;
  triangles.reserve(order.size());
  for (const std::uint32_t i : order) triangles.push_back(mesh.triangles[i]);
  gpu.indices = buffer_of(triangles);
  gpu.vertices.indices(gpu.indices);
}

void GpuScene::upload_materials(const Scene& scene) {
  std::vector<MaterialBlock> blocks;
  for (const Material& m : scene.materials)
    blocks.push_back({glm::vec4(m.diffuse, m.reflectance), glm::vec4(m.emission, m.specular),
                      glm::vec4(m.exponent, m.diffuse_texture != kNoTexture, 0, 0)});
  materials_ = buffer_of(blocks);
}

void GpuScene::draw_parts(const Instance& instance, const glm::dmat4& clip_from_object,
                          FrustumCulling culling, bool (*wanted)(const Part&),
                          const std::function<void(const Part&)>& prepare) const {
  const GpuMesh& mesh = meshes_[std::size_t(instance.mesh)];
  glBindVertexArray(mesh.vertices.id());
  Ranges ranges;
  for (const Part& part : mesh.parts) {
    if (!wanted(part)) continue;
    add_visible(ranges, part.clusters, clip_from_object, culling);
    if (ranges.empty() || !prepare) continue;
    prepare(part);
    ranges.draw_and_clear();
  }
  ranges.draw_and_clear();
}

void GpuScene::draw_surfaces(const Program& solid, const Program& cutout, const glm::dmat4& clip_from_world,
                             const glm::dvec3& eye, FrustumCulling culling) const {
  materials_.bind_storage(0);
  glVertexAttrib3f(kColor, 1, 1, 1);
  glVertexAttrib2f(kUv, 0, 0);
  int entity = -1;
  for (const Instance& instance : instances_) {
    ++entity;
    const glm::dmat4 clip_from_object = clip_from_world * instance.world_from_object;
    glm::dmat4 relative_from_object = instance.world_from_object;
    relative_from_object[3] -= glm::dvec4(eye, 0.0);
    for (const Program* program : {&solid, &cutout}) {
      program->use();
      program->set("entity", entity);
      program->set("clip_from_object", glm::mat4(clip_from_object));
      program->set("relative_from_object", glm::mat4(relative_from_object));
      program->set("world_from_normal",
                   glm::mat3(glm::inverseTranspose(glm::dmat3(instance.world_from_object))));
      draw_parts(instance, clip_from_object, culling, program == &solid ? is_solid : is_cut_out,
                 [&](const Part& part) {
                   program->set("material_index", part.material);
                   if (part.diffuse_texture != kNoTexture)
                     textures_[std::size_t(part.diffuse_texture)].bind(0);
                   if (part.cutout_texture != kNoTexture) textures_[std::size_t(part.cutout_texture)].bind(1);
                 });
    }
  }
}

void GpuScene::draw_casters(const Program& solid, const Program& cutout, const glm::dmat4& clip_from_world,
                            FrustumCulling culling) const {
  for (const Instance& instance : instances_) {
    const glm::dmat4 clip_from_object = clip_from_world * instance.world_from_object;
    for (const Program* program : {&solid, &cutout})
      program->set("clip_from_object", glm::mat4(clip_from_object));
    solid.use();
    draw_parts(instance, clip_from_object, culling, is_solid, {});
    cutout.use();
    draw_parts(instance, clip_from_object, culling, is_cut_out,
               [&](const Part& part) { textures_[std::size_t(part.cutout_texture)].bind(1); });
  }
}

namespace {

template <typename T>
void add_field(Hasher& hasher, std::string_view name, const std::vector<T>& values) {
  hasher.field(name,
               std::string_view(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)));
}

template <typename T>
void add_value(Hasher& hasher, std::string_view name, const T& value) {
  static_assert(std::is_trivially_copyable_v<T>);
  hasher.field(name, std::string_view(reinterpret_cast<const char*>(&value), sizeof(T)));
}

}  // namespace

std::string gpu_scene_key(const Scene& scene) {
  Hasher hasher;
  for (const Texture& texture : scene.textures) {
    hasher.field("width", std::int64_t{texture.pixels.width});
    hasher.field("height", std::int64_t{texture.pixels.height});
    add_field(hasher, "pixels", texture.pixels.data);
  }
  for (const Material& m : scene.materials) {
    add_value(hasher, "diffuse", m.diffuse);
    add_value(hasher, "emission", m.emission);
    add_value(hasher, "finish", glm::vec3(m.specular, m.exponent, m.reflectance));
    add_value(hasher, "textures", glm::ivec2(m.diffuse_texture, m.cutout_texture));
  }
  for (const Mesh& mesh : scene.meshes) {
    add_field(hasher, "positions", mesh.positions);
    add_field(hasher, "normals", mesh.normals);
    add_field(hasher, "uvs", mesh.uvs);
    add_field(hasher, "colors", mesh.colors);
    add_field(hasher, "triangles", mesh.triangles);
    for (const MeshPart& part : mesh.parts)
      add_value(hasher, "part", glm::uvec3(part.material, part.first_triangle, part.triangle_count));
  }
  return hasher.digest();
}

}  // namespace lightbench
