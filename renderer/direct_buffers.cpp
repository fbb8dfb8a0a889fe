#include "renderer/frame_context.h"

namespace lightbench {
namespace {

// World normals of the pixels that show an object, 0 elsewhere: what the G-buffer stores is encoded.
Image decoded_normals(FrameContext& frame, const GBuffer& gbuffer) {
  const GlTexture decoded(TexelFormat::rgba32f, gbuffer.width, gbuffer.height);
  const Framebuffer target({&decoded});
  gbuffer.bind();
  frame.draw_fullscreen(
      target, frame.fullscreen_program("shaders/decode_normals.frag.glsl", gbuffer_defines(gbuffer)));
  return read_back(decoded, 3);
}

Image scene_depths(const GBuffer& gbuffer) {
  Image depths = read_back(gbuffer.depth, 1);
  for (float& depth : depths.data) depth *= gbuffer.camera.far;
  return depths;
}

}  // namespace

std::vector<BufferSpec> direct_buffers() {
  return {
      {"albedo", "diffuse reflectance, linear RGB; 0 on the background"},
      {"normal",
       "shading normal in world space towards the viewer, each component -1..1; 0 on the background"},
      {"depth", "distance along the view direction in scene units; 0 on the background"},
      {"shadow", "mean over the lights of the visible share, 0..1; 1 on the background"},
      {"direct", "emission and direct light, linear RGBA; alpha is coverage by objects"},
  };
}

std::vector<std::string> direct_shaders() {
  return {"shaders/surface.vert.glsl",        "shaders/surface.frag.glsl",    "shaders/fullscreen.vert.glsl",
          "shaders/direct.frag.glsl",         "shaders/caster.vert.glsl",     "shaders/caster.frag.glsl",
          "shaders/shadow_bounds.frag.glsl",  "shaders/esm_depth.frag.glsl",  "shaders/esm_blur.frag.glsl",
          "shaders/decode_normals.frag.glsl", "shaders/depth_range.frag.glsl"};
}

DirectLightOutputs wanted_outputs(const FrameContext& frame) {
  DirectLightOutputs outputs;
  outputs.visibility = frame.wants("shadow");
  return outputs;
}

void keep_direct_buffers(FrameContext& frame, const GBuffer& gbuffer, const DirectLight& direct) {
  frame.keep_buffer("albedo", gbuffer.albedo, 3);
  if (frame.wants("normal")) frame.keep_buffer("normal", decoded_normals(frame, gbuffer));
  if (frame.wants("depth")) frame.keep_buffer("depth", scene_depths(gbuffer));
  if (frame.wants("shadow")) frame.keep_buffer("shadow", direct.visibility, 1);
  frame.keep_buffer("direct", direct.lit, 4);
}

}  // namespace lightbench
