#include "renderer/caustics/hit.h"

#include <glad/gl.h>

#include "renderer/caustics/caustics_shaders.h"
#include "renderer/caustics/map_blocks.h"
#include "renderer/frame_context.h"

namespace lightbench {
namespace {

Buffer zeros(std::size_t bytes) {
  const std::vector<std::byte> none(bytes);
  return Buffer(none.data(), bytes);
}

const Program& marching(FrameContext& frame, const char* shader, const HitOptions& options,
                        const ShaderDefines& defines = {}) {
  const Program& program = frame.compute_program(shader, defines);
  program.set("steps", options.steps);
  program.set("tolerance", 1 / float(options.slices));
  return program;
}

/// Four floats of each ray: place in the map, depth, way; 0 where it does not land.
Buffer find_hits(FrameContext& frame, const Volumes& volumes, const HitOptions& options) {
  Buffer hits = zeros(std::size_t(volumes.ray_count) * sizeof(glm::vec4));
  const Program& program = marching(frame, kHits, options);
  program.set("ray_count", volumes.ray_count);
  volumes.places.bind_storage(0);
  volumes.ways.bind_storage(1);
  hits.bind_storage(2);
  frame.compute(program, volumes.ray_count);
  return hits;
}

/// How each triangle lights the receiver, as in lights.glsl.
Buffer judge(FrameContext& frame, const ReceiverMap& map, const Volumes& volumes, const Buffer& hits,
             const HitOptions& options) {
  const bool splits = options.straddling == Straddling::split;
  Buffer blocks;
  if (splits) blocks = map_blocks(frame, map, options.slices);
  Buffer lights = zeros(std::size_t(volumes.triangle_count) * sizeof(glm::vec2));
  const Program& program =
      marching(frame, kJudge, options, splits ? ShaderDefines{"SPLITS"} : ShaderDefines{});
  program.set("triangle_count", volumes.triangle_count);
  hits.bind_storage(1);
  volumes.corners.bind_storage(2);
  lights.bind_storage(3);
  if (splits) {
    program.set("slices", options.slices);
    volumes.places.bind_storage(0);
    blocks.bind_storage(kMapBlocksBlock);
  }
  frame.compute(program, volumes.triangle_count);
  return lights;
}

/// Those that land, where their corners do.
void draw_landings(FrameContext& frame, const Volumes& volumes, const Buffer& hits,
                   const HitOptions& options) {
  const Program& program = frame.program(kLandingVertex, kLandingFragment, volumes.defines());
  program.use();
  program.set("tolerance", 2 / float(options.slices));
  volumes.set_uniforms(program);
  hits.bind_storage(1);
  volumes.places.bind_storage(6);
  glDrawArrays(GL_TRIANGLES, 0, 3 * volumes.triangle_count);
}

/// Those that straddle surfaces, on each texel at its own depth.
void draw_sweeps(FrameContext& frame, const Volumes& volumes) {
  const Program& program = frame.program(kSweepVertex, kSweepFragment, volumes.defines());
  program.use();
  volumes.set_uniforms(program);
  volumes.places.bind_storage(1);
  glDrawArrays(GL_TRIANGLES, 0, 6 * volumes.triangle_count);
}

}  // namespace

GlTexture draw_hits(FrameContext& frame, const ReceiverMap& map, const Volumes& volumes,
                    const HitOptions& options) {
  GlTexture caustics(TexelFormat::rgba32f, map.places.width(), map.places.height());
  map.places.bind(0);
  const Buffer hits = find_hits(frame, volumes, options);
  const Buffer lights = judge(frame, map, volumes, hits, options);
  const VertexArray no_attributes;
  const Framebuffer target({&caustics});
  target.bind();
  target.clear_color(0, 0, 0, 0, 0);
  set_adding_state();
  glBindVertexArray(no_attributes.id());
  map.places.bind(0);
  volumes.triangles.bind_storage(0);
  volumes.corners.bind_storage(2);
  lights.bind_storage(3);
  volumes.ways.bind_storage(4);
  volumes.spots.bind_storage(5);
  draw_landings(frame, volumes, hits, options);
  if (options.straddling == Straddling::split) draw_sweeps(frame, volumes);
  return caustics;
}

}  // namespace lightbench
