#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "renderer/direct_light.h"
#include "renderer/frame_camera.h"
#include "renderer/gbuffer.h"
#include "renderer/gl_framebuffer.h"
#include "renderer/gl_program.h"
#include "renderer/technique.h"

namespace lightbench {

class GpuScene;
struct ShadowTextures;
class RadianceCache;

enum class Blend {
  replace,
  add,
  under,  ///< behind what is there, as far as its alpha leaves room
};
/// Where a full-screen pass draws.
struct DrawOn {
  std::optional<int> stencil;              ///< only where the target's stencil has this value
  std::optional<PixelRect> pixels;         ///< nowhere outside
  const DrawCommands* commands = nullptr;  ///< only if the one of that number says so
  int command = 0;
  bool writes_depth = false;  ///< the depth that the shader gives
};
inline constexpr int kComputeGroup = 64;  ///< of shaders/compute.glsl, too
/// The pixels of objects, in targets whose stencil tells nothing but whether there is one.
inline const DrawOn kObjects{1, std::nullopt};

/// What lives longer than a frame: compiled programs, and the scene on the GPU.
struct GpuState {
  GpuState();
  ~GpuState();

  ProgramCache programs;
  VertexArray no_vertices;  ///< of full-screen passes
  std::unique_ptr<ShadowTextures> shadow_textures;
  std::unique_ptr<RadianceCache> radiance_cache;
};

/// What a technique draws one frame with. Sizes are those drawn: the request's times its samples; `Renderer`
/// averages the image and the buffers down. Without OpenGL (Technique::needs_gl is false) only request(),
/// warn(), add_pass_time(), wants(), and set_image and keep_buffer of an Image may be called.
class FrameContext {
 public:
  FrameContext(const FrameRequest& request, GpuState* gpu, const GpuScene* scene);

  const FrameRequest& request() const { return request_; }
  const Scene& scene() const { return request_.scene; }
  const FrameCamera& camera() const { return camera_; }
  int width() const { return request_.width * request_.samples; }
  int height() const { return request_.height * request_.samples; }
  const GpuScene& gpu_scene() const { return *gpu_scene_; }
  ShadowTextures& shadow_textures() { return *gpu_->shadow_textures; }
  RadianceCache& radiance_cache() { return *gpu_->radiance_cache; }

  const Program& program(const std::string& vertex, const std::string& fragment,
                         const ShaderDefines& defines = {});
  /// A program of full-screen passes: `fragment` after shaders/fullscreen.vert.glsl, which gives `in vec2
  /// uv`, 0..1, y up.
  const Program& fullscreen_program(const std::string& fragment, const ShaderDefines& defines = {});
  /// Of a compute shader whose groups are of kComputeGroup invocations along x.
  const Program& compute_program(const std::string& shader, const ShaderDefines& defines = {});
  /// Runs it for that many invocations and a few more, of which the shader must take no notice; what it
  /// writes is seen by all that is drawn or computed later.
  void compute(const Program& program, int invocations);

  /// Runs `draw` as the pass of that name: the pipeline is drained before and after it, and the times of
  /// passes with one name add up. Not to be nested.
  void pass(const std::string& name, const std::function<void()>& draw);

  /// Covers the target with one triangle. Sets all state that it depends on; textures and uniforms are the
  /// caller's.
  void draw_fullscreen(const Framebuffer& target, const Program& program, Blend blend = Blend::replace,
                       const DrawOn& where = {});

  /// Whether the request asks for a named buffer.
  bool wants(const std::string& buffer) const { return request_.buffers.contains(buffer); }
  /// Keeps the first `channels` components under a name of the technique's table, if it is wanted. A texture
  /// that is smaller than the frame by a whole factor is enlarged by repeating texels.
  void keep_buffer(const std::string& name, const GlTexture& texture, int channels);
  void keep_buffer(const std::string& name, const Image& image);  ///< row 0 on top

  void set_image(const GlTexture& image);  ///< RGBA, linear; alpha is coverage
  void set_image(Image image);             ///< RGBA; of the drawn size or the request's own
  void warn(const std::string& text);
  /// For passes that were timed elsewhere.
  void add_pass_time(const std::string& name, double seconds);

  FrameResult& result() { return result_; }
  /// The shader files that programs of this frame start from.
  const std::set<std::string>& used_shaders() const { return used_shaders_; }

 private:
  const FrameRequest& request_;
  GpuState* gpu_;
  const GpuScene* gpu_scene_;
  FrameCamera camera_;
  FrameResult result_;
  std::set<std::string> used_shaders_;
};

/// Names and meanings of the buffers that every directly lit technique gives: albedo, normal, depth, shadow,
/// direct.
std::vector<BufferSpec> direct_buffers();
/// Keeps those of them that are wanted. For "shadow", `direct.visibility` must have been asked for.
void keep_direct_buffers(FrameContext& frame, const GBuffer& gbuffer, const DirectLight& direct);
/// The shader files that draw_gbuffer, draw_direct_light and keep_direct_buffers start from, for
/// Technique::shaders.
std::vector<std::string> direct_shaders();
/// The outputs that the wanted buffers need.
DirectLightOutputs wanted_outputs(const FrameContext& frame);

}  // namespace lightbench
