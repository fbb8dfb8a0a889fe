#include "renderer/rays.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>
#include <vector>

#include <embree3/rtcore.h>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec4.hpp>

#include "base/error.h"

namespace lightbench {

namespace {

// The two ends of a segment are shortened by this share of its length, and by at least so many units in the
// last place of the largest coordinate, which is what a point computed on a surface may be off.
constexpr float kSegmentEpsilon = 1e-4f;
constexpr float kSegmentUlps = 16.0f;

template <typename Handle, void (*Release)(Handle)>
class Owned {
 public:
  explicit Owned(Handle handle = nullptr) : handle_(handle) {}
  Owned(Owned&& other) noexcept : handle_(std::exchange(other.handle_, nullptr)) {}
  Owned& operator=(Owned&& other) noexcept {
    std::swap(handle_, other.handle_);
    return *this;
  }
  ~Owned() {
    if (handle_) Release(handle_);
  }
  Handle get() const { return handle_; }

 private:
  Handle handle_;
};
using Device = Owned<RTCDevice, rtcReleaseDevice>;
using RayScene = Owned<RTCScene, rtcReleaseScene>;
using Geometry = Owned<RTCGeometry, rtcReleaseGeometry>;

/// One Embree geometry: the opaque triangles of a mesh, or those with cut-outs.
struct TriangleSet {
  const Scene* scene;
  const Mesh* mesh;
  std::vector<std::uint32_t> triangles;  ///< of the mesh, by primitive number
  std::vector<TextureIndex> cutouts;     ///< by primitive number; empty for an opaque set
};

glm::vec3 transform_point(const glm::mat4& m, const glm::vec3& p) {
  return glm::vec3(m * glm::vec4(p, 1));
}

int wrapped_texel(float coordinate, int size) {
  const float fraction = coordinate - std::floor(coordinate);
  return std::min(static_cast<int>(fraction * static_cast<float>(size)), size - 1);
}

/// Whether the nearest texel of the cut-out texture says that nothing is there.
bool is_cut_out(const Texture& texture, const glm::vec2& uv) {
  if (texture.pixels.empty() || !std::isfinite(uv.x) || !std::isfinite(uv.y)) return false;
  const int x = wrapped_texel(uv.x, texture.pixels.width);
  const int y = wrapped_texel(1.0f - uv.y, texture.pixels.height);
  return texture.pixels.pixel(x, y)[3] < 128;
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
    const auto texture = static_cast<std::size_t>(set.cutouts[primitive]);
    if (is_cut_out(set.scene->textures[texture], uv)) arguments->valid[i] = 0;
  }
}

std::vector<TriangleSet> split_by_cutout(const Scene& scene, const Mesh& mesh) {
  TriangleSet opaque{&scene, &mesh, {}, {}};
  TriangleSet cut{&scene, &mesh, {}, {}};
  for (const MeshPart& part : mesh.parts) {
    const TextureIndex texture = scene.materials[static_cast<std::size_t>(part.material)].cutout_texture;
    TriangleSet& set = texture == kNoTexture ? opaque : cut;
    for (std::uint32_t i = 0; i < part.triangle_count; ++i) set.triangles.push_back(part.first_triangle + i);
    if (texture != kNoTexture) set.cutouts.insert(set.cutouts.end(), part.triangle_count, texture);
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
  if (!set.cutouts.empty()) {
    rtcSetGeometryIntersectFilterFunction(geometry.get(), reject_cut_outs);
    rtcSetGeometryOccludedFilterFunction(geometry.get(), reject_cut_outs);
  }
  rtcCommitGeometry(geometry.get());
  return geometry;
}

RTCRay make_ray(const glm::vec3& origin, const glm::vec3& direction, float near, float far) {
  RTCRay ray;
  std::memset(&ray, 0, sizeof ray);
  ray.org_x = origin.x, ray.org_y = origin.y, ray.org_z = origin.z;
  ray.dir_x = direction.x, ray.dir_y = direction.y, ray.dir_z = direction.z;
  ray.tnear = near;
  ray.tfar = far;
  ray.mask = 0xffffffffu;
  return ray;
}

bool is_finite(const glm::vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

float largest_component(const glm::vec3& v) {
  return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

}  // namespace

/// A mesh that one entity uses is put into the top scene in world space, which is fastest; one that several
/// use is kept once and instanced.
struct SceneRays::Impl {
  explicit Impl(const Scene& scene);
  RayScene new_scene() const;
  void attach(RTCScene scene, TriangleSet& set, const glm::mat4& transform);
  void place(const Entity& entity);
  void place_instance(const Entity& entity);
  void check(const Scene& scene) const;
  glm::vec3 normal(const RTCHit& hit) const;

  /// What stands behind a geometry number of the top scene.
  struct Placed {
    const Entity* entity;
    const TriangleSet* sets;  ///< those of an instanced mesh by their number in it, else the one
  };

  Device device;
  std::vector<std::vector<TriangleSet>> sets;  ///< by mesh
  std::vector<RayScene> instanced;             ///< by mesh; empty handles where not instanced
  RayScene top;
  std::vector<Placed> placed;  ///< by geometry number of `top`
};

SceneRays::Impl::Impl(const Scene& scene)
    : device(rtcNewDevice("threads=1")), instanced(scene.meshes.size()) {
  if (!device.get()) throw Error("Embree cannot start", scene.name);
  for (const Mesh& mesh : scene.meshes) sets.push_back(split_by_cutout(scene, mesh));
  std::vector<int> users(scene.meshes.size(), 0);
  for (const Entity& entity : scene.entities) ++users[static_cast<std::size_t>(entity.mesh)];
  top = new_scene();
  for (const Entity& entity : scene.entities) {
    if (users[static_cast<std::size_t>(entity.mesh)] > 1)
      place_instance(entity);
    else
      place(entity);
  }
  rtcCommitScene(top.get());
  check(scene);
}

RayScene SceneRays::Impl::new_scene() const {
  RayScene scene(rtcNewScene(device.get()));
  rtcSetSceneFlags(scene.get(), RTC_SCENE_FLAG_ROBUST);
  return scene;
}

void SceneRays::Impl::attach(RTCScene scene, TriangleSet& set, const glm::mat4& transform) {
  const Geometry geometry = make_geometry(device.get(), set, transform);
  rtcSetGeometryUserData(geometry.get(), &set);
  rtcAttachGeometry(scene, geometry.get());
}

void SceneRays::Impl::place(const Entity& entity) {
  for (TriangleSet& set : sets[static_cast<std::size_t>(entity.mesh)]) {
    attach(top.get(), set, entity.transform);
    placed.push_back({&entity, &set});
  }
}

void SceneRays::Impl::place_instance(const Entity& entity) {
  const auto mesh = static_cast<std::size_t>(entity.mesh);
  if (sets[mesh].empty()) return;
  if (!instanced[mesh].get()) {
    instanced[mesh] = new_scene();
    for (TriangleSet& set : sets[mesh]) attach(instanced[mesh].get(), set, glm::mat4(1));
    rtcCommitScene(instanced[mesh].get());
  }
  const Geometry instance(rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_INSTANCE));
  rtcSetGeometryInstancedScene(instance.get(), instanced[mesh].get());
  rtcSetGeometryTransform(instance.get(), 0, RTC_FORMAT_FLOAT4X4_COLUMN_MAJOR, &entity.transform[0][0]);
  rtcCommitGeometry(instance.get());
  rtcAttachGeometry(top.get(), instance.get());
  placed.push_back({&entity, sets[mesh].data()});
}

void SceneRays::Impl::check(const Scene& scene) const {
  const RTCError error = rtcGetDeviceError(device.get());
  if (error == RTC_ERROR_OUT_OF_MEMORY) throw Error("out of memory for ray queries", scene.name);
  if (error != RTC_ERROR_NONE)
    throw Error("Embree error " + std::to_string(static_cast<int>(error)) + " while building the scene",
                scene.name);
}

/// From the triangle's vertices in double precision: Embree's own is in object space and short of digits on
/// slivers.
glm::vec3 SceneRays::Impl::normal(const RTCHit& hit) const {
  const bool is_instance = hit.instID[0] != RTC_INVALID_GEOMETRY_ID;
  const Placed& place = placed[is_instance ? hit.instID[0] : hit.geomID];
  const TriangleSet& set = place.sets[is_instance ? hit.geomID : 0];
  const glm::uvec3& t = set.mesh->triangles[set.triangles[hit.primID]];
  const glm::dmat3 linear(glm::mat3(place.entity->transform));
  const auto& p = set.mesh->positions;
  const glm::dvec3 a = linear * (glm::dvec3(p[t.y]) - glm::dvec3(p[t.x]));
  const glm::dvec3 b = linear * (glm::dvec3(p[t.z]) - glm::dvec3(p[t.x]));
  // A mirroring transform turns the winding round, but not what is outside.
  const double side = glm::determinant(linear) < 0 ? -1.0 : 1.0;
  const glm::dvec3 n = side * glm::cross(a, b);
  const double length = glm::length(n);
  return length > 0 ? glm::vec3(n / length) : glm::vec3(0, 1, 0);
}

SceneRays::SceneRays(const Scene& scene) : impl_(std::make_unique<Impl>(scene)) {}
SceneRays::~SceneRays() = default;

std::optional<RayHit> SceneRays::closest_hit(const glm::vec3& origin, const glm::vec3& direction) const {
  if (!is_finite(origin) || !is_finite(direction) || direction == glm::vec3(0)) return std::nullopt;
  RTCRayHit query;
  query.ray = make_ray(origin, direction, 0, std::numeric_limits<float>::infinity());
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect1(impl_->top.get(), &context, &query);
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
  return RayHit{query.ray.tfar, impl_->normal(query.hit)};
}

bool SceneRays::occluded(const glm::vec3& from, const glm::vec3& to) const {
  if (!is_finite(from) || !is_finite(to)) return false;
  const glm::vec3 segment = to - from;
  const float length = glm::length(segment);
  const float magnitude = std::max(largest_component(from), largest_component(to));
  const float rounding = kSegmentUlps * std::numeric_limits<float>::epsilon() * magnitude;
  if (!(length > 2 * rounding)) return false;
  const float epsilon = std::max(kSegmentEpsilon, rounding / length);
  RTCRay ray = make_ray(from, segment, epsilon, 1 - epsilon);
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcOccluded1(impl_->top.get(), &context, &ray);
  return ray.tfar < 0;  // Embree's mark of a hit
}

}  // namespace lightbench
