#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/image.h"
#include "obj_test_files.h"

namespace lightbench {

struct LoadedMaterials : LoadedObj {
  const Material& material(const std::string& name) const {
    const auto found = std::find_if(model.materials.begin(), model.materials.end(),
                                    [&](const Material& m) { return m.name == name; });
    EXPECT_NE(found, model.materials.end()) << name;
    return *found;
  }
};

inline LoadedMaterials load(const SceneTestFiles& files, const std::string& name) {
  return {load_obj_file(files, name)};
}

/// A textured triangle for each named material, and an MTL file.
inline LoadedMaterials load_materials(const SceneTestFiles& files, const std::vector<std::string>& names,
                                      const std::string& mtl) {
  std::string obj = "mtllib m.mtl\nvt 0 0\n";
  int i = 0;
  for (const std::string& name : names) {
    const std::string y = std::to_string(i++);
    obj += "v 0 " + y + " 0\nv 1 " + y + " 0\nv 0 " + y + " 1\nusemtl " + name + "\nf -3/1 -2/1 -1/1\n";
  }
  files.write("m.obj", obj);
  files.write("m.mtl", mtl);
  return load(files, "m.obj");
}

inline Image8 rgb(std::uint8_t r, std::uint8_t g, std::uint8_t b) {
  Image8 image(2, 1, 3);
  for (int x = 0; x < 2; ++x) {
    image.pixel(x, 0)[0] = r;
    image.pixel(x, 0)[1] = g;
    image.pixel(x, 0)[2] = b;
  }
  return image;
}

}  // namespace lightbench
