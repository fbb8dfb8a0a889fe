#include <cmath>

#include "base/image_io.h"
#include "fuzz_input.h"
#include "scene/motion.h"

namespace lightbench::fuzz {
namespace {

void write_square(const InputFolder& folder) {
  folder.write("m.obj", "mtllib m.mtl\nusemtl red\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n");
  folder.write("m.mtl", "newmtl red\nKd 1 0 0\nmap_Kd t.png\n");
  folder.write("t.png", encode_png(Image8(2, 2, 4, 200)));
}

void require_placed(const Scene& scene) {
  for (const Entity& entity : scene.entities) {
    require(std::size_t(entity.mesh) < scene.meshes.size(), "an entity of a mesh that is not there");
    for (int i = 0; i < 16; ++i)
      require(std::isfinite(entity.transform[i / 4][i % 4]), "a transform that is not finite");
  }
}

}  // namespace

/// A scene file beside m.obj, a square, with its m.mtl and t.png. It is looked at at several times.
void fuzz_scene(std::string_view bytes) {
  static const InputFolder folder;
  static const bool written = (write_square(folder), true);
  static_cast<void>(written);
  LoadedScene loaded = load_scene_collecting(folder.write("s.json", bytes));
  refuse(loaded.problems);  // what is left of a scene with errors is not used
  for (const Mesh& mesh : loaded.scene.meshes) require_sound(mesh, loaded.scene.materials.size());
  for (const double time : {0.0, 0.25, 1e6}) {
    set_time(loaded.scene, time);
    require_placed(loaded.scene);
    swept_bounds(loaded.scene);
    depth_range(loaded.scene, Camera{});
  }
}

}  // namespace lightbench::fuzz
