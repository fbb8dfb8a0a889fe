#include "renderer/gl_objects.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <stdexcept>
#include <vector>

#include <fmt/format.h>
#include <glad/gl.h>

#include "renderer/gl_context.h"

namespace lightbench {
namespace {

struct FormatRow {
  TexelFormat format;
  GLenum internal;
  int components;
};

constexpr std::array kFormats{
    FormatRow{TexelFormat::r8, GL_R8, 1},
    FormatRow{TexelFormat::rgba8, GL_RGBA8, 4},
    FormatRow{TexelFormat::srgb8_alpha8, GL_SRGB8_ALPHA8, 4},
    FormatRow{TexelFormat::rg16, GL_RG16, 2},
    FormatRow{TexelFormat::rgba16, GL_RGBA16, 4},
    FormatRow{TexelFormat::r16f, GL_R16F, 1},
    FormatRow{TexelFormat::rg16f, GL_RG16F, 2},
    FormatRow{TexelFormat::rgba16f, GL_RGBA16F, 4},
    FormatRow{TexelFormat::r32f, GL_R32F, 1},
    FormatRow{TexelFormat::rg32f, GL_RG32F, 2},
    FormatRow{TexelFormat::rgba32f, GL_RGBA32F, 4},
    FormatRow{TexelFormat::depth32f, GL_DEPTH_COMPONENT32F, 1},
    FormatRow{TexelFormat::depth32f_stencil8, GL_DEPTH32F_STENCIL8, 1},
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
  const GLint edge = wrap == Wrap::repeat ? GL_REPEAT : GL_CLAMP_TO_EDGE;
  glTextureParameteri(id, GL_TEXTURE_MIN_FILTER, mode);
  glTextureParameteri(id, GL_TEXTURE_MAG_FILTER, mode);
  glTextureParameteri(id, GL_TEXTURE_WRAP_S, edge);
  glTextureParameteri(id, GL_TEXTURE_WRAP_T, edge);
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

}  // namespace

int component_count(TexelFormat format) {
  return row(format).components;
}

void delete_texture(unsigned id) {
  glDeleteTextures(1, &id);
}
void delete_buffer(unsigned id) {
  glDeleteBuffers(1, &id);
}
void delete_vertex_array(unsigned id) {
  glDeleteVertexArrays(1, &id);
}
void delete_framebuffer(unsigned id) {
  glDeleteFramebuffers(1, &id);
}

GlTexture::GlTexture(TexelFormat format, int width, int height, Filter filter, Wrap wrap)
    : format_(format), width_(width), height_(height) {
  GLuint id = 0;
  glCreateTextures(GL_TEXTURE_2D, 1, &id);
  handle_ = GlHandle<delete_texture>(id);
  glTextureStorage2D(id, 1, row(format).internal, width, height);
  throw_if_out_of_memory(fmt::format("a texture of {} x {} texels", width, height));
  set_sampling(id, filter, wrap);
}

GlTexture GlTexture::array(TexelFormat format, int width, int height, int layers) {
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
  set_sampling(id, Filter::nearest, Wrap::clamp);
  return texture;
}

void GlTexture::upload(const std::vector<std::uint16_t>& texels) {
  assert(texels.size() == std::size_t(width_) * std::size_t(height_) * 4 && component_count(format_) == 4);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTextureSubImage2D(id(), 0, 0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_SHORT,
                      flipped(texels, height_).data());
}

void GlTexture::upload(const Image& pixels) {
  assert(pixels.width == width_ && pixels.height == height_ && pixels.channels == component_count(format_));
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTextureSubImage2D(id(), 0, 0, 0, width_, height_, transfer_format(format_, pixels.channels), GL_FLOAT,
                      flipped(pixels.data, height_).data());
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

VertexArray::VertexArray() {
  GLuint id = 0;
  glCreateVertexArrays(1, &id);
  handle_ = GlHandle<delete_vertex_array>(id);
}

void VertexArray::attribute(unsigned location, const Buffer& buffer, int components) {
  glVertexArrayVertexBuffer(id(), location, buffer.id(), 0, GLsizei(components * int(sizeof(float))));
  glVertexArrayAttribFormat(id(), location, components, GL_FLOAT, GL_FALSE, 0);
  glVertexArrayAttribBinding(id(), location, location);
  glEnableVertexArrayAttrib(id(), location);
}

void VertexArray::indices(const Buffer& buffer) {
  glVertexArrayElementBuffer(id(), buffer.id());
}

namespace {

GLuint make_framebuffer() {
  GLuint id = 0;
  glCreateFramebuffers(1, &id);
  return id;
}

GLenum depth_attachment(const GlTexture& depth) {
  return depth.format() == TexelFormat::depth32f_stencil8 ? GL_DEPTH_STENCIL_ATTACHMENT : GL_DEPTH_ATTACHMENT;
}

void require_complete(GLuint id) {
  const GLenum status = glCheckNamedFramebufferStatus(id, GL_FRAMEBUFFER);
  if (status != GL_FRAMEBUFFER_COMPLETE)
    throw std::logic_error(fmt::format("a framebuffer is incomplete: 0x{:04x}", status));
}

}  // namespace

Framebuffer::Framebuffer(std::initializer_list<const GlTexture*> colors, const GlTexture* depth)
    : handle_(make_framebuffer()) {
  std::vector<GLenum> targets;
  for (const GlTexture* color : colors) {
    targets.push_back(GL_COLOR_ATTACHMENT0 + GLenum(targets.size()));
    glNamedFramebufferTexture(id(), targets.back(), color->id(), 0);
  }
  glNamedFramebufferDrawBuffers(id(), GLsizei(targets.size()), targets.data());
  if (depth) glNamedFramebufferTexture(id(), depth_attachment(*depth), depth->id(), 0);
  const GlTexture* sized = colors.size() > 0 ? *colors.begin() : depth;
  assert(sized);
  width_ = sized->width();
  height_ = sized->height();
  require_complete(id());
}

Framebuffer Framebuffer::layer(const GlTexture& array, int layer) {
  Framebuffer result;
  result.handle_ = GlHandle<delete_framebuffer>(make_framebuffer());
  result.width_ = array.width();
  result.height_ = array.height();
  const bool is_depth = transfer_format(array.format(), 1) == GL_DEPTH_COMPONENT;
  const GLenum attachment = is_depth ? depth_attachment(array) : GLenum{GL_COLOR_ATTACHMENT0};
  glNamedFramebufferTextureLayer(result.id(), attachment, array.id(), 0, layer);
  glNamedFramebufferDrawBuffer(result.id(), is_depth ? GL_NONE : GL_COLOR_ATTACHMENT0);
  require_complete(result.id());
  return result;
}

void Framebuffer::bind() const {
  glBindFramebuffer(GL_FRAMEBUFFER, id());
  glViewport(0, 0, width_, height_);
}

void Framebuffer::clear_color(int attachment, float r, float g, float b, float a) const {
  const std::array<float, 4> value{r, g, b, a};
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glClearNamedFramebufferfv(id(), GL_COLOR, attachment, value.data());
}

void Framebuffer::clear_depth(float depth) const {
  glDepthMask(GL_TRUE);
  glClearNamedFramebufferfv(id(), GL_DEPTH, 0, &depth);
}

void Framebuffer::clear_depth_stencil(float depth, int stencil) const {
  glDepthMask(GL_TRUE);
  glStencilMask(0xff);
  glClearNamedFramebufferfi(id(), GL_DEPTH_STENCIL, 0, depth, stencil);
}

}  // namespace lightbench
