#include "renderer/surround.h"

#include <algorithm>
#include <array>
#include <vector>

#include <glad/gl.h>
#include <glm/vec4.hpp>

#include "renderer/frame_context.h"
#include "renderer/gpu_scene.h"

namespace lightbench {
namespace {

constexpr int kMaxTiles = 7;         // of shaders/tiles.glsl
constexpr unsigned kNearerUnit = 2;  // of shaders/surface.frag.glsl

// The block Tiles of shaders/tiles.glsl, std140.
struct TileBlock {
  struct Tile {
    glm::vec4 corner;
    glm::vec4 across;
    glm::vec4 along;
  };
  std::array<Tile, kMaxTiles> tiles;
  glm::vec4 eye_right;
  glm::vec4 eye_up;
  glm::vec4 eye_forward;
  glm::vec4 wide_view;
};
static_assert(sizeof(TileBlock) == 16 * std::size_t{3 * kMaxTiles + 4});

struct Tile {
  FrameCamera camera;
  int column = 0;  // its first one
  glm::ivec2 size;
};

// A camera that looks along an axis of the view. Some of these pictures are mirrored, which nothing minds.
FrameCamera cube_face(const FrameCamera& view, int face) {
  const std::array<glm::vec3, 3> axes{view.frame.right, view.frame.up, view.frame.forward};
  const int axis = face / 2;
  CameraFrame frame;
  frame.forward = face % 2 == 0 ? axes[std::size_t(axis)] : -axes[std::size_t(axis)];
  frame.right = axes[axis == 0 ? 1 : 0];
  frame.up = axes[axis == 2 ? 1 : 2];
  return turned(view, frame, 1);
}

std::vector<Tile> make_tiles(const FrameCamera& view, const SurroundOptions& options) {
  std::vector<Tile> tiles;
  if (options.wide_size.x > 0) tiles.push_back({widened(view, options.wide_factor), 0, options.wide_size});
  for (int face = 0; face < 6 && options.cube_size > 0; ++face)
    tiles.push_back({cube_face(view, face), options.wide_size.x + face * options.cube_size,
                     glm::ivec2(options.cube_size)});
  return tiles;
}

Buffer tile_block(const FrameCamera& view, const std::vector<Tile>& tiles, const SurroundOptions& options) {
  TileBlock block{};
  for (std::size_t i = 0; i < tiles.size(); ++i) {
    const FrameCamera& camera = tiles[i].camera;
    block.tiles[i] = {glm::vec4(camera.far_corner / camera.far, float(tiles[i].column)),
                      glm::vec4(camera.far_u / camera.far, float(tiles[i].size.x)),
                      glm::vec4(camera.far_v / camera.far, float(tiles[i].size.y))};
  }
  const bool wide = options.wide_size.x > 0;
  block.eye_right = glm::vec4(view.frame.right, float(tiles.size()));
  block.eye_up = glm::vec4(view.frame.up, float(layer_size(options).y));
  block.eye_forward = glm::vec4(view.frame.forward, float(options.layers));
  const glm::vec2 half_angles = options.wide_factor * glm::vec2(view.tan_half_x, view.tan_half_y);
  block.wide_view = glm::vec4(wide ? half_angles : glm::vec2(0), 0, 0);
  block.wide_view.z = options.cube_size > 0 ? (wide ? 1.0f : 0.0f) : -1.0f;
  return Buffer(&block, sizeof block);
}

ShaderDefines surface_defines(int layer, const SurroundOptions& options) {
  ShaderDefines defines;
  if (layer > 0) defines.emplace_back("BEHIND_LAYER");
  if (layer > 0 && options.front_faces) defines.emplace_back("FRONT_FACES");
  return defines;
}

void draw_tile(FrameContext& frame, const Tile& tile, int layer, const SurroundOptions& options) {
  ShaderDefines defines = surface_defines(layer, options);
  const Program& solid = frame.program("shaders/surface.vert.glsl", "shaders/surface.frag.glsl", defines);
  defines.emplace_back("CUTOUT");
  const Program& cutout = frame.program("shaders/surface.vert.glsl", "shaders/surface.frag.glsl", defines);
  const int row = layer * layer_size(options).y;
  for (const Program* program : {&solid, &cutout}) program->set("nearer_offset", glm::ivec2(0, -row));
  const Buffer camera = camera_block(tile.camera, tile.size.x, tile.size.y);
  camera.bind_uniform(0);
  set_surface_state();
  glViewport(tile.column, row, tile.size.x, tile.size.y);
  glScissor(tile.column, row, tile.size.x, tile.size.y);
  glEnable(GL_SCISSOR_TEST);
  frame.gpu_scene().draw_surfaces(solid, cutout, tile.camera.clip_from_world,
                                  glm::dvec3(tile.camera.position), FrustumCulling::on);
  glDisable(GL_SCISSOR_TEST);
}

void copy_layer(const GlTexture& depth, int layer, const GlTexture& to) {
  glCopyImageSubData(depth.id(), GL_TEXTURE_2D, 0, 0, layer * to.height(), 0, to.id(), GL_TEXTURE_2D, 0, 0, 0,
                     0, to.width(), to.height(), 1);
}

}  // namespace

glm::ivec2 layer_size(const SurroundOptions& options) {
  return {options.wide_size.x + 6 * options.cube_size, std::max(options.wide_size.y, options.cube_size)};
}

GBuffer draw_surround(FrameContext& frame, const SurroundOptions& options) {
  const FrameCamera& view = frame.camera();
  const glm::ivec2 size = layer_size(options);
  GBuffer g = make_gbuffer(view, size.x, size.y * options.layers, NormalFormat::octahedral16);
  const std::vector<Tile> tiles = make_tiles(view, options);
  g.tile_block = tile_block(view, tiles, options);
  const Framebuffer target = surface_target(g);
  for (int attachment = 0; attachment < 6; ++attachment) target.clear_color(attachment, 0, 0, 0, 0);
  target.clear_depth_stencil(0, 0);
  const GlTexture nearer(TexelFormat::r32f, size.x, size.y);
  for (int layer = 0; layer < options.layers; ++layer) {
    nearer.bind(kNearerUnit);
    target.bind();
    for (const Tile& tile : tiles) draw_tile(frame, tile, layer, options);
    if (layer + 1 < options.layers) copy_layer(g.depth, layer, nearer);
  }
  return g;
}

}  // namespace lightbench
