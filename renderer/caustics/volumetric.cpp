#include "renderer/caustics/volumetric.h"

#include <glad/gl.h>

#include "renderer/caustics/caustics_shaders.h"
#include "renderer/caustics/level_map.h"
#include "renderer/frame_context.h"

namespace lightbench {
namespace {

/// RGBA8 of each plane: white where it shows the receiver, black where it shows others, else empty.
GlTexture draw_slices(FrameContext& frame, const ReceiverMap& map, const VolumetricOptions& options) {
  const int size = map.places.width();
  GlTexture images = GlTexture::array(TexelFormat::rgba8, size, size, options.slices + 1);
  const GlTexture depth(TexelFormat::depth32f, size, size);
  for (int plane = 0; plane <= options.slices; ++plane) {
    const Framebuffer target = Framebuffer::layer(images, plane, &depth);
    draw_slice(frame, map, {plane, options.slices}, target,
               options.drawing == SliceDrawing::whole ? FrustumCulling::off : FrustumCulling::on);
  }
  return images;
}

}  // namespace

GlTexture draw_volumetric(FrameContext& frame, const ReceiverMap& map, const Volumes& volumes,
                          const VolumetricOptions& options) {
  const int size = map.places.width();
  const GlTexture images = draw_slices(frame, map, options);
  const GlTexture light(TexelFormat::rgba32f, size, size);
  GlTexture caustics(TexelFormat::rgba32f, size, size);
  const Framebuffer light_target({&light}), target({&caustics});
  const Program& combine = frame.fullscreen_program(kCombine);
  target.clear_color(0, 0, 0, 0, 0);
  for (int plane = 0; plane <= options.slices; ++plane) {
    light_target.clear_color(0, 0, 0, 0, 0);
    draw_plane(frame, map, volumes, plane, options.slices, light_target);
    images.bind(0);
    light.bind(1);
    combine.set("plane", plane);
    frame.draw_fullscreen(target, combine, Blend::under);
  }
  return caustics;
}

}  // namespace lightbench
