#include "renderer/caustics/level_map.h"

#include <cmath>

#include <glad/gl.h>

#include "renderer/caustics/caustics_shaders.h"
#include "renderer/caustics/volume_cuts.h"
#include "renderer/frame_context.h"

namespace lightbench {
namespace {

// Storage blocks of volume.vert.glsl and volume.frag.glsl.
enum Block : unsigned { kTriangles, kPlanes };

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

/// What volume.vert.glsl and volume.frag.glsl are compiled with.
ShaderDefines defines_of(const Volumes& volumes, PlaneTest test, const char* listed) {
  ShaderDefines defines = volumes.defines();
  if (test == PlaneTest::discard) defines.emplace_back("PLANE_DISCARD");
  if (listed) defines.emplace_back(listed);
  return defines;
}

void use(const Program& program, const ReceiverMap& map, const Volumes& volumes, int slices) {
  program.use();
  program.set("slices", float(slices));
  volumes.set_uniforms(program);
  volumes.triangles.bind_storage(kTriangles);
  map.places.bind(0);
}

/// Sets all to draw the volumes once for each of the listed planes, or of all.
void begin_planes(FrameContext& frame, const ReceiverMap& map, const Volumes& volumes,
                  const LevelMapOptions& options, const Framebuffer& target, const Buffer* planes) {
  const char* listed = planes ? "LISTED_PLANES" : nullptr;
  target.bind();
  set_volume_state(options.test);
  use(frame.program(kVolumeVertex, kVolumeFragment, defines_of(volumes, options.test, listed)), map, volumes,
      options.slices);
  glBindVertexArray(volumes.vertices.id());
  if (planes) planes->bind_storage(kPlanes);
}

void draw_instances(const Volumes& volumes, std::size_t count) {
  glDrawElementsInstanced(GL_TRIANGLES, 3 * volumes.triangle_count, GL_UNSIGNED_INT, nullptr, GLsizei(count));
}

/// Each of the volumes by its own planes.
void draw_cuts(FrameContext& frame, const ReceiverMap& map, const Volumes& volumes, int slices,
               PlaneTest test, const Framebuffer& target) {
  const Program& program =
      frame.program(kVolumeVertex, kVolumeFragment, defines_of(volumes, test, "LISTED_CUTS"));
  VolumeCuts cuts(frame, map, volumes, slices);
  target.bind();
  set_volume_state(test);
  while (cuts.list_next()) {
    use(program, map, volumes, slices);
    cuts.draw(program);
  }
}

}  // namespace

std::vector<std::size_t> texels_by_plane(const ReceiverMap& map, int slices) {
  const Image places = read_back(map.places, 4);
  std::vector<std::size_t> texels(std::size_t(slices) + 1, 0);
  for (std::size_t i = 0; i < places.data.size(); i += 4)
    if ((int(places.data[i + 1]) & 1) == 1)  // as shows_receiver of places.glsl
      ++texels.at(std::size_t(std::floor(places.data[i] * float(slices) + 0.5f)));
  return texels;
}

std::vector<std::uint32_t> used_planes(const ReceiverMap& map, int slices) {
  const std::vector<std::size_t> texels = texels_by_plane(map, slices);
  std::vector<std::uint32_t> planes;
  for (std::size_t plane = 0; plane < texels.size(); ++plane)
    if (texels[plane] > 0) planes.push_back(std::uint32_t(plane));
  return planes;
}

GlTexture draw_level_map(FrameContext& frame, const ReceiverMap& map, const Volumes& volumes,
                         const LevelMapOptions& options) {
  GlTexture caustics(TexelFormat::rgba32f, map.places.width(), map.places.height());
  GlTexture plane_depths;
  if (options.test == PlaneTest::equal) plane_depths = draw_plane_depths(frame, map, options.slices);
  const Framebuffer target({&caustics}, options.test == PlaneTest::equal ? &plane_depths : nullptr);
  target.clear_color(0, 0, 0, 0, 0);
  switch (options.slicing) {
    case Slicing::local:
      draw_cuts(frame, map, volumes, options.slices, options.test, target);
      break;
    case Slicing::smart: {
      DrawVolumes all;
      all.indices = 3 * std::uint32_t(volumes.triangle_count);
      const Buffer command(&all, sizeof all);
      const Buffer planes = list_used_planes(frame, map, options.slices, command);
      begin_planes(frame, map, volumes, options, target, &planes);
      glBindBuffer(GL_DRAW_INDIRECT_BUFFER, command.id());
      glDrawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_INT, nullptr);
      break;
    }
    case Slicing::smart_read_back: {
      const std::vector<std::uint32_t> used = used_planes(map, options.slices);
      const Buffer planes = buffer_of(used);
      begin_planes(frame, map, volumes, options, target, &planes);
      draw_instances(volumes, used.size());
      break;
    }
    case Slicing::uniform:
      begin_planes(frame, map, volumes, options, target, nullptr);
      draw_instances(volumes, std::size_t(options.slices) + 1);
      break;
  }
  return caustics;
}

void draw_plane(FrameContext& frame, const ReceiverMap& map, const Volumes& volumes, int plane, int slices,
                const Framebuffer& target) {
  const Program& program = frame.program(kVolumeVertex, kVolumeFragment, volumes.defines({"ONE_PLANE"}));
  target.bind();
  set_volume_state(PlaneTest::discard);
  use(program, map, volumes, slices);
  program.set("one_plane", plane);
  glBindVertexArray(volumes.vertices.id());
  draw_instances(volumes, 1);
}

}  // namespace lightbench
