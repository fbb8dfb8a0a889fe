#include "renderer/techniques/caustics.h"

#include "renderer/caustics/caustics_cast.h"
#include "renderer/caustics/caustics_params.h"
#include "renderer/caustics/caustics_shaders.h"
#include "renderer/caustics/draw_caustics.h"
#include "renderer/caustics/map_rays.h"
#include "renderer/caustics/receiver_map.h"
#include "renderer/direct_light.h"
#include "renderer/frame_context.h"
#include "renderer/gpu_scene.h"
#include "scene/water.h"

namespace lightbench {
namespace {

/// Those that reach below the water and may be in the picture.
std::vector<std::size_t> receivers(const FrameContext& frame) {
  const Scene& scene = frame.scene();
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < scene.entities.size(); ++i) {
    const Bounds bounds = entity_bounds(scene, i);
    if (bounds.empty() || bounds.min.y > scene.water->height) continue;
    if (may_be_visible(bounds, frame.camera().clip_from_world)) result.push_back(i);
  }
  return result;
}

bool reaches_above_water(const FrameContext& frame) {
  return frame.gpu_scene().bounds().max.y > frame.scene().water->height;
}

void render(FrameContext& frame, const ParamValues& params) {
  const Scene& scene = frame.scene();
  const Water& water = *scene.water;
  const CausticsOptions options = caustics_options(params);
  GBuffer gbuffer;
  frame.pass("g-buffer", [&] {
    GBufferOptions kept;
    kept.entities = true;
    gbuffer = draw_gbuffer(frame, frame.camera(), frame.width(), frame.height(), kept);
  });
  DirectLight direct;
  if (reaches_above_water(frame)) direct = draw_direct_light(frame, gbuffer, shadow_options(params));
  CausticsPicture picture(frame, gbuffer);
  frame.pass("unlit", [&] { picture.draw_unlit(direct.lit); });
  const std::vector<std::size_t> lit = receivers(frame);
  Mesh mesh;
  frame.pass("volumes", [&] { mesh = water_mesh(water, scene.time); });
  for (const Light& light : scene.lights) {
    WaterLight through;
    frame.pass("volumes", [&] { through = water_light(water, mesh, light, options.fresnel); });
    for (const std::size_t receiver : lit) {
      const ReceiverBox box = receiver_box(scene, receiver, light);
      MapRays rays;
      ReceiverMap map;
      GlTexture caustics;
      frame.pass("volumes", [&] { rays = map_rays(mesh, through, box, options.culling); });
      frame.pass("position map",
                 [&] { map = draw_receiver_map(frame, box, receiver, options.map_size, options.color); });
      frame.pass("caustics", [&] {
        const Volumes volumes(rays, map, water.absorption, options.least_area);
        caustics = draw_caustics(frame, map, volumes, options);
      });
      frame.pass("cast", [&] { picture.cast(map, caustics); });
    }
  }
  frame.keep_buffer("caustics", picture.landed(), 3);
  frame.set_image(picture.image());
  keep_direct_buffers(frame, gbuffer, direct);
}

std::vector<std::string> unsupported(const Scene& scene, const ParamValues&) {
  if (!scene.water) return {"it has no water"};
  std::vector<std::string> reasons;
  for (const Light& light : scene.lights)
    if (std::string problem = water_light_problem(scene, light); !problem.empty())
      reasons.push_back(std::move(problem));
  return reasons;
}

}  // namespace

Technique caustics_technique() {
  Technique technique;
  technique.name = "caustics";
  technique.doc =
      "Light that waves bend onto what lies in the water, by maps of the receivers along the light instead "
      "of rays.";
  technique.params = caustics_params();
  technique.buffers = {
      {"caustics", "flux that lands for each unit of area across the lights' axes, linear RGB"}};
  technique.shaders = direct_shaders();
  technique.shaders.insert(technique.shaders.end(), kCausticsShaders.begin(), kCausticsShaders.end());
  technique.shows_water = true;
  technique.unsupported = unsupported;
  technique.render = render;
  return technique;
}

}  // namespace lightbench
