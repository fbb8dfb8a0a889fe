#include "renderer/caustics/level_map.h"

#include <cmath>

#include <glad/gl.h>

#include "renderer/caustics/caustics_shaders.h"
#include "renderer/frame_context.h"

namespace lightbench {
namespace {

// Storage blocks of volume.vert.glsl and volume.frag.glsl.
enum Block : unsigned { kTriangles, kPlanes, kListed };

/// Lists the used planes, and has `command` draw as many instances.
Buffer list_used_planes(FrameContext& frame, const ReceiverMap& map, int slices, const Buffer& command) {
  const std::vector<std::uint32_t> none(std::size_t(slices) + 1, 0);
  const Buffer used = buffer_of(none);
  Buffer planes = buffer_of(none);
  const Program& find = frame.compute_program(kUsedPlanes);
  find.set("slices", float(slices));
  map.places.bind(0);
  used.bind_storage(0);
  frame.compute(find, map.places.height());
  const Program& list = frame.compute_program(kListPlanes);
  list.set("plane_count", slices + 1);
  planes.bind_storage(1);
  command.bind_storage(kDrawVolumesBlock);
  frame.compute(list, 1);
  return planes;
}

void set_volume_state(PlaneTest test) {
  set_adding_state();
  if (test == PlaneTest::discard) return;
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_EQUAL);
  glDepthMask(GL_FALSE);
}

void use(const Program& program, const ReceiverMap& map, const Volumes& volumes, int slices) {
  program.use();
  program.set("slices", float(slices));
  volumes.set_uniforms(program);
  volumes.triangles.bind_storage(kTriangles);
  map.places.bind(0);
}

void draw_indirect(const Buffer& command) {
  glBindBuffer(GL_DRAW_INDIRECT_BUFFER, command.id());
  glDrawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_INT, nullptr);
}

void draw_instances(const Volumes& volumes, std::size_t count) {
  glDrawElementsInstanced(GL_TRIANGLES, 3 * volumes.triangle_count, GL_UNSIGNED_INT, nullptr, GLsizei(count));
}

}  // namespace

std::vector<std::uint32_t> used_planes(const ReceiverMap& map, int slices) {
  const Image places = read_back(map.places, 2);
  std::vector<bool> used(std::size_t(slices) + 1, false);
  for (std::size_t i = 0; i < places.data.size(); i += 2)
    if (places.data[i + 1] == 1)
      used.at(std::size_t(std::floor(places.data[i] * float(slices) + 0.5f))) = true;
  std::vector<std::uint32_t> planes;
  for (std::size_t plane = 0; plane < used.size(); ++plane)
    if (used[plane]) planes.push_back(std::uint32_t(plane));
  return planes;
}

GlTexture draw_level_map(FrameContext& frame, const ReceiverMap& map, const Volumes& volumes,
                         const LevelMapOptions& options) {
  GlTexture caustics(TexelFormat::rgba32f, map.places.width(), map.places.height());
  GlTexture plane_depths;
  if (options.test == PlaneTest::equal) plane_depths = draw_plane_depths(frame, map, options.slices);
  DrawVolumes all;
  all.indices = 3 * std::uint32_t(volumes.triangle_count);
  const Buffer command(&all, sizeof all);
  std::vector<std::uint32_t> read;
  Buffer planes;
  if (options.slicing == Slicing::smart) planes = list_used_planes(frame, map, options.slices, command);
  if (options.slicing == Slicing::smart_read_back) {
    read = used_planes(map, options.slices);
    planes = buffer_of(read);
  }
  ShaderDefines defines;
  if (options.test == PlaneTest::discard) defines.emplace_back("PLANE_DISCARD");
  if (options.slicing != Slicing::uniform) defines.emplace_back("LISTED_PLANES");
  const Framebuffer target({&caustics}, options.test == PlaneTest::equal ? &plane_depths : nullptr);
  target.bind();
  target.clear_color(0, 0, 0, 0, 0);
  set_volume_state(options.test);
  use(frame.program(kVolumeVertex, kVolumeFragment, defines), map, volumes, options.slices);
  glBindVertexArray(volumes.vertices.id());
  if (options.slicing != Slicing::uniform) planes.bind_storage(kPlanes);
  switch (options.slicing) {
    case Slicing::smart:
      draw_indirect(command);
      break;
    case Slicing::smart_read_back:
      draw_instances(volumes, read.size());
      break;
    case Slicing::uniform:
      draw_instances(volumes, std::size_t(options.slices) + 1);
      break;
  }
  return caustics;
}

void draw_plane(FrameContext& frame, const ReceiverMap& map, const Volumes& volumes, int plane, int slices,
                const Framebuffer& target) {
  const Program& program = frame.program(kVolumeVertex, kVolumeFragment, {"ONE_PLANE"});
  target.bind();
  set_volume_state(PlaneTest::discard);
  use(program, map, volumes, slices);
  program.set("one_plane", plane);
  glBindVertexArray(volumes.vertices.id());
  draw_instances(volumes, 1);
}

void add_level_map(FrameContext& frame, const ReceiverMap& map, const Volumes& volumes, int slices,
                   const VolumeList& list, const GlTexture& caustics) {
  const GlTexture plane_depths = draw_plane_depths(frame, map, slices);
  const Buffer planes = list_used_planes(frame, map, slices, list.command);
  const Framebuffer target({&caustics}, &plane_depths);
  target.bind();
  set_volume_state(PlaneTest::equal);
  use(frame.program(kVolumeVertex, kVolumeFragment, {"LISTED_PLANES", "LISTED_TRIANGLES"}), map, volumes,
      slices);
  glBindVertexArray(list.vertices.id());
  planes.bind_storage(kPlanes);
  list.numbers.bind_storage(kListed);
  draw_indirect(list.command);
}

}  // namespace lightbench
