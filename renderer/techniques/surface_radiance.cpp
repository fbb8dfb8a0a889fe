#include "renderer/techniques/surface_radiance.h"

#include <glad/gl.h>
#include <glm/gtc/matrix_inverse.hpp>

#include "base/error.h"
#include "renderer/frame_context.h"
#include "renderer/gpu_scene.h"
#include "renderer/radiance/bake_settings.h"
#include "renderer/radiance/radiance_cache.h"
#include "renderer/radiance/radiance_codecs.h"
#include "renderer/radiance/radiance_objects.h"
#include "scene/motion.h"

namespace lightbench {
namespace {

constexpr const char* kFullscreen = "shaders/fullscreen.vert.glsl";
constexpr const char* kObjectVertex = "techniques/surface_radiance/object.vert.glsl";
constexpr const char* kObjectFragment = "techniques/surface_radiance/object.frag.glsl";
constexpr const char* kSeen = "techniques/surface_radiance/seen.frag.glsl";
constexpr const char* kShade = "techniques/surface_radiance/shade.frag.glsl";

/// Which object each pixel shows, and where.
struct Places {
  GlTexture places;   ///< RGBA32F: texel coordinates, object's number + 1, whether its back is seen
  GlTexture normals;  ///< RG16: octahedral
  GlTexture depth_stencil;
};

/// Objects share the stencil's values, of which 0 is the background's.
int stencil_of(int object) {
  return 1 + object % 255;
}

const RadianceObjects& loaded_objects(FrameContext& frame, const ParamValues& params) {
  const std::filesystem::path& folder = frame.request().baked;
  if (folder.empty())
    throw Error("technique 'surface_radiance' draws what was baked, and no folder of baked objects is given",
                frame.scene().name);
  return frame.radiance_cache().get(frame.scene(), folder, params);
}

glm::dmat4 clip_from_object(const FrameContext& frame, const RadianceObject& object) {
  return frame.camera().clip_from_world * object.world_from_object;
}

void draw_object(FrameContext& frame, const RadianceObject& object, int number) {
  glStencilFunc(GL_ALWAYS, stencil_of(number), 0xff);
  glBindVertexArray(object.vertices.id());
  for (const RadianceObject::Range& range : object.ranges) {
    const bool solid = range.cutout == kNoTexture;
    const Program& program =
        frame.program(kObjectVertex, kObjectFragment, solid ? ShaderDefines{} : ShaderDefines{"CUTOUT"});
    program.use();
    program.set("clip_from_object", glm::mat4(clip_from_object(frame, object)));
    program.set("world_from_normal", glm::mat3(glm::inverseTranspose(glm::dmat3(object.world_from_object))));
    program.set("object", number);
    if (!solid) frame.gpu_scene().texture(range.cutout).bind(1);
    glDrawArrays(GL_TRIANGLES, range.first, range.count);
  }
}

Places draw_places(FrameContext& frame, const RadianceObjects& objects) {
  const int width = frame.width(), height = frame.height();
  Places places{GlTexture(TexelFormat::rgba32f, width, height), GlTexture(TexelFormat::rg16, width, height),
                GlTexture(TexelFormat::depth32f_stencil8, width, height)};
  const Framebuffer target({&places.places, &places.normals}, &places.depth_stencil);
  target.bind();
  target.clear_color(0, 0, 0, 0, 0);
  target.clear_color(1, 0, 0, 0, 0);
  target.clear_depth_stencil(0, 0);
  set_surface_state();
  int number = 0;
  for (const RadianceObject& object : objects.objects()) draw_object(frame, object, number++);
  return places;
}

/// Of each object, whether any pixel shows it: hidden ones cost no look at the stencil.
void mark_seen_objects(FrameContext& frame, const Places& places, const DrawCommands& seen) {
  seen.bind_storage(0);
  places.places.bind(0);
  frame.draw_fullscreen(Framebuffer({}, &places.depth_stencil), frame.fullscreen_program(kSeen));
  seen.written();
}

ShaderDefines shade_defines(const RadianceObjects& objects, const ParamValues& params) {
  ShaderDefines defines = radiance_codec(params).defines(params);
  if (objects.order() == LayerOrder::theta_major) defines.emplace_back("THETA_MAJOR");
  if (objects.order() == LayerOrder::phi_major) defines.emplace_back("PHI_MAJOR");
  return defines;
}

void shade(FrameContext& frame, const RadianceObjects& objects, const ParamValues& params,
           const Places& places, const DrawCommands& seen, const Framebuffer& target) {
  const Program& program = frame.fullscreen_program(kShade, shade_defines(objects, params));
  const Buffer camera = camera_block(frame.camera(), frame.width(), frame.height());
  camera.bind_uniform(0);
  places.places.bind(0);
  places.normals.bind(1);
  program.use();
  int number = 0;
  for (const RadianceObject& object : objects.objects()) {
    const PixelRect pixels =
        pixels_of_box(object.bounds, clip_from_object(frame, object), {frame.width(), frame.height()});
    program.set("object", number);
    program.set("size", glm::ivec2(object.file.width, object.file.height));
    program.set("grid", glm::ivec2(object.file.grid.thetas, object.file.grid.phis));
    program.set("sides", object.sides);
    program.set("scale", object.file.scale);
    object.file.textures->bind(program);
    frame.draw_fullscreen(target, program, Blend::replace, {stencil_of(number), pixels, &seen, number});
    ++number;
  }
}

void render(FrameContext& frame, const ParamValues& params) {
  const RadianceObjects& objects = loaded_objects(frame, params);
  Places places;
  frame.pass("places", [&] { places = draw_places(frame, objects); });
  GlTexture image(TexelFormat::rgba32f, frame.width(), frame.height());
  const Framebuffer target({&image}, &places.depth_stencil);
  DrawCommands seen(objects.objects().size());
  frame.pass("seen", [&] { mark_seen_objects(frame, places, seen); });
  frame.pass("shade", [&] {
    const glm::vec3& background = frame.scene().background.color;
    target.bind();
    target.clear_color(0, background.r, background.g, background.b, 0);
    shade(frame, objects, params, places, seen, target);
  });
  frame.keep_buffer("place", places.places, 4);
  frame.set_image(image);
}

std::vector<std::string> unsupported(const Scene& scene, const ParamValues&) {
  if (moves(scene)) return {"entities of the scene move, and what is baked stands still"};
  return {};
}

}  // namespace

Technique surface_radiance_technique() {
  Technique technique;
  technique.name = "surface_radiance";
  technique.doc =
      "Radiance baked for every texel of the scene's surfaces in many directions, drawn from textures: a "
      "picture "
      "costs the same however costly its light was.";
  technique.params = codec_params();
  for (ParamSpec& row : bake_params()) technique.params.push_back(std::move(row));
  technique.buffers = {{"place",
                        "column and row in the object's texture, the object's number from 1 on, and 1 "
                        "where its back is seen"}};
  technique.shaders = {kFullscreen, kObjectVertex, kObjectFragment, kSeen, kShade};
  technique.bounces = [](const ParamValues& params) { return params.integer("bounces"); };
  technique.needs_bake = true;
  technique.unsupported = unsupported;
  technique.render = render;
  return technique;
}

}  // namespace lightbench
