#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "renderer/gbuffer.h"
#include "renderer/gl_framebuffer.h"
#include "renderer/gl_objects.h"
#include "renderer/gl_program.h"
#include "scene/scene.h"

namespace lightbench {

/// Triangles of one part of a mesh that lie together; indices [first, first + count) of the mesh's index
/// buffer.
struct TriangleCluster {
  Bounds box;  ///< in the mesh's space
  std::uint32_t first_index = 0;
  std::uint32_t index_count = 0;
};

/// Splits a mesh part into clusters of at most `max_triangles` by halving their extent; `order` receives the
/// part's triangles (indices into mesh.triangles) cluster after cluster, within one in the mesh's order.
std::vector<TriangleCluster> cluster_triangles(const Mesh& mesh, const MeshPart& part,
                                               std::uint32_t max_triangles,
                                               std::vector<std::uint32_t>& order);

/// A scene's geometry, textures and materials on the GPU. Lights and background are not part of it.
class GpuScene {
 public:
  /// Throws Error when a texture is larger than OpenGL allows or memory runs out.
  explicit GpuScene(const Scene& scene);

  /// Draws all surfaces: `cutout` the parts with a cut-out texture, `solid` the rest, so that hidden pixels
  /// of those need no shading. The programs take what shaders/surface.vert.glsl takes; positions are given to
  /// them relative to `eye`, and the entity's number.
  void draw_surfaces(const Program& solid, const Program& cutout, const glm::dmat4& clip_from_world,
                     const glm::dvec3& eye, FrustumCulling culling) const;
  /// Draws what casts shadows, without colour: `cutout` draws the parts with a cut-out texture, `solid` the
  /// rest.
  void draw_casters(const Program& solid, const Program& cutout, const glm::dmat4& clip_from_world,
                    FrustumCulling culling) const;

  /// Puts the entities of the scene that it was made from where they stand now.
  void place(const Scene& scene);

  const GlTexture& texture(TextureIndex index) const { return textures_[std::size_t(index)]; }
  const Bounds& bounds() const { return bounds_; }  ///< in world space
  const Bounds& entity_bounds(std::size_t entity) const {
    return entity_bounds_[entity];
  }  ///< in world space

 private:
  struct Part {
    int material = 0;
    int diffuse_texture = kNoTexture;
    int cutout_texture = kNoTexture;
    std::vector<TriangleCluster> clusters;
  };
  struct GpuMesh {
    Buffer positions, normals, uvs, colors, indices;
    VertexArray vertices;
    std::vector<Part> parts;
  };
  struct Instance {
    int mesh = 0;
    glm::dmat4 world_from_object{1.0};
    bool operator==(const Instance&) const = default;
  };

  static bool is_solid(const Part& part) { return part.cutout_texture == kNoTexture; }
  static bool is_cut_out(const Part& part) { return part.cutout_texture != kNoTexture; }
  /// Calls `prepare` before each part; without it, parts that follow one another are drawn at once.
  void draw_parts(const Instance& instance, const glm::dmat4& clip_from_object, FrustumCulling culling,
                  bool (*wanted)(const Part&), const std::function<void(const Part&)>& prepare) const;
  void upload_mesh(const Scene& scene, const Mesh& mesh);
  void upload_materials(const Scene& scene);

  std::vector<GlTexture> textures_;
  std::vector<GpuMesh> meshes_;
  std::vector<Instance> instances_;
  Buffer materials_;
  std::vector<Bounds> entity_bounds_;
  Bounds bounds_;
};

/// Changes whenever a GpuScene made from the scene would, but for where the entities stand: a hash of meshes,
/// materials and texels.
std::string gpu_scene_key(const Scene& scene);

}  // namespace lightbench
