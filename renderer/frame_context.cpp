#include "renderer/frame_context.h"

#include <algorithm>
#include <cassert>

#include <glad/gl.h>

#include "base/stopwatch.h"
#include "renderer/gpu_scene.h"
#include "renderer/radiance/radiance_cache.h"
#include "renderer/shadow_map.h"

namespace lightbench {
namespace {

FrameCamera camera_of(const FrameRequest& request) {
  const Camera& camera = request.view.camera;
  return frame_camera(camera, float(request.width) / float(request.height),
                      depth_range(request.scene, camera));
}

Image enlarged(const Image& image, int width, int height) {
  if (image.width == width && image.height == height) return image;
  Image result(width, height, image.channels);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const auto from = image.pixel(int(std::int64_t{x} * image.width / width),
                                    int(std::int64_t{y} * image.height / height));
      std::copy(from.begin(), from.end(), result.pixel(x, y).begin());
    }
  return result;
}

}  // namespace

GpuState::GpuState()
    : shadow_textures(std::make_unique<ShadowTextures>()),
      radiance_cache(std::make_unique<RadianceCache>()) {}
GpuState::~GpuState() = default;

FrameContext::FrameContext(const FrameRequest& request, GpuState* gpu, const GpuScene* scene)
    : request_(request), gpu_(gpu), gpu_scene_(scene), camera_(camera_of(request)) {}

const Program& FrameContext::program(const std::string& vertex, const std::string& fragment,
                                     const ShaderDefines& defines) {
  assert(gpu_);
  used_shaders_.insert({vertex, fragment});
  return gpu_->programs.get(vertex, fragment, defines);
}

const Program& FrameContext::fullscreen_program(const std::string& fragment, const ShaderDefines& defines) {
  return program("shaders/fullscreen.vert.glsl", fragment, defines);
}

const Program& FrameContext::compute_program(const std::string& shader, const ShaderDefines& defines) {
  assert(gpu_);
  used_shaders_.insert(shader);
  return gpu_->programs.get_compute(shader, defines);
}

void FrameContext::compute(const Program& program, int invocations) {
  program.use();
  glDispatchCompute(GLuint((invocations + kComputeGroup - 1) / kComputeGroup), 1, 1);
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT |
                  GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT | GL_ELEMENT_ARRAY_BARRIER_BIT);
}

void FrameContext::pass(const std::string& name, const std::function<void()>& draw) {
  glFinish();
  const Stopwatch watch;
  draw();
  glFinish();
  add_pass_time(name, watch.seconds());
}

void FrameContext::add_pass_time(const std::string& name, double seconds) {
  for (PassTime& pass : result_.passes)
    if (pass.name == name) {
      pass.seconds += seconds;
      return;
    }
  result_.passes.push_back({name, seconds});
}

void FrameContext::draw_fullscreen(const Framebuffer& target, const Program& program, Blend blend,
                                   const DrawOn& where) {
  target.bind();
  program.use();
  glDisable(GL_CULL_FACE);
  if (where.writes_depth) {
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_ALWAYS);
    glDepthMask(GL_TRUE);
  } else {
    glDisable(GL_DEPTH_TEST);
  }
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  if (blend == Blend::replace) {
    glDisable(GL_BLEND);
  } else {
    glEnable(GL_BLEND);
    glBlendEquation(GL_FUNC_ADD);
    glBlendFunc(blend == Blend::add ? GL_ONE : GL_ONE_MINUS_DST_ALPHA, GL_ONE);
  }
  glDisable(GL_SCISSOR_TEST);
  if (where.pixels) {
    glEnable(GL_SCISSOR_TEST);
    glScissor(where.pixels->low.x, where.pixels->low.y, where.pixels->size.x, where.pixels->size.y);
  }
  if (where.stencil) {
    glEnable(GL_STENCIL_TEST);
    glStencilFunc(GL_EQUAL, *where.stencil, 0xff);
    glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
  } else {
    glDisable(GL_STENCIL_TEST);
  }
  glBindVertexArray(gpu_->no_vertices.id());
  if (where.commands)
    where.commands->draw(where.command);
  else
    glDrawArrays(GL_TRIANGLES, 0, 3);
  glDisable(GL_SCISSOR_TEST);  // which clears heed, too
}

void FrameContext::keep_buffer(const std::string& name, const GlTexture& texture, int channels) {
  if (wants(name)) keep_buffer(name, read_back(texture, channels));
}

void FrameContext::keep_buffer(const std::string& name, const Image& image) {
  if (wants(name)) result_.buffers[name] = enlarged(image, width(), height());
}

void FrameContext::set_image(const GlTexture& image) {
  set_image(read_back(image, 4));
}

void FrameContext::set_image(Image image) {
  assert(image.channels == 4);
  result_.image = std::move(image);
}

void FrameContext::warn(const std::string& text) {
  if (std::find(result_.warnings.begin(), result_.warnings.end(), text) == result_.warnings.end())
    result_.warnings.push_back(text);
}

}  // namespace lightbench
