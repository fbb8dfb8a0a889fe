#include "renderer/caustics/caustics_maps.h"

#include <algorithm>
#include <optional>

#include <glad/gl.h>

#include "base/stopwatch.h"
#include "renderer/caustics/draw_caustics.h"
#include "renderer/caustics/water_shade.h"
#include "renderer/frame_context.h"
#include "renderer/gpu_scene.h"
#include "scene/water.h"

namespace lightbench {

struct CausticsMaps::Impl {
  Impl(const Scene& scene, GlBackend backend)
      : gl(make_gl_context(backend)),
        request{scene, view, 16, 16, 1, {}},
        gpu_scene(scene),
        frame(request, &gpu, &gpu_scene),
        mesh(water_mesh(*scene.water, scene.time)) {}

  std::unique_ptr<GlContext> gl;
  View view;
  FrameRequest request;
  GpuState gpu;
  GpuScene gpu_scene;
  FrameContext frame;
  Mesh mesh;
};

std::size_t CausticsMap::used_planes() const {
  return std::size_t(
      std::count_if(texels_by_plane.begin(), texels_by_plane.end(), [](std::size_t n) { return n > 0; }));
}

CausticsMaps::CausticsMaps(const Scene& scene, GlBackend backend)
    : impl_(std::make_unique<Impl>(scene, backend)) {}
CausticsMaps::~CausticsMaps() = default;

CausticsMap CausticsMaps::draw(std::size_t receiver, const Light& light, const ParamValues& params) {
  FrameContext& frame = impl_->frame;
  const Scene& scene = frame.scene();
  const CausticsOptions options = caustics_options(params);
  CausticsMap result;
  result.box = receiver_box(scene, receiver, light);
  const WaterLight through = water_light(*scene.water, impl_->mesh, light, options.fresnel);
  const std::optional<GlTexture> shade = draw_water_shade(frame, light);
  const MapRays rays = map_rays(impl_->mesh, through, result.box, options.culling);
  result.lit = rays.lit;
  result.drawn = rays.corners.size();
  result.sideways = rays.sideways;
  const auto draw_places = [&] {
    return draw_receiver_map(frame, result.box, receiver, options.map_size, options.color);
  };
  // What the map before this one took is freed by what is drawn next.
  draw_occluders(frame, draw_places(), rays, options);
  forget_most_texture_memory();
  const std::size_t before = texture_memory().now;
  glFinish();
  Stopwatch watch;
  const ReceiverMap map = draw_places();
  const std::optional<OccluderMap> occluders = draw_occluders(frame, map, rays, options);
  glFinish();
  result.position_seconds = watch.seconds();
  watch = Stopwatch();
  const Volumes volumes(rays, map, scene.water->absorption, options.least_area, shade ? &*shade : nullptr,
                        occluders ? &*occluders : nullptr);
  const GlTexture caustics = draw_caustics(frame, map, volumes, options);
  glFinish();
  result.seconds = watch.seconds();
  result.flux = read_back(caustics, 4);
  result.texture_bytes = texture_memory().most - before;
  result.texels_by_plane = texels_by_plane(map, options.level_map.slices);
  if (options.method != CausticsMethod::volumetric)
    for (std::size_t i = 3; i < result.flux.data.size(); i += 4)
      result.raised += std::size_t(result.flux.data[i]);
  impl_->gl->check("a map of caustics");
  return result;
}

}  // namespace lightbench
