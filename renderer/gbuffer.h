#pragma once

#include <optional>

#include "renderer/frame_camera.h"
#include "renderer/gl_framebuffer.h"
#include "renderer/gl_objects.h"

namespace lightbench {

class FrameContext;

enum class NormalFormat {
  octahedral16,  ///< two 16-bit components; axes are exact
  rgb8,          ///< n = 2c/255 - 1, the thesis's eq. 22
};

enum class FrustumCulling { on, off };

struct GBufferOptions {
  NormalFormat normals = NormalFormat::octahedral16;
  FrustumCulling culling = FrustumCulling::on;
  std::optional<float> ceiling = std::nullopt;  ///< what is higher in the world is left out
  bool entities = false;                        ///< whether GBuffer::entities is drawn
};

/// What the camera sees, after section 4.2 of the image-space radiosity thesis. All textures have the
/// camera's size, OpenGL's row 0 (the bottom row) first. Shaders read them through `#include
/// "shaders/gbuffer.glsl"`, after `bind`.
struct GBuffer {
  FrameCamera camera;
  int width = 0;
  int height = 0;
  NormalFormat normal_format = NormalFormat::octahedral16;
  GlTexture
      albedo;  ///< RGBA16F: linear diffuse reflectance; alpha is the radiation mask (Material::reflectance)
  GlTexture normal;            ///< RG16 or RGBA8: unit shading normal in world space, towards the viewer
  GlTexture geometric_normal;  ///< RG16 octahedral: the triangle's own normal, towards the viewer
  GlTexture depth;     ///< R32F: eye-space z / far; 0 where there is no geometry: such pixels must be skipped
  GlTexture specular;  ///< RG16F: strength ks and Phong exponent
  GlTexture emission;  ///< RGBA32F: Ke and alpha 1; the background's colour and alpha 0 without geometry
  GlTexture entities;  ///< R32F, if asked for: 1 + the number of the entity, 0 without geometry
  GlTexture depth_stencil;  ///< stencil 1 where there is geometry

  /// Binds the textures but `entities` to the units of shaders/gbuffer.glsl (0 to 5), the camera to uniform
  /// block 0 and the tiles, if there are any, to block 2.
  void bind() const;

  Buffer camera_block;
  Buffer tile_block;  ///< of a surround (renderer/surround.h), else empty
};

/// Draws the scene of the frame; times nothing.
GBuffer draw_gbuffer(FrameContext& frame, const FrameCamera& camera, int width, int height,
                     const GBufferOptions& options = {});

/// An empty one to draw into, and the block `Frame` of shaders/frame.glsl for a camera of that many pixels.
GBuffer make_gbuffer(const FrameCamera& camera, int width, int height, NormalFormat normals);
Framebuffer surface_target(const GBuffer& gbuffer);
Buffer camera_block(const FrameCamera& camera, int width, int height);
/// Nearer surfaces win and mark their pixels in the stencil.
void set_surface_state();

/// What programs that include shaders/gbuffer.glsl must be compiled with for this G-buffer.
std::vector<std::string> gbuffer_defines(const GBuffer& gbuffer);

}  // namespace lightbench
