#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "base/image.h"

/// Move-only owners of OpenGL objects. All need a current context (renderer/gl_context.h), also to be
/// destroyed; a default-made one is empty (id 0). Allocation throws Error when OpenGL is out of memory.
namespace lightbench {

enum class TexelFormat {
  r8,
  rgba8,
  rg16,  ///< unsigned normalised
  rgba16,
  r16f,
  rgb16f,
  rgb16,
  rgba16_snorm,
  rg_rgtc2,  ///< compressed: each of two components in 8 bytes for 4 x 4 texels
  rg16f,
  rgba16f,
  r32f,
  rg32f,
  rgba32f,
  depth32f,
  depth32f_stencil8,
};
int component_count(TexelFormat format);

enum class Filter { nearest, linear };             ///< never mipmaps
enum class Wrap { clamp, repeat, repeat_across };  ///< repeat_across: along x only

/// The name of an OpenGL object that is deleted by `Delete` when its owner goes.
template <void (*Delete)(unsigned)>
class GlHandle {
 public:
  GlHandle() = default;
  explicit GlHandle(unsigned id) : id_(id) {}
  GlHandle(GlHandle&& other) noexcept : id_(std::exchange(other.id_, 0)) {}
  GlHandle& operator=(GlHandle&& other) noexcept {
    std::swap(id_, other.id_);
    return *this;
  }
  ~GlHandle() {
    if (id_ != 0) Delete(id_);
  }
  unsigned id() const { return id_; }

 private:
  unsigned id_ = 0;
};

void delete_texture(unsigned id);
void delete_buffer(unsigned id);

/// Adds to the bytes of textures that exist as long as it lives.
class CountedBytes {
 public:
  CountedBytes() = default;
  explicit CountedBytes(std::size_t bytes);
  CountedBytes(CountedBytes&& other) noexcept : bytes_(std::exchange(other.bytes_, 0)) {}
  CountedBytes& operator=(CountedBytes&& other) noexcept {
    std::swap(bytes_, other.bytes_);
    return *this;
  }
  ~CountedBytes();

 private:
  std::size_t bytes_ = 0;
};

/// Bytes of the textures of this process as their formats count them, whatever OpenGL makes of them.
struct TextureMemory {
  std::size_t now = 0;
  std::size_t most = 0;  ///< since the start, or since it was last forgotten
};
TextureMemory texture_memory();
void forget_most_texture_memory();

/// A two-dimensional texture, or an array of them, of immutable storage with one level.
class GlTexture {
 public:
  GlTexture() = default;
  GlTexture(TexelFormat format, int width, int height, Filter filter = Filter::nearest,
            Wrap wrap = Wrap::clamp);
  static GlTexture array(TexelFormat format, int width, int height, int layers,
                         Filter filter = Filter::nearest, Wrap wrap = Wrap::clamp);

  unsigned id() const { return handle_.id(); }
  int width() const { return width_; }
  int height() const { return height_; }
  TexelFormat format() const { return format_; }
  int layers() const { return layers_; }  ///< 0: not an array

  /// Whole rows of normalised RGBA from row `first` on, in OpenGL's order, whose row 0 is the bottom.
  void upload_rows(int first, std::span<const std::uint16_t> texels);
  void upload(const Image& pixels);  ///< float, as many components as the format has, row 0 on top
  /// One layer of an array: texels, or blocks of them, as the format keeps them, OpenGL's row 0 first. For
  /// rgb16f, rgb16, rgba16, rgba16_snorm, rgba8 and rg_rgtc2.
  void upload_layer(int layer, std::span<const std::byte> texels);
  void bind(unsigned unit) const;

 private:
  GlHandle<delete_texture> handle_;
  CountedBytes bytes_;
  TexelFormat format_ = TexelFormat::rgba8;
  int width_ = 0;
  int height_ = 0;
  int layers_ = 0;
};

/// The first `channels` components as floats, row 0 on top (OpenGL's row 0 is the bottom). Drains the
/// pipeline.
Image read_back(const GlTexture& texture, int channels);

/// A buffer of bytes, immutable in size.
class Buffer {
 public:
  Buffer() = default;
  Buffer(const void* data, std::size_t bytes);

  unsigned id() const { return handle_.id(); }
  std::size_t size() const { return bytes_; }
  void update(const void* data, std::size_t bytes);  ///< from the start; bytes <= size()
  void bind_uniform(unsigned binding) const;
  void bind_storage(unsigned binding) const;

 private:
  GlHandle<delete_buffer> handle_;
  std::size_t bytes_ = 0;
};

/// Draws of full-screen triangles that shaders decide on: storage of four whole numbers each, of which the
/// second is 1 where it is to be drawn; all start with 0.
class DrawCommands {
 public:
  explicit DrawCommands(std::size_t count);

  void bind_storage(unsigned binding) const { buffer_.bind_storage(binding); }
  /// To be called between the writing shaders and the draws.
  void written() const;
  void draw(int command) const;

 private:
  Buffer buffer_;
};

template <typename T>
Buffer buffer_of(const std::vector<T>& values) {
  return Buffer(values.data(), values.size() * sizeof(T));
}

enum class BufferFormat { r16ui, r32ui, rg32ui, rgba8ui };

/// A long row of whole numbers that shaders read with texelFetch from a usamplerBuffer.
class BufferTexture {
 public:
  BufferTexture() = default;
  /// Throws Error where there are more entries than OpenGL takes.
  BufferTexture(BufferFormat format, const void* data, std::size_t entries);

  void bind(unsigned unit) const;
  std::size_t bytes() const { return buffer_.size(); }

 private:
  Buffer buffer_;
  GlHandle<delete_texture> texture_;
};

}  // namespace lightbench
