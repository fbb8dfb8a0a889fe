#pragma once

#include <initializer_list>

#include "renderer/gl_objects.h"

namespace lightbench {

void delete_vertex_array(unsigned id);
void delete_framebuffer(unsigned id);

class VertexArray {
 public:
  VertexArray();

  unsigned id() const { return handle_.id(); }
  /// Attribute `location` reads `components` floats from `buffer` at offset 0, tightly packed.
  void attribute(unsigned location, const Buffer& buffer, int components);
  void indices(const Buffer& buffer);

 private:
  GlHandle<delete_vertex_array> handle_;
};

/// Colour attachments in order of the fragment shader's output locations, and depth (with stencil if it has
/// one). The textures must outlive it. All have one size, which becomes the viewport on `bind`.
class Framebuffer {
 public:
  Framebuffer() = default;
  explicit Framebuffer(std::initializer_list<const GlTexture*> colors, const GlTexture* depth = nullptr);
  /// One layer of an array, as depth or as colour; then `depth` may be its depth.
  static Framebuffer layer(const GlTexture& array, int layer, const GlTexture* depth = nullptr);

  unsigned id() const { return handle_.id(); }
  int width() const { return width_; }
  int height() const { return height_; }
  void bind() const;
  void clear_color(int attachment, float r, float g, float b, float a) const;
  void clear_depth(float depth) const;
  void clear_depth_stencil(float depth, int stencil) const;

 private:
  GlHandle<delete_framebuffer> handle_;
  int width_ = 0;
  int height_ = 0;
};

}  // namespace lightbench
