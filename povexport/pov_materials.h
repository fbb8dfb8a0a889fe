#pragma once

#include <map>
#include <string>
#include <tuple>
#include <vector>

#include <glm/vec3.hpp>

#include "base/image.h"
#include "povexport/pov_writer.h"
#include "scene/scene.h"

namespace lightbench {

/// An image that POV-Ray reads: a texture's colour, or the grey mask of where it is not cut out.
struct PovImage {
  enum class Part { color, cutout };
  TextureIndex texture = kNoTexture;
  Part part = Part::color;
};
/// Its pixels: a copy, which of a large texture takes a gigabyte.
Image8 pov_image(const Scene& scene, const PovImage& image);

/// The textures of a scene: declarations T1, T2, ... of the materials (one more for each vertex colour that
/// occurs with a material) and the images that they use.
class PovMaterials {
 public:
  explicit PovMaterials(const Scene& scene) : scene_(scene) {}

  /// The number of the texture declaration of a material, multiplied by a vertex colour.
  int texture(int material, const glm::vec3& vertex_color = glm::vec3(1));
  /// Whether the material looks anything up by uv.
  bool uses_uv(int material) const;

  const PovWriter& declarations() const { return declarations_; }
  std::map<std::string, PovImage> take_images() { return std::move(images_); }

 private:
  using Key = std::tuple<int, float, float, float>;

  void declare(const Material& material, const glm::vec3& tint, int number);
  void write_surface(const Material& material, const glm::vec3& tint, float gain);
  int pigment(TextureIndex texture);
  std::string cutout_file(TextureIndex texture);

  const Scene& scene_;
  PovWriter declarations_;
  std::map<Key, int> textures_;
  std::map<TextureIndex, int> pigments_;
  std::map<TextureIndex, std::string> cutouts_;
  std::map<std::string, PovImage> images_;
};

}  // namespace lightbench
