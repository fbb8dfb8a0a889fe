#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "scene/obj_loader.h"
#include "scene_test_files.h"

namespace lightbench {

struct LoadedObj {
  ObjModel model;
  std::vector<Texture> textures;
  std::string problems;  ///< as `described` has them
};

inline LoadedObj load_obj_file(const SceneTestFiles& files, const std::string& name,
                               const ObjOptions& options = {}) {
  ProblemList problems;
  TextureLoader textures(problems);
  LoadedObj result;
  result.model = load_obj(files.path(name), options, textures, problems);
  result.textures = textures.take_textures();
  result.problems = described(problems.all(), files.path("").parent_path());
  return result;
}

inline LoadedObj load_obj_text(std::string_view text, const ObjOptions& options = {}) {
  const SceneTestFiles files;
  files.write("m.obj", text);
  return load_obj_file(files, "m.obj", options);
}

inline std::size_t triangle_count(const ObjModel& model) {
  std::size_t count = 0;
  for (const Mesh& mesh : model.meshes) count += mesh.triangles.size();
  return count;
}

}  // namespace lightbench
