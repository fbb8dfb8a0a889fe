#include "renderer/caustics/receiver_map.h"

#include <algorithm>

#include <glad/gl.h>
#include <glm/geometric.hpp>

#include "renderer/caustics/caustics_shaders.h"
#include "renderer/frame_context.h"
#include "renderer/gpu_scene.h"
#include "scene/water.h"

namespace lightbench {
namespace {

/// How far the scene reaches over a box and below its far side, in its depths.
struct Reach {
  double over = 0;
  double below = 0;
};

Reach reach_of(const ReceiverBox& box, const Bounds& scene) {
  Reach reach;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 point((corner & 1) != 0 ? scene.max.x : scene.min.x,
                           (corner & 2) != 0 ? scene.max.y : scene.min.y,
                           (corner & 4) != 0 ? scene.max.z : scene.min.z);
    const double depth = box.to_map(point).z;
    reach.over = std::max(reach.over, -1.001 * depth);
    reach.below = std::max(reach.below, 1.001 * (depth - 1));
  }
  return reach;
}

/// A view along the box's axis between two depths in it; nearer to the light is greater, as elsewhere.
glm::dmat4 clip_from_world(const ReceiverBox& box, double near, double far) {
  const double range = far - near;
  const auto row = [&](const glm::dvec3& axis, double offset) {
    return glm::dvec4(axis, offset - glm::dot(axis, box.center));
  };
  // x and y: 2 p - 1, which is 0 at the centre; z: (far - depth) / range, the centre's depth being a half.
  return glm::transpose(glm::dmat4(row(2.0 / box.size.x * box.u, 0), row(2.0 / box.size.z * box.w, 0),
                                   row(1 / (range * box.size.y) * box.v, (far - 0.5) / range),
                                   glm::dvec4(0, 0, 0, 1)));
}

struct ReceiverPrograms {
  const Program& solid;
  const Program& cutout;
};

ReceiverPrograms receiver_programs(FrameContext& frame, const ReceiverMap& map, ShaderDefines defines) {
  const Program& solid = frame.program(kReceiverVertex, kReceiverFragment, defines);
  defines.emplace_back("CUTOUT");
  const Program& cutout = frame.program(kReceiverVertex, kReceiverFragment, defines);
  // Positions come relative to the middle of the box, where its depth is a half.
  const glm::vec4 depth_row(-map.box.v / map.box.size.y, 0.5);
  const auto water_top = float(highest_crest(*frame.scene().water) - map.box.center.y);
  for (const Program* program : {&solid, &cutout}) {
    program->set("depth_in_box", depth_row);
    program->set("water_top", water_top);
    program->set("receiver", int(map.receiver));
    program->set("map_size", float(map.places.width()));
  }
  return {solid, cutout};
}

constexpr float kNoExit = -1e30f;
constexpr unsigned kPlacesUnit = 7;  // of receiver.frag.glsl, after those of materials

/// The box's depth is written as it is. Triangles that reach beyond what is drawn are not cut there, so that
/// they are interpolated to the same bits by the whole box and by its slices.
class MapState {
 public:
  MapState() {
    set_surface_state();
    glDepthFunc(GL_LESS);
    glDisable(GL_STENCIL_TEST);
    glEnable(GL_DEPTH_CLAMP);
  }
  MapState(const MapState&) = delete;
  MapState& operator=(const MapState&) = delete;
  ~MapState() { glDisable(GL_DEPTH_CLAMP); }
};

}  // namespace

ReceiverMap draw_receiver_map(FrameContext& frame, const ReceiverBox& box, std::size_t receiver, int size,
                              ReceiverColor color) {
  const bool colored = color == ReceiverColor::map;
  ReceiverMap map{box, receiver, GlTexture(TexelFormat::rgba32f, size, size), {}};
  if (colored) map.diffuse = GlTexture(TexelFormat::rgba16f, size, size);
  const GlTexture depth(TexelFormat::depth32f, size, size);
  const Framebuffer target =
      colored ? Framebuffer({&map.places, &map.diffuse}, &depth) : Framebuffer({&map.places}, &depth);
  target.bind();
  target.clear_color(0, 2, -4, 0, 0);  // no entity
  if (colored) target.clear_color(1, 0, 0, 0, 0);
  target.clear_depth(1);
  const MapState state;
  const auto [solid, cutout] =
      receiver_programs(frame, map, colored ? ShaderDefines{"WITH_DIFFUSE"} : ShaderDefines{});
  const double over = reach_of(box, frame.gpu_scene().bounds()).over;
  frame.gpu_scene().draw_surfaces(solid, cutout, clip_from_world(box, -over, 1), box.center,
                                  FrustumCulling::on);
  return map;
}

GlTexture draw_exits(FrameContext& frame, const ReceiverMap& map) {
  const int size = map.places.width();
  GlTexture exits(TexelFormat::r32f, size, size);
  const GlTexture depth(TexelFormat::depth32f, size, size);
  const Framebuffer target({&exits}, &depth);
  target.bind();
  target.clear_color(0, kNoExit, 0, 0, 0);
  target.clear_depth(1);
  const MapState state;
  const auto [solid, cutout] = receiver_programs(frame, map, {"EXITS"});
  map.places.bind(kPlacesUnit);
  const Reach reach = reach_of(map.box, frame.gpu_scene().bounds());
  frame.gpu_scene().draw_surfaces(solid, cutout, clip_from_world(map.box, -reach.over, 1 + reach.below),
                                  map.box.center, FrustumCulling::on);
  return exits;
}

void draw_slice(FrameContext& frame, const ReceiverMap& map, const Slice& slice, const Framebuffer& target,
                FrustumCulling culling) {
  target.bind();
  target.clear_color(0, 0, 0, 0, 0);
  target.clear_depth(1);
  const MapState state;
  const auto [solid, cutout] = receiver_programs(frame, map, {"SLICE"});
  for (const Program* program : {&solid, &cutout}) {
    program->set("slice", slice.plane);
    program->set("slices", float(slice.slices));
  }
  // A little more than what is nearest to the plane.
  const double over = reach_of(map.box, frame.gpu_scene().bounds()).over, half = 0.501 / slice.slices;
  const double depth = double(slice.plane) / slice.slices;
  const double near = slice.plane == 0 ? -over : depth - half;
  frame.gpu_scene().draw_surfaces(solid, cutout, clip_from_world(map.box, near, depth + half), map.box.center,
                                  culling);
}

GlTexture draw_plane_depths(FrameContext& frame, const ReceiverMap& map, int slices) {
  GlTexture depth(TexelFormat::depth32f, map.places.width(), map.places.height());
  const Program& program = frame.fullscreen_program(kPlaneDepth);
  program.set("slices", float(slices));
  map.places.bind(0);
  DrawOn where;
  where.writes_depth = true;
  frame.draw_fullscreen(Framebuffer({}, &depth), program, Blend::replace, where);
  return depth;
}

}  // namespace lightbench
