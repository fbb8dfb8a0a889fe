#include "renderer/gbuffer.h"

#include <glad/gl.h>
#include <glm/vec4.hpp>

#include "renderer/frame_context.h"
#include "renderer/gpu_scene.h"

namespace lightbench {
namespace {

// The block Frame of shaders/frame.glsl, std140.
struct FrameBlock {
  glm::vec4 camera_position;
  glm::vec4 far_corner;
  glm::vec4 far_u;
  glm::vec4 far_v;
  glm::vec4 camera_forward;
  glm::vec4 frame_size;
  glm::vec4 half_angles;
  glm::mat4 clip_from_world;
};
static_assert(sizeof(FrameBlock) == 7 * 16 + 64);

void clear(const Framebuffer& target, const glm::vec3& background) {
  for (int attachment = 0; attachment < 5; ++attachment) target.clear_color(attachment, 0, 0, 0, 0);
  target.clear_color(5, background.r, background.g, background.b, 0);
  target.clear_depth_stencil(0, 0);
}

}  // namespace

Buffer camera_block(const FrameCamera& camera, int width, int height) {
  const glm::vec2 size(width, height);
  const FrameBlock block{
      glm::vec4(camera.position, camera.far),
      glm::vec4(camera.far_corner, 0),
      glm::vec4(camera.far_u, 0),
      glm::vec4(camera.far_v, 0),
      glm::vec4(camera.frame.forward, camera.near),
      glm::vec4(size, 1.0f / size),
      glm::vec4(camera.tan_half_x, camera.tan_half_y, 2 * camera.tan_half_y / size.y, 0),
      glm::mat4(camera.clip_from_world),
  };
  return Buffer(&block, sizeof block);
}

GBuffer make_gbuffer(const FrameCamera& camera, int width, int height, NormalFormat normals) {
  GBuffer g;
  g.camera = camera;
  g.width = width;
  g.height = height;
  g.normal_format = normals;
  g.albedo = GlTexture(TexelFormat::rgba16f, width, height);
  g.normal = GlTexture(normals == NormalFormat::rgb8 ? TexelFormat::rgba8 : TexelFormat::rg16, width, height);
  g.geometric_normal = GlTexture(TexelFormat::rg16, width, height);
  g.depth = GlTexture(TexelFormat::r32f, width, height);
  g.specular = GlTexture(TexelFormat::rg16f, width, height);
  g.emission = GlTexture(TexelFormat::rgba32f, width, height);
  g.depth_stencil = GlTexture(TexelFormat::depth32f_stencil8, width, height);
  g.camera_block = camera_block(camera, width, height);
  return g;
}

Framebuffer surface_target(const GBuffer& g) {
  if (g.entities.id() != 0)
    return Framebuffer(
        {&g.albedo, &g.normal, &g.depth, &g.specular, &g.geometric_normal, &g.emission, &g.entities},
        &g.depth_stencil);
  return Framebuffer({&g.albedo, &g.normal, &g.depth, &g.specular, &g.geometric_normal, &g.emission},
                     &g.depth_stencil);
}

// Nearer is greater in reversed depth.
void set_surface_state() {
  glDisable(GL_BLEND);
  glDisable(GL_CULL_FACE);
  glDisable(GL_SCISSOR_TEST);
  glEnable(GL_DEPTH_TEST);
  glDepthMask(GL_TRUE);
  glDepthFunc(GL_GREATER);
  glEnable(GL_STENCIL_TEST);
  glStencilMask(0xff);
  glStencilFunc(GL_ALWAYS, 1, 0xff);
  glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
}

void GBuffer::bind() const {
  unsigned unit = 0;
  for (const GlTexture* texture : {&albedo, &normal, &depth, &specular, &geometric_normal, &emission})
    texture->bind(unit++);
  camera_block.bind_uniform(0);
  if (tile_block.id() != 0) tile_block.bind_uniform(2);
}

std::vector<std::string> gbuffer_defines(const GBuffer& gbuffer) {
  std::vector<std::string> defines;
  if (gbuffer.normal_format == NormalFormat::rgb8) defines.emplace_back("NORMALS_RGB8");
  if (gbuffer.tile_block.id() != 0) defines.emplace_back("TILED");
  return defines;
}

GBuffer draw_gbuffer(FrameContext& frame, const FrameCamera& camera, int width, int height,
                     const GBufferOptions& options) {
  GBuffer g = make_gbuffer(camera, width, height, options.normals);
  ShaderDefines defines = gbuffer_defines(g);
  if (options.entities) {
    g.entities = GlTexture(TexelFormat::r32f, width, height);
    defines.emplace_back("WITH_ENTITIES");
  }
  if (options.ceiling) defines.emplace_back("WITH_CEILING");
  const Framebuffer target = surface_target(g);
  const Program& solid = frame.program("shaders/surface.vert.glsl", "shaders/surface.frag.glsl", defines);
  defines.emplace_back("CUTOUT");
  const Program& cutout = frame.program("shaders/surface.vert.glsl", "shaders/surface.frag.glsl", defines);
  if (options.ceiling)
    for (const Program* program : {&solid, &cutout})
      program->set("ceiling", *options.ceiling - camera.position.y);
  target.bind();
  clear(target, frame.scene().background.color);
  if (options.entities) target.clear_color(6, 0, 0, 0, 0);
  set_surface_state();
  g.camera_block.bind_uniform(0);
  frame.gpu_scene().draw_surfaces(solid, cutout, camera.clip_from_world, glm::dvec3(camera.position),
                                  options.culling);
  return g;
}

}  // namespace lightbench
