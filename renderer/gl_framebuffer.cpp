#include "renderer/gl_framebuffer.h"

#include <array>
#include <cassert>
#include <stdexcept>
#include <vector>

#include <fmt/format.h>
#include <glad/gl.h>

namespace lightbench {
namespace {

GLuint make_framebuffer() {
  GLuint id = 0;
  glCreateFramebuffers(1, &id);
  return id;
}

bool is_depth_format(TexelFormat format) {
  return format == TexelFormat::depth32f || format == TexelFormat::depth32f_stencil8;
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

void delete_vertex_array(unsigned id) {
  glDeleteVertexArrays(1, &id);
}
void delete_framebuffer(unsigned id) {
  glDeleteFramebuffers(1, &id);
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

Framebuffer Framebuffer::layer(const GlTexture& array, int layer, const GlTexture* depth) {
  Framebuffer result;
  result.handle_ = GlHandle<delete_framebuffer>(make_framebuffer());
  result.width_ = array.width();
  result.height_ = array.height();
  const bool is_depth = is_depth_format(array.format());
  const GLenum attachment = is_depth ? depth_attachment(array) : GLenum{GL_COLOR_ATTACHMENT0};
  glNamedFramebufferTextureLayer(result.id(), attachment, array.id(), 0, layer);
  glNamedFramebufferDrawBuffer(result.id(), is_depth ? GL_NONE : GL_COLOR_ATTACHMENT0);
  if (depth) glNamedFramebufferTexture(result.id(), depth_attachment(*depth), depth->id(), 0);
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
