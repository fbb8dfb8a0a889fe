#pragma once

#include <filesystem>
#include <fstream>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "base/files.h"
#include "base/image_io.h"
#include "base/process.h"

namespace lightbench::test {

/// A folder with a small scene in it, and the program run there.
class Program : public ::testing::Test {
 protected:
  Program() {
    write("box.obj", "mtllib box.mtl\nusemtl grey\n" + kBox);
    write("box.mtl", "newmtl grey\nKd 0.6 0.5 0.4\n");
    write("scene.json",
          R"({"entities": [{"obj": "box.obj"}], "lights": [{"type": "point", "position": [2, 3, 4]}]})");
    write("cameras.json",
          R"({"views": [{"name": "front", "position": [0.5, 0.5, 4], "look_at": [0.5, 0.5, 0]},
                                        {"name": "side", "position": [4, 0.5, 0.5], "look_at": [0.5, 0.5, 0.5]}]})");
  }

  std::filesystem::path path(const std::string& name) const { return folder_.path() / name; }
  void write(const std::string& name, const std::string& text) const { write_file_atomic(path(name), text); }

  ProcessResult run(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), LIGHTBENCH_BINARY);
    return run_process({.argv = arguments,
                        .working_directory = folder_.path(),
                        .environment = environment_,
                        .timeout = std::chrono::minutes(5)});
  }

  /// A stand-in for POV-Ray: it answers --version, else runs `script`, in which $image is the file to write.
  void fake_povray(const std::string& script) {
    write("povray",
          "#!/bin/sh\nfor a in \"$@\"; do case \"$a\" in --version) echo 'POV-Ray 3.7.fake' >&2; exit 0;; "
          "+O*) image=\"${a#+O}\";; esac; done\n" +
              script + "\n");
    std::filesystem::permissions(path("povray"), std::filesystem::perms::owner_all);
    environment_["LIGHTBENCH_POVRAY"] = path("povray").string();
  }
  /// What a fake POV-Ray does when all goes well: it copies a grey picture.
  std::string copy_picture(int width = 32, int height = 24) const {
    write_exr(path("grey.exr"), Image(width, height, 4, 0.5f), PixelType::half);
    return "cp '" + path("grey.exr").string() + "' \"$image\"";
  }

  /// All files below the folder, relative to it.
  std::set<std::string> files(const std::string& below = "") const {
    std::set<std::string> result;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_.path() / below))
      if (entry.is_regular_file()) result.insert(entry.path().lexically_relative(folder_.path()).string());
    return result;
  }

  static inline const std::string kBox =
      "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
      "f 5 6 7 8\nf 2 1 4 3\nf 1 5 8 4\nf 6 2 3 7\nf 8 7 3 4\nf 1 2 6 5\n";

  TemporaryFolder folder_;
  std::map<std::string, std::string> environment_;
};

}  // namespace lightbench::test
