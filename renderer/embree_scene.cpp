#include "renderer/embree_scene.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <glm/vec4.hpp>

#include "base/error.h"
#include "scene/nearest_surface.h"

namespace lightbench {
namespace {

using Geometry = EmbreeHandle<RTCGeometry, rtcReleaseGeometry>;

int wrapped_texel(float coordinate, int size) {
  const float fraction = coordinate - std::floor(coordinate);
  return std::min(static_cast<int>(fraction * static_cast<float>(size)), size - 1);
}

void reject_cut_outs(const RTCFilterFunctionNArguments* arguments) {
  const auto& set = *static_cast<const TriangleSet*>(arguments->geometryUserPtr);
  for (unsigned i = 0; i < arguments->N; ++i) {
    if (arguments->valid[i] == 0) continue;
    const unsigned primitive = RTCHitN_primID(arguments->hit, arguments->N, i);
    const float u = RTCHitN_u(arguments->hit, arguments->N, i);
    const float v = RTCHitN_v(arguments->hit, arguments->N, i);
    glm::vec2 uv(0);
    if (!set.mesh->uvs.empty()) {
      const glm::uvec3& t = set.mesh->triangles[set.triangles[primitive]];
      uv = (1 - u - v) * set.mesh->uvs[t.x] + u * set.mesh->uvs[t.y] + v * set.mesh->uvs[t.z];
    }
    const Material& material = set.scene->materials[static_cast<std::size_t>(set.materials[primitive])];
    const auto texture = static_cast<std::size_t>(material.cutout_texture);
    if (is_cut_out(set.scene->textures[texture], uv)) arguments->valid[i] = 0;
  }
}

std::vector<TriangleSet> split_by_cutout(const Scene& scene, const Mesh& mesh) {
  TriangleSet opaque{&scene, &mesh, {}, {}, false};
  TriangleSet cut{&scene, &mesh, {}, {}, true};
  for (const MeshPart& part : mesh.parts) {
    const TextureIndex texture = scene.materials[static_cast<std::size_t>(part.material)].cutout_texture;
    TriangleSet& set = texture == kNoTexture ? opaque : cut;
    for (std::uint32_t i = 0; i < part.triangle_count; ++i) set.triangles.push_back(part.first_triangle + i);
    set.materials.insert(set.materials.end(), part.triangle_count, part.material);
  }
  std::vector<TriangleSet> sets;
  if (!opaque.triangles.empty()) sets.push_back(std::move(opaque));
  if (!cut.triangles.empty()) sets.push_back(std::move(cut));
  return sets;
}

/// The mesh's triangles of a set with vertices moved by `transform`. Embree copies them, since it reads
/// vertices with vector loads that need room behind the last one.
Geometry make_geometry(RTCDevice device, const TriangleSet& set, const glm::mat4& transform) {
  Geometry geometry(rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE));
  auto* vertices = static_cast<glm::vec3*>(rtcSetNewGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_VERTEX, 0,
                                                                   RTC_FORMAT_FLOAT3, sizeof(glm::vec3),
                                                                   set.mesh->positions.size()));
  auto* indices = static_cast<glm::uvec3*>(rtcSetNewGeometryBuffer(
      geometry.get(), RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, sizeof(glm::uvec3), set.triangles.size()));
  if (!vertices || !indices) throw Error("out of memory for ray queries", set.scene->name);
  for (std::size_t i = 0; i < set.mesh->positions.size(); ++i)
    vertices[i] = transform_point(transform, set.mesh->positions[i]);
  for (std::size_t i = 0; i < set.triangles.size(); ++i) indices[i] = set.mesh->triangles[set.triangles[i]];
  if (set.cut) {
    rtcSetGeometryIntersectFilterFunction(geometry.get(), reject_cut_outs);
    rtcSetGeometryOccludedFilterFunction(geometry.get(), reject_cut_outs);
  }
  rtcCommitGeometry(geometry.get());
  return geometry;
}

}  // namespace

bool is_cut_out(const Texture& texture, const glm::vec2& uv) {
  if (texture.pixels.empty() || !std::isfinite(uv.x) || !std::isfinite(uv.y)) return false;
  const int x = wrapped_texel(uv.x, texture.pixels.width);
  const int y = wrapped_texel(1.0f - uv.y, texture.pixels.height);
  return texture.pixels.pixel(x, y)[3] < 128;
}

EmbreeScene::EmbreeScene(const Scene& scene)
    : device_(rtcNewDevice("threads=1")), instanced_(scene.meshes.size()) {
  if (!device_.get()) throw Error("Embree cannot start", scene.name);
  for (const Mesh& mesh : scene.meshes) sets_.push_back(split_by_cutout(scene, mesh));
  std::vector<int> users(scene.meshes.size(), 0);
  for (const Entity& entity : scene.entities) ++users[static_cast<std::size_t>(entity.mesh)];
  top_ = new_scene();
  for (const Entity& entity : scene.entities) {
    if (users[static_cast<std::size_t>(entity.mesh)] > 1)
      place_instance(entity);
    else
      place(entity);
  }
  rtcCommitScene(top_.get());
  check(scene);
}

EmbreeScene::RayScene EmbreeScene::new_scene() const {
  RayScene scene(rtcNewScene(device_.get()));
  rtcSetSceneFlags(scene.get(), RTC_SCENE_FLAG_ROBUST);
  return scene;
}

void EmbreeScene::attach(RTCScene scene, TriangleSet& set, const glm::mat4& transform) {
  const Geometry geometry = make_geometry(device_.get(), set, transform);
  rtcSetGeometryUserData(geometry.get(), &set);
  rtcAttachGeometry(scene, geometry.get());
}

void EmbreeScene::place(const Entity& entity) {
  for (TriangleSet& set : sets_[static_cast<std::size_t>(entity.mesh)]) {
    attach(top_.get(), set, entity.transform);
    placed_.push_back({&entity, {&set, 1}, false});
  }
}

void EmbreeScene::place_instance(const Entity& entity) {
  const auto mesh = static_cast<std::size_t>(entity.mesh);
  if (sets_[mesh].empty()) return;
  if (!instanced_[mesh].get()) {
    instanced_[mesh] = new_scene();
    for (TriangleSet& set : sets_[mesh]) attach(instanced_[mesh].get(), set, glm::mat4(1));
    rtcCommitScene(instanced_[mesh].get());
  }
  const Geometry instance(rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_INSTANCE));
  rtcSetGeometryInstancedScene(instance.get(), instanced_[mesh].get());
  rtcSetGeometryTransform(instance.get(), 0, RTC_FORMAT_FLOAT4X4_COLUMN_MAJOR, &entity.transform[0][0]);
  rtcCommitGeometry(instance.get());
  rtcAttachGeometry(top_.get(), instance.get());
  placed_.push_back({&entity, sets_[mesh], true});
}

void EmbreeScene::check(const Scene& scene) const {
  const RTCError error = rtcGetDeviceError(device_.get());
  if (error == RTC_ERROR_OUT_OF_MEMORY) throw Error("out of memory for ray queries", scene.name);
  if (error != RTC_ERROR_NONE)
    throw Error("Embree error " + std::to_string(static_cast<int>(error)) + " while building the scene",
                scene.name);
}

}  // namespace lightbench
