#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>

#include "base/params.h"
#include "renderer/gl_framebuffer.h"
#include "renderer/gl_objects.h"
#include "renderer/gl_program.h"
#include "renderer/radiance/direction_grid.h"
#include "scene/scene.h"

namespace lightbench {

/// What a shader reads to know an object's radiance.
class RadianceTextures {
 public:
  virtual ~RadianceTextures() = default;
  /// Binds textures from unit 2 on and sets what techniques/surface_radiance/codec.glsl asks for.
  virtual void bind(const Program& program) const = 0;
};

/// What a codec makes of an object's files.
struct RadianceFile {
  int width, height;  ///< of the texture, all sides together
  DirectionGrid grid;
  float scale;  ///< the radiance that stands for 1
  std::unique_ptr<RadianceTextures> textures;
};

/// A baked object on the GPU.
struct RadianceObject {
  int entity;
  glm::dmat4 world_from_object;
  Bounds bounds;  ///< in the object's space
  Buffer positions, normals, uvs, texels;
  VertexArray vertices;  ///< three for each triangle; wound so that the front is what OpenGL takes for it
  struct Range {
    int first, count;     ///< vertices
    TextureIndex cutout;  ///< or kNoTexture
  };
  std::vector<Range> ranges;
  RadianceFile file;
  int sides;
};

/// All baked objects of a scene, with their files read and uploaded.
class RadianceObjects {
 public:
  /// From the files in a folder that go with the technique's parameters. Throws Error where one is missing or
  /// does not fit the scene, and when OpenGL is out of memory.
  RadianceObjects(const Scene& scene, const std::filesystem::path& folder, const ParamValues& params);

  /// Whether these were read from there for such parameters; those that say how to draw may differ.
  bool are(const std::filesystem::path& folder, const ParamValues& params) const;
  const std::vector<RadianceObject>& objects() const { return objects_; }
  LayerOrder order() const { return order_; }  ///< of all of them
  std::uint64_t file_bytes() const { return file_bytes_; }

 private:
  std::string key_;
  std::uint64_t file_bytes_;
  LayerOrder order_;
  std::vector<RadianceObject> objects_;
};

/// The size of the files that RadianceObjects reads; those that are not there have none.
std::uint64_t radiance_file_bytes(const Scene& scene, const std::filesystem::path& folder,
                                  const ParamValues& params);

}  // namespace lightbench
