#include "renderer/gl_objects.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cassert>
#include <stdexcept>
#include <vector>

#include <fmt/format.h>
#include <glad/gl.h>

#include "base/error.h"
#include "renderer/gl_context.h"

namespace lightbench {
namespace {

struct FormatRow {
  TexelFormat format;
  GLenum internal;
  int components;
  int bytes;  ///< of a texel
};

constexpr std::array kFormats{
    FormatRow{TexelFormat::r8, GL_R8, 1, 1},
    FormatRow{TexelFormat::rgba8, GL_RGBA8, 4, 4},
    FormatRow{TexelFormat::rg16, GL_RG16, 2, 4},
    FormatRow{TexelFormat::rgba16, GL_RGBA16, 4, 8},
    FormatRow{TexelFormat::r16f, GL_R16F, 1, 2},
    FormatRow{TexelFormat::rg16f, GL_RG16F, 2, 4},
    FormatRow{TexelFormat::rgb16f, GL_RGB16F, 3, 6},
    FormatRow{TexelFormat::rgb16, GL_RGB16, 3, 6},
    FormatRow{TexelFormat::rgba16_snorm, GL_RGBA16_SNORM, 4, 8},
    FormatRow{TexelFormat::rg_rgtc2, GL_COMPRESSED_RG_RGTC2, 2, 1},
    FormatRow{TexelFormat::rgba16f, GL_RGBA16F, 4, 8},
    FormatRow{TexelFormat::r32f, GL_R32F, 1, 4},
    FormatRow{TexelFormat::rg32f, GL_RG32F, 2, 8},
    FormatRow{TexelFormat::rgba32f, GL_RGBA32F, 4, 16},
    FormatRow{TexelFormat::depth32f, GL_DEPTH_COMPONENT32F, 1, 4},
    FormatRow{TexelFormat::depth32f_stencil8, GL_DEPTH32F_STENCIL8, 1, 8},
};

const FormatRow& row(TexelFormat format) {
  for (const FormatRow& candidate : kFormats)
    if (candidate.format == format) return candidate;
  throw std::logic_error("a texel format without a row in the table");
}

GLenum transfer_format(TexelFormat format, int channels) {
  if (format == TexelFormat::depth32f || format == TexelFormat::depth32f_stencil8) return GL_DEPTH_COMPONENT;
  constexpr std::array<GLenum, 4> formats{GL_RED, GL_RG, GL_RGB, GL_RGBA};
  return formats.at(std::size_t(channels - 1));
}

void set_sampling(unsigned id, Filter filter, Wrap wrap) {
  const GLint mode = filter == Filter::linear ? GL_LINEAR : GL_NEAREST;
  const GLint across = wrap == Wrap::clamp ? GL_CLAMP_TO_EDGE : GL_REPEAT;
  const GLint along = wrap == Wrap::repeat ? GL_REPEAT : GL_CLAMP_TO_EDGE;
  glTextureParameteri(id, GL_TEXTURE_MIN_FILTER, mode);
  glTextureParameteri(id, GL_TEXTURE_MAG_FILTER, mode);
  glTextureParameteri(id, GL_TEXTURE_WRAP_S, across);
  glTextureParameteri(id, GL_TEXTURE_WRAP_T, along);
}

// The rows in OpenGL's order, from the bottom.
template <typename Component>
std::vector<Component> flipped(const std::vector<Component>& rows, int height) {
  const std::size_t row_size = rows.size() / std::size_t(height);
  std::vector<Component> result;
  result.reserve(rows.size());
  for (std::size_t y = std::size_t(height); y-- > 0;) {
    const auto first = rows.begin() + std::ptrdiff_t(y * row_size);
    result.insert(result.end(), first, first + std::ptrdiff_t(row_size));
  }
  return result;
}

std::atomic<std::size_t> bytes_now = 0, bytes_most = 0;

std::size_t bytes_of(TexelFormat format, int width, int height, int layers) {
  return std::size_t(row(format).bytes) * std::size_t(width) * std::size_t(height) * std::size_t(layers);
}

}  // namespace

CountedBytes::CountedBytes(std::size_t bytes) : bytes_(bytes) {
  const std::size_t now = bytes_now += bytes;
  std::size_t most = bytes_most;
  while (most < now && !bytes_most.compare_exchange_weak(most, now)) {
  }
}

CountedBytes::~CountedBytes() {
  bytes_now -= bytes_;
}

TextureMemory texture_memory() {
  return {bytes_now, bytes_most};
}

void forget_most_texture_memory() {
  bytes_most = bytes_now.load();
}

int component_count(TexelFormat format) {
  return row(format).components;
}

void delete_texture(unsigned id) {
  glDeleteTextures(1, &id);
}
void delete_buffer(unsigned id) {
  glDeleteBuffers(1, &id);
}

GlTexture::GlTexture(TexelFormat format, int width, int height, Filter filter, Wrap wrap)
    : format_(format), width_(width), height_(height) {
  GLuint id = 0;
  glCreateTextures(GL_TEXTURE_2D, 1, &id);
  handle_ = GlHandle<delete_texture>(id);
  glTextureStorage2D(id, 1, row(format).internal, width, height);
  throw_if_out_of_memory(fmt::format("a texture of {} x {} texels", width, height));
  bytes_ = CountedBytes(bytes_of(format, width, height, 1));
  set_sampling(id, filter, wrap);
}

GlTexture GlTexture::array(TexelFormat format, int width, int height, int layers, Filter filter, Wrap wrap) {
  GlTexture texture;
  texture.format_ = format;
  texture.width_ = width;
  texture.height_ = height;
  texture.layers_ = layers;
  GLuint id = 0;
  glCreateTextures(GL_TEXTURE_2D_ARRAY, 1, &id);
  texture.handle_ = GlHandle<delete_texture>(id);
  glTextureStorage3D(id, 1, row(format).internal, width, height, layers);
  throw_if_out_of_memory(fmt::format("a texture of {} x {} x {} texels", width, height, layers));
  texture.bytes_ = CountedBytes(bytes_of(format, width, height, layers));
  set_sampling(id, filter, wrap);
  return texture;
}

void GlTexture::upload_rows(int first, std::span<const std::uint16_t> texels) {
  const std::size_t row_size = std::size_t(width_) * 4;
  assert(texels.size() % row_size == 0 && component_count(format_) == 4);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTextureSubImage2D(id(), 0, 0, first, width_, GLsizei(texels.size() / row_size), GL_RGBA,
                      GL_UNSIGNED_SHORT, texels.data());
}

void GlTexture::upload(const Image& pixels) {
  assert(pixels.width == width_ && pixels.height == height_ && pixels.channels == component_count(format_));
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTextureSubImage2D(id(), 0, 0, 0, width_, height_, transfer_format(format_, pixels.channels), GL_FLOAT,
                      flipped(pixels.data, height_).data());
}

namespace {

/// What a layer's texels are made of; 0 where it is blocks.
GLenum component_type(TexelFormat format) {
  switch (format) {
    case TexelFormat::rgb16f:
      return GL_HALF_FLOAT;
    case TexelFormat::rgb16:
    case TexelFormat::rgba16:
      return GL_UNSIGNED_SHORT;
    case TexelFormat::rgba16_snorm:
      return GL_SHORT;
    case TexelFormat::rgba8:
      return GL_UNSIGNED_BYTE;
    case TexelFormat::rg_rgtc2:
      return 0;
    default:
      throw std::logic_error("a format whose layers are not uploaded");
  }
}

}  // namespace

void GlTexture::upload_layer(int layer, std::span<const std::byte> texels) {
  assert(layer < layers_);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  if (const GLenum type = component_type(format_); type != 0)
    glTextureSubImage3D(id(), 0, 0, 0, layer, width_, height_, 1,
                        transfer_format(format_, component_count(format_)), type, texels.data());
  else
    glCompressedTextureSubImage3D(id(), 0, 0, 0, layer, width_, height_, 1, row(format_).internal,
                                  GLsizei(texels.size()), texels.data());
}

void GlTexture::bind(unsigned unit) const {
  glBindTextureUnit(unit, id());
}

Image read_back(const GlTexture& texture, int channels) {
  assert(channels >= 1 && channels <= component_count(texture.format()) && texture.layers() == 0);
  Image image(texture.width(), texture.height(), channels);
  const std::size_t row_size = std::size_t(image.width) * std::size_t(channels);
  // In strips: OpenGL counts bytes in 32 bits, and the rows have to be turned over anyway.
  const int strip = std::max(1, int((std::size_t{1} << 22) / row_size));
  std::vector<float> rows(row_size * std::size_t(std::min(strip, image.height)));
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  for (int y = 0; y < image.height; y += strip) {
    const int count = std::min(strip, image.height - y);
    glGetTextureSubImage(texture.id(), 0, 0, y, 0, image.width, count, 1,
                         transfer_format(texture.format(), channels), GL_FLOAT,
                         GLsizei(rows.size() * sizeof(float)), rows.data());
    for (int i = 0; i < count; ++i)
      std::copy_n(rows.begin() + std::ptrdiff_t(row_size * std::size_t(i)), row_size,
                  image.data.begin() + std::ptrdiff_t(row_size * std::size_t(image.height - 1 - y - i)));
  }
  return image;
}

Buffer::Buffer(const void* data, std::size_t bytes) : bytes_(bytes) {
  GLuint id = 0;
  glCreateBuffers(1, &id);
  handle_ = GlHandle<delete_buffer>(id);
  // A buffer of no bytes is an error in OpenGL, and empty scenes are not.
  glNamedBufferStorage(id, GLsizeiptr(bytes == 0 ? 4 : bytes), bytes == 0 ? nullptr : data,
                       GL_DYNAMIC_STORAGE_BIT);
  throw_if_out_of_memory(fmt::format("a buffer of {} bytes", bytes));
}

void Buffer::update(const void* data, std::size_t bytes) {
  assert(bytes <= bytes_);
  glNamedBufferSubData(id(), 0, GLsizeiptr(bytes), data);
}

void Buffer::bind_uniform(unsigned binding) const {
  glBindBufferBase(GL_UNIFORM_BUFFER, binding, id());
}
void Buffer::bind_storage(unsigned binding) const {
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, binding, id());
}

namespace {

// As glDrawArraysIndirect reads it.
struct DrawCommand {
  GLuint vertices = 3;
  GLuint instances = 0;
  GLuint first_vertex = 0;
  GLuint first_instance = 0;
};

}  // namespace

DrawCommands::DrawCommands(std::size_t count) {
  const std::vector<DrawCommand> commands(count);
  buffer_ = Buffer(commands.data(), commands.size() * sizeof(DrawCommand));
}

void DrawCommands::written() const {
  glMemoryBarrier(GL_COMMAND_BARRIER_BIT);
}

void DrawCommands::draw(int command) const {
  glBindBuffer(GL_DRAW_INDIRECT_BUFFER, buffer_.id());
  glDrawArraysIndirect(GL_TRIANGLES,
                       reinterpret_cast<const void*>(std::uintptr_t(command) * sizeof(DrawCommand)));
}

namespace {

struct BufferFormatRow {
  GLenum internal;
  std::size_t bytes;
};
// By value of BufferFormat.
constexpr std::array kBufferFormats{BufferFormatRow{GL_R16UI, 2}, BufferFormatRow{GL_R32UI, 4},
                                    BufferFormatRow{GL_RG32UI, 8}, BufferFormatRow{GL_RGBA8UI, 4}};

}  // namespace

BufferTexture::BufferTexture(BufferFormat format, const void* data, std::size_t entries) {
  const BufferFormatRow& row = kBufferFormats.at(std::size_t(format));
  GLint limit = 0;
  glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &limit);
  if (entries > std::size_t(limit))
    throw Error(fmt::format("a buffer of {} entries; OpenGL reads {} here", entries, limit));
  buffer_ = Buffer(data, entries * row.bytes);
  GLuint id = 0;
  glCreateTextures(GL_TEXTURE_BUFFER, 1, &id);
  texture_ = GlHandle<delete_texture>(id);
  glTextureBuffer(id, row.internal, buffer_.id());
}

void BufferTexture::bind(unsigned unit) const {
  glBindTextureUnit(unit, texture_.id());
}

}  // namespace lightbench
