#include "renderer/techniques/caustics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "renderer/caustics/caustics_cast.h"
#include "renderer/caustics/caustics_params.h"
#include "renderer/caustics/caustics_shaders.h"
#include "renderer/caustics/draw_caustics.h"
#include "renderer/caustics/map_rays.h"
#include "renderer/caustics/receiver_map.h"
#include "renderer/caustics/water_shade.h"
#include "renderer/caustics/water_view.h"
#include "renderer/direct_light.h"
#include "renderer/frame_context.h"
#include "renderer/gpu_scene.h"
#include "scene/nearest_surface.h"
#include "scene/water.h"

namespace lightbench {
namespace {

/// Those that reach below the water; without its surface, which shows what else is there, those in the
/// picture.
std::vector<std::size_t> receivers(const FrameContext& frame, bool all) {
  const Scene& scene = frame.scene();
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < scene.entities.size(); ++i) {
    const Bounds& bounds = frame.gpu_scene().entity_bounds(i);
    if (bounds.empty() || bounds.min.y > scene.water->height) continue;
    if (all || may_be_visible(bounds, frame.camera().clip_from_world)) result.push_back(i);
  }
  return result;
}

GBuffer draw_surfaces(FrameContext& frame, const FrameCamera& camera, int width, int height,
                      std::optional<float> ceiling = std::nullopt) {
  GBufferOptions options;
  options.entities = true;
  options.ceiling = ceiling;
  return draw_gbuffer(frame, camera, width, height, options);
}

/// What the water's surface shows, to be lit with the picture.
struct BelowWater {
  BelowWater(FrameContext& frame, const Mesh& mesh) : view(frame, mesh) {
    if (!view.camera()) return;
    gbuffer = draw_surfaces(frame, *view.camera(), WaterView::kSize, WaterView::kSize,
                            float(highest_crest(*frame.scene().water)));
    picture.emplace(frame, gbuffer);
    picture->draw_unlit({});
  }

  WaterView view;
  GBuffer gbuffer;
  std::optional<CausticsPicture> picture;
};

/// The longer side in pixels of the rectangle around a box, were the picture without edges; nothing where the
/// box reaches behind the near plane.
std::optional<double> pixels_across(const FrameContext& frame, const Bounds& box) {
  const double infinity = std::numeric_limits<double>::infinity();
  glm::dvec2 low(infinity), high(-infinity);
  for (const glm::vec3& corner : corners(box)) {
    const glm::dvec4 c = frame.camera().clip_from_world * glm::dvec4(corner, 1);
    if (c.z > c.w) return std::nullopt;
    low = glm::min(low, glm::dvec2(c) / c.w);
    high = glm::max(high, glm::dvec2(c) / c.w);
  }
  const glm::dvec2 size = 0.5 * (high - low) * glm::dvec2(frame.width(), frame.height());
  return std::max(size.x, size.y);
}

/// The picture's edges do not count: what they hide of a receiver is sliced along with the rest, and water
/// may show what lies beyond them.
CausticsOptions detailed(const FrameContext& frame, std::size_t receiver, const CausticsOptions& options) {
  if (!options.level_of_detail) return options;
  const auto pixels = pixels_across(frame, frame.gpu_scene().entity_bounds(receiver));
  if (!pixels || *pixels >= options.level_map.slices) return options;
  return with_slices(options, std::max(1, int(std::ceil(*pixels))));
}

void light(FrameContext& frame, const CausticsOptions& options, const Mesh& mesh,
           const std::vector<CausticsPicture*>& pictures) {
  const Scene& scene = frame.scene();
  const Water& water = *scene.water;
  const std::vector<std::size_t> lit = receivers(frame, pictures.size() > 1);
  for (const Light& light : scene.lights) {
    WaterLight through;
    std::optional<GlTexture> shade;
    frame.pass("volumes", [&] {
      through = water_light(water, mesh, light, options.fresnel);
      shade = draw_water_shade(frame, light);
    });
    for (const std::size_t receiver : lit) {
      MapRays rays;
      ReceiverMap map;
      GlTexture caustics;
      ReceiverBox box;
      frame.pass("volumes", [&] {
        box = receiver_box(scene, receiver, light);
        rays = map_rays(mesh, through, box, options.culling);
      });
      std::optional<OccluderMap> occluders;
      frame.pass("position map", [&] {
        map = draw_receiver_map(frame, box, receiver, options.map_size, options.color);
        occluders = draw_occluders(frame, map, rays, options);
      });
      frame.pass("caustics", [&] {
        const Volumes volumes(rays, map, water.absorption, options.least_area, shade ? &*shade : nullptr,
                              occluders ? &*occluders : nullptr);
        caustics = draw_caustics(frame, map, volumes, detailed(frame, receiver, options));
      });
      frame.pass("cast", [&] {
        for (CausticsPicture* picture : pictures) picture->cast(map, caustics);
      });
    }
  }
}

/// Relative to the camera, as the surface's pass leaves it, in the world; 0 where nothing is seen.
Image world_positions(const FrameContext& frame, const GlTexture& seen) {
  const Image relative = read_back(seen, 4);
  Image positions(relative.width, relative.height, 3);
  for (int y = 0; y < relative.height; ++y)
    for (int x = 0; x < relative.width; ++x)
      for (int c = 0; c < 3; ++c)
        if (relative.pixel(x, y)[3] != 0)
          positions.pixel(x, y)[std::size_t(c)] =
              relative.pixel(x, y)[std::size_t(c)] + frame.camera().position[c];
  return positions;
}

void render(FrameContext& frame, const ParamValues& params) {
  const Scene& scene = frame.scene();
  const CausticsOptions options = caustics_options(params);
  GBuffer gbuffer;
  frame.pass("g-buffer",
             [&] { gbuffer = draw_surfaces(frame, frame.camera(), frame.width(), frame.height()); });
  DirectLight direct;
  if (reaches_above_water(frame)) direct = draw_direct_light(frame, gbuffer, shadow_options(params));
  CausticsPicture picture(frame, gbuffer);
  frame.pass("unlit", [&] { picture.draw_unlit(direct.lit); });
  Mesh mesh;
  frame.pass("volumes", [&] { mesh = water_mesh(*scene.water, scene.time); });
  std::optional<BelowWater> below;
  if (options.surface) frame.pass("below the water", [&] { below.emplace(frame, mesh); });
  std::vector<CausticsPicture*> pictures{&picture};
  if (below && below->picture) pictures.push_back(&*below->picture);
  light(frame, options, mesh, pictures);
  if (below && below->picture) {
    GlTexture seen;
    frame.pass("surface",
               [&] { seen = below->view.draw(gbuffer, picture, below->gbuffer, *below->picture); });
    if (frame.wants("through")) frame.keep_buffer("through", world_positions(frame, seen));
  }
  frame.keep_buffer("caustics", picture.landed(), 3);
  frame.set_image(picture.image());
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
  technique.version = 2;
  technique.doc =
      "Light that waves bend onto what lies in the water, by maps of the receivers along the light instead "
      "of rays.";
  technique.params = caustics_params();
  technique.buffers = {
      {"caustics", "flux that lands for each unit of area across the lights' axes, linear RGB"},
      {"through", "where in the world the water's surface shows something, 0 elsewhere"}};
  technique.shaders = direct_shaders();
  technique.shaders.insert(technique.shaders.end(), kCausticsShaders.begin(), kCausticsShaders.end());
  technique.shows_water = true;
  technique.unsupported = unsupported;
  technique.render = render;
  return technique;
}

}  // namespace lightbench
