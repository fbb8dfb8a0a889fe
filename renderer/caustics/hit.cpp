#include "renderer/caustics/hit.h"

#include <glad/gl.h>

#include "renderer/caustics/caustics_shaders.h"
#include "renderer/caustics/level_map.h"
#include "renderer/frame_context.h"

namespace lightbench {
namespace {

constexpr int kBlock = 8;  // of blocks.glsl
constexpr int kRun = 128;  // triangles that one invocation counts and lists

Buffer zeros(std::size_t bytes) {
  const std::vector<std::byte> none(bytes);
  return Buffer(none.data(), bytes);
}

const Program& marching(FrameContext& frame, const char* shader, const HitOptions& options) {
  const Program& program = frame.compute_program(shader);
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

/// The smallest and the largest depth of the receiver in blocks of the position map.
Buffer find_blocks(FrameContext& frame, const ReceiverMap& map) {
  const int along = (map.places.width() + kBlock - 1) / kBlock;
  Buffer blocks = zeros(std::size_t(along) * std::size_t(along) * sizeof(glm::vec2));
  map.places.bind(0);
  blocks.bind_storage(0);
  frame.compute(frame.compute_program(kBlocks), along * along);
  return blocks;
}

/// A whole number of each triangle, as in states.glsl.
Buffer judge(FrameContext& frame, const ReceiverMap& map, const Volumes& volumes, const Buffer& hits,
             const HitOptions& options) {
  const Buffer blocks = find_blocks(frame, map);
  Buffer states = zeros(std::size_t(volumes.triangle_count) * sizeof(std::uint32_t));
  const Program& program = marching(frame, kJudge, options);
  program.set("triangle_count", volumes.triangle_count);
  volumes.places.bind_storage(0);
  hits.bind_storage(1);
  volumes.corners.bind_storage(2);
  states.bind_storage(3);
  blocks.bind_storage(4);
  frame.compute(program, volumes.triangle_count);
  return states;
}

VolumeList list_straddling(FrameContext& frame, const Volumes& volumes, const Buffer& states) {
  VolumeList list(volumes);
  const int runs = (volumes.triangle_count + kRun - 1) / kRun;
  const Buffer counts = zeros(std::size_t(runs) * sizeof(std::uint32_t));
  const Program& count = frame.compute_program(kCountStraddling);
  const Program& write = frame.compute_program(kListStraddling);
  for (const Program* program : {&count, &write}) {
    program->set("triangle_count", volumes.triangle_count);
    program->set("run_length", kRun);
  }
  states.bind_storage(0);
  counts.bind_storage(1);
  frame.compute(count, runs);
  volumes.corners.bind_storage(2);
  list.numbers.bind_storage(3);
  list.corners.bind_storage(4);
  list.command.bind_storage(kDrawVolumesBlock);
  frame.compute(write, runs);
  return list;
}

void draw_landings(FrameContext& frame, const ReceiverMap& map, const Volumes& volumes, const Buffer& hits,
                   const Buffer& states, const HitOptions& options, const GlTexture& caustics) {
  const Program& program = frame.program(kLandingVertex, kLandingFragment);
  const VertexArray no_attributes;
  const Framebuffer target({&caustics});
  target.bind();
  target.clear_color(0, 0, 0, 0, 0);
  set_adding_state();
  program.use();
  program.set("tolerance", 2 / float(options.slices));
  volumes.set_uniforms(program);
  map.places.bind(0);
  volumes.triangles.bind_storage(0);
  hits.bind_storage(1);
  volumes.corners.bind_storage(2);
  states.bind_storage(3);
  glBindVertexArray(no_attributes.id());
  glDrawArrays(GL_TRIANGLES, 0, 3 * volumes.triangle_count);
}

}  // namespace

GlTexture draw_hits(FrameContext& frame, const ReceiverMap& map, const Volumes& volumes,
                    const HitOptions& options) {
  GlTexture caustics(TexelFormat::rgba32f, map.places.width(), map.places.height());
  map.places.bind(0);
  const Buffer hits = find_hits(frame, volumes, options);
  const Buffer states = judge(frame, map, volumes, hits, options);
  draw_landings(frame, map, volumes, hits, states, options, caustics);
  if (options.straddling == Straddling::split) {
    const VolumeList list = list_straddling(frame, volumes, states);
    add_level_map(frame, map, volumes, options.slices, list, caustics);
  }
  return caustics;
}

}  // namespace lightbench
