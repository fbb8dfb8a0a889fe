#include "povexport/pov_materials.h"

namespace lightbench {
namespace {

bool is_grey(const glm::vec3& c) {
  return c.x == c.y && c.y == c.z;
}

/// Grey mask of where something is: alpha of at least one half.
Image8 cutout_mask(const Image8& image) {
  Image8 mask(image.width, image.height, 1);
  for (std::size_t i = 0; i < image.pixel_count(); ++i) mask.data[i] = image.data[4 * i + 3] >= 128 ? 255 : 0;
  return mask;
}

/// Constant ambient light is emission to POV-Ray, whose own is off where there is radiosity.
void write_finish(PovWriter& out, float diffuse, const glm::vec3& ambient, const Material* shine,
                  float gain) {
  out.words("finish{ambient 0 diffuse ").number(diffuse);
  if (ambient != glm::vec3(0)) out.words(" emission rgb").vector(diffuse * ambient);
  if (shine != nullptr && shine->specular > 0) {
    out.words(" phong ").number(gain * shine->specular);
    out.words(" phong_size ").number(shine->exponent);
  }
  out.words("}");
}

}  // namespace

Image8 pov_image(const Scene& scene, const PovImage& image) {
  const Image8& pixels = scene.textures[std::size_t(image.texture)].pixels;
  return image.part == PovImage::Part::color ? first_channels(pixels, 3) : cutout_mask(pixels);
}

bool PovMaterials::uses_uv(int material) const {
  const Material& m = scene_.materials[std::size_t(material)];
  return m.diffuse_texture != kNoTexture || m.cutout_texture != kNoTexture;
}

int PovMaterials::texture(int material, const glm::vec3& vertex_color) {
  const int next = int(textures_.size()) + 1;
  const Key key{material, vertex_color.x, vertex_color.y, vertex_color.z};
  const auto [entry, added] = textures_.try_emplace(key, next);
  if (added) {
    const Material& m = scene_.materials[std::size_t(material)];
    declare(m, m.diffuse * vertex_color, next);
  }
  return entry->second;
}

/// The image is read once and shared by all textures that refer to its pigment.
int PovMaterials::pigment(TextureIndex texture) {
  const auto [entry, added] = pigments_.try_emplace(texture, int(pigments_.size()) + 1);
  if (added) {
    const std::string file = pov_file_name("tex", entry->second, "png");
    images_[file] = {texture, PovImage::Part::color};
    declarations_.name("#declare P", entry->second).words("=pigment{uv_mapping image_map{png ").file(file);
    declarations_.words(" gamma srgb interpolate 2}}\n");
  }
  return entry->second;
}

std::string PovMaterials::cutout_file(TextureIndex texture) {
  const auto [entry, added] = cutouts_.try_emplace(texture);
  if (added) {
    entry->second = pov_file_name("cut", int(cutouts_.size()), "png");
    images_[entry->second] = {texture, PovImage::Part::cutout};
  }
  return entry->second;
}

/// Diffuse and specular part. A coloured factor of an image is a layer above it that only filters; highlights
/// must then come from that layer, since it would filter those below.
void PovMaterials::write_surface(const Material& material, const glm::vec3& tint, float gain) {
  PovWriter& out = declarations_;
  const glm::vec3 ambient = scene_.water ? scene_.water->ambient : glm::vec3(0);
  if (material.diffuse_texture == kNoTexture) {
    out.words("texture{pigment{rgb").vector(tint).words("}");
    write_finish(out, gain, ambient, &material, gain);
    out.words("}");
    return;
  }
  const bool grey = is_grey(tint);
  out.words("texture{pigment{").name("P", pigment(material.diffuse_texture)).words("}");
  write_finish(out, grey ? gain * tint.x : gain, ambient, grey ? &material : nullptr, gain);
  out.words("}");
  if (grey) return;
  out.words("texture{pigment{rgbf<").number(tint.x).words(",").number(tint.y).words(",").number(tint.z);
  out.words(",1>}");
  write_finish(out, 0, ambient, &material, gain);
  out.words("}");
}

void PovMaterials::declare(const Material& material, const glm::vec3& tint, int number) {
  PovWriter& out = declarations_;
  if (material.diffuse_texture != kNoTexture) pigment(material.diffuse_texture);
  const bool emits = material.emission != glm::vec3(0);
  const bool cut = material.cutout_texture != kNoTexture;
  if (emits || cut) {  // maps of textures take layered ones by name only
    out.name("#declare S", number).words("=");
    write_surface(material, tint, emits ? 2.0f : 1.0f);
    out.words("\n");
  }
  if (emits) {  // the mean of twice the lit surface and twice its own light
    out.name("#declare E", number).name("=texture{average texture_map{[1 S", number);
    out.words("][1 pigment{rgb 1}finish{ambient 0 diffuse 0 emission rgb").vector(2.0f * material.emission);
    out.words("}]}}\n");
  }
  out.name("#declare T", number).words("=");
  if (cut) {
    out.words("texture{uv_mapping image_pattern{png ").file(cutout_file(material.cutout_texture));
    out.words(" gamma 1 interpolate 0}texture_map{[.5 Clear][.5 ");
    out.name(emits ? PovWriter::Words("E") : PovWriter::Words("S"), number).words("]}}");
  } else if (emits) {
    out.name("texture{E", number).words("}");
  } else {
    write_surface(material, tint, 1.0f);
  }
  out.words("\n");
}

}  // namespace lightbench
