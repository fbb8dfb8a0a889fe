#pragma once

#include <cmath>
#include <csignal>
#include <string>
#include <vector>

#include "base/image_io.h"
#include "e2e_fixture.h"

namespace lightbench::test {

/// A box over a floor, which are baked with few texels and few directions.
class Baked : public Program {
 protected:
  Baked() {
    write("scene.json", R"({"entities": [
        {"name": "box", "obj": "box.obj"},
        {"name": "floor", "box": {"min": [-2, -0.5, -2], "max": [3, -0.4, 3]}, "material": {"diffuse": [0.5, 0.5, 0.5]}}],
      "lights": [{"type": "point", "position": [2, 3, 4]}]})");
  }

  ProcessResult bake(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments = kBake;
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  }

  /// As soon as a file has so many bytes.
  static constexpr std::size_t kKilledAt = 4096;
  ProcessResult bake_that_is_killed() const {
    std::string command = "ulimit -f 8; exec '" LIGHTBENCH_BINARY "'";
    for (const std::string& argument : kBake) command += " " + argument;
    return run_process(
        {.argv = {"sh", "-c", command}, .working_directory = folder_.path(), .environment = environment_});
  }

  static inline const std::vector<std::string> kBake = {
      "bake", "scene.json", "--out", "baked", "-p", "density=2", "-p", "thetas=3", "-p", "phis=4"};
};

class GlBaked : public Baked {
 protected:
  /// From the front, by what command bake made.
  ProcessResult draw(const std::string& file) const {
    return run({"render", "scene.json", "--cameras", "cameras.json", "--view", "front", "--technique",
                "surface_radiance", "--baked", "baked", "--size", "32x24", "-o", file});
  }

  /// Of 255, over all pixels and colours.
  double mean_difference(const std::string& one, const std::string& other) const {
    const Image8 a = read_image_srgb8(path(one)), b = read_image_srgb8(path(other));
    EXPECT_EQ(a.data.size(), b.data.size());
    double sum = 0;
    for (std::size_t i = 0; i < a.data.size(); ++i) sum += std::abs(double(a.data[i]) - double(b.data[i]));
    return sum / double(a.data.size());
  }
};

}  // namespace lightbench::test
