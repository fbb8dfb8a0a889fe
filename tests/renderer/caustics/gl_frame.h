#pragma once

#include <memory>

#include "renderer/caustics/receiver_map.h"
#include "renderer/caustics/volumes.h"
#include "renderer/caustics/water_shade.h"
#include "renderer/frame_context.h"
#include "renderer/gl_context.h"
#include "renderer/gpu_scene.h"
#include "scene/water.h"
#include "tests/renderer/render_scene.h"

namespace lightbench::test {

/// What is needed to draw maps of a scene outside of a technique. The scene must outlive it.
class GlFrame {
 public:
  explicit GlFrame(const Scene& scene)
      : request_{scene, view_, 64, 48, 1, {}}, gpu_scene_(scene), frame_(request_, &gpu_, &gpu_scene_) {}

  FrameContext& context() { return frame_; }

 private:
  std::unique_ptr<GlContext> gl_ = make_gl_context(GlBackend::osmesa);
  View view_ = top_view(3);
  FrameRequest request_;
  GpuState gpu_;
  GpuScene gpu_scene_;
  FrameContext frame_;
};

/// How a receiver is drawn by itself.
struct DrawnOptions {
  int size = 128;  ///< texels along an edge of its maps
  VolumeCulling culling = VolumeCulling::on;
  bool occluders = true;  ///< whether edges stop light that waves bend aside
  int steps = 16;         ///< in which that light is followed
};

/// A receiver's map and the volumes of the first light.
struct DrawnReceiver {
  DrawnReceiver(FrameContext& frame, std::size_t entity, const DrawnOptions& options = {})
      : map(draw_receiver_map(frame, receiver_box(frame.scene(), entity, frame.scene().lights[0]), entity,
                              options.size, ReceiverColor::surface)),
        shade(draw_water_shade(frame, frame.scene().lights[0])),
        rays(rays_of(frame.scene(), map.box, options.culling)),
        occluders(options.occluders ? std::make_unique<OccluderMap>(frame, map, rays.most_step, options.steps)
                                    : nullptr),
        volumes(rays, map, frame.scene().water->absorption, 1.0 / 256, shade ? &*shade : nullptr,
                occluders.get()) {}

  static MapRays rays_of(const Scene& scene, const ReceiverBox& box, VolumeCulling culling) {
    const Mesh mesh = water_mesh(*scene.water, scene.time);
    return map_rays(mesh, water_light(*scene.water, mesh, scene.lights[0], false), box, culling);
  }

  ReceiverMap map;
  std::optional<GlTexture> shade;
  MapRays rays;
  std::unique_ptr<OccluderMap> occluders;
  Volumes volumes;
};

}  // namespace lightbench::test
