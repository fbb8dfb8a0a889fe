#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <embree3/rtcore.h>

#include "scene/scene.h"

namespace lightbench {

/// One Embree geometry: the opaque triangles of a mesh, or those with cut-outs.
struct TriangleSet {
  const Scene* scene;
  const Mesh* mesh;
  std::vector<std::uint32_t> triangles;  ///< of the mesh, by primitive number
  std::vector<int> materials;            ///< of the scene, by primitive number
  bool cut;                              ///< whether these are the triangles with cut-outs
};

/// What stands behind a geometry number of the top scene. A mesh that one entity uses is put there in world
/// space, which is fastest; one that several use is kept once, in its own space, and instanced.
struct PlacedGeometry {
  const Entity* entity;
  std::span<const TriangleSet> sets;  ///< those of an instanced mesh by their number in it, else the one
  bool instanced;
};

/// An entity's triangle.
struct PlacedTriangle {
  const PlacedGeometry* place;
  const TriangleSet* set;
  unsigned primitive;
};

/// Whether the nearest texel of the cut-out texture says that nothing is there.
bool is_cut_out(const Texture& texture, const glm::vec2& uv);

template <typename Handle, void (*Release)(Handle)>
class EmbreeHandle {
 public:
  explicit EmbreeHandle(Handle handle = nullptr) : handle_(handle) {}
  EmbreeHandle(EmbreeHandle&& other) noexcept : handle_(std::exchange(other.handle_, nullptr)) {}
  EmbreeHandle& operator=(EmbreeHandle&& other) noexcept {
    std::swap(handle_, other.handle_);
    return *this;
  }
  ~EmbreeHandle() {
    if (handle_) Release(handle_);
  }
  Handle get() const { return handle_; }

 private:
  Handle handle_;
};

/// A scene as Embree traces it, cut-outs included: rays and packets of rays alike go through their holes.
/// Keeps a reference to the scene; throws Error where memory is short.
class EmbreeScene {
 public:
  explicit EmbreeScene(const Scene& scene);
  EmbreeScene(const EmbreeScene&) = delete;
  EmbreeScene& operator=(const EmbreeScene&) = delete;

  RTCScene top() const { return top_.get(); }
  /// By geometry number of the top scene.
  const std::vector<PlacedGeometry>& placed() const { return placed_; }
  /// What a hit's instance, geometry and primitive numbers stand for.
  PlacedTriangle triangle(unsigned instance, unsigned geometry, unsigned primitive) const {
    const bool instanced = instance != RTC_INVALID_GEOMETRY_ID;
    const PlacedGeometry& place = placed_[instanced ? instance : geometry];
    return {&place, &place.sets[instanced ? geometry : 0], primitive};
  }

 private:
  using Device = EmbreeHandle<RTCDevice, rtcReleaseDevice>;
  using RayScene = EmbreeHandle<RTCScene, rtcReleaseScene>;

  RayScene new_scene() const;
  void attach(RTCScene scene, TriangleSet& set, const glm::mat4& transform);
  void place(const Entity& entity);
  void place_instance(const Entity& entity);
  void check(const Scene& scene) const;

  Device device_;
  std::vector<std::vector<TriangleSet>> sets_;  ///< by mesh
  std::vector<RayScene> instanced_;             ///< by mesh; empty handles where not instanced
  RayScene top_;
  std::vector<PlacedGeometry> placed_;
};

}  // namespace lightbench
