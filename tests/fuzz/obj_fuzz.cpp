#include "fuzz_input.h"
#include "scene/obj_loader.h"

namespace lightbench::fuzz {

/// An OBJ file beside a library m.mtl with the materials `red` and `leaf`.
void fuzz_obj(std::string_view bytes) {
  static const InputFolder folder;
  static const auto library = folder.write("m.mtl", "newmtl red\nKd 1 0 0\n\nnewmtl leaf\nKd 0 1 0\n");
  const auto file = folder.write("m.obj", bytes);
  ProblemList problems;
  TextureLoader textures(problems);
  const ObjModel model = load_obj(file, {.crease_angle = 0.5f}, textures, problems);
  refuse(problems.all());  // what is left of a file with errors is not used
  for (const Mesh& mesh : model.meshes) require_sound(mesh, model.materials.size());
}

}  // namespace lightbench::fuzz
