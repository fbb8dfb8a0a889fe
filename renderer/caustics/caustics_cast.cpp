#include "renderer/caustics/caustics_cast.h"

#include "renderer/caustics/caustics_shaders.h"
#include "renderer/frame_context.h"
#include "renderer/gpu_scene.h"

namespace lightbench {
namespace {

// Texture units after those of the G-buffer.
enum Unit : unsigned { kEntities = 6, kPlaces, kCaustics, kDiffuse };

}  // namespace

CausticsPicture::CausticsPicture(FrameContext& frame, const GBuffer& gbuffer)
    : frame_(frame),
      gbuffer_(gbuffer),
      image_(TexelFormat::rgba32f, gbuffer.width, gbuffer.height, Filter::linear),
      landed_(TexelFormat::rgba32f, gbuffer.width, gbuffer.height) {}

void CausticsPicture::draw_unlit(const GlTexture& direct) {
  const Water& water = *frame_.scene().water;
  const Framebuffer landed({&landed_});
  landed.clear_color(0, 0, 0, 0, 0);
  ShaderDefines defines = gbuffer_defines(gbuffer_);
  if (direct.id() != 0) defines.emplace_back("WITH_DRY");
  const Program& program = frame_.fullscreen_program(kUnlit, defines);
  program.set("water_height", water.height);
  program.set("ambient", water.ambient);
  gbuffer_.bind();
  if (direct.id() != 0) direct.bind(6);
  frame_.draw_fullscreen(Framebuffer({&image_}), program);
}

void CausticsPicture::cast(const ReceiverMap& map, const GlTexture& caustics) {
  const bool map_color = map.diffuse.id() != 0;
  ShaderDefines defines = gbuffer_defines(gbuffer_);
  if (map_color) defines.emplace_back("MAP_COLOR");
  const Program& program = frame_.fullscreen_program(kCast, defines);
  const ReceiverBox& box = map.box;
  program.set("receiver", int(map.receiver));
  program.set("box_center", glm::vec3(box.center - glm::dvec3(gbuffer_.camera.position)));
  program.set("box_u", glm::vec3(box.u));
  program.set("box_v", glm::vec3(box.v));
  program.set("box_w", glm::vec3(box.w));
  program.set("box_size", glm::vec3(box.size));
  gbuffer_.bind();
  gbuffer_.entities.bind(kEntities);
  map.places.bind(kPlaces);
  caustics.bind(kCaustics);
  if (map_color) map.diffuse.bind(kDiffuse);
  DrawOn where = kObjects;
  where.pixels = pixels_of_box(frame_.gpu_scene().entity_bounds(map.receiver),
                               gbuffer_.camera.clip_from_world, {gbuffer_.width, gbuffer_.height});
  frame_.draw_fullscreen(Framebuffer({&image_, &landed_}, &gbuffer_.depth_stencil), program, Blend::add,
                         where);
}

}  // namespace lightbench
