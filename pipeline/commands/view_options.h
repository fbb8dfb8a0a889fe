#pragma once

#include <string>
#include <vector>

#include <CLI/App.hpp>

#include "base/params.h"
#include "scene/scene.h"

namespace lightbench {

/// Options of the commands that make pictures of one scene.
struct ViewOptions {
  std::string scene;
  std::string cameras;
  std::string view;
  std::vector<float> position;
  std::vector<float> look_at;
  std::vector<float> up = {0, 1, 0};
  float fov = 60;  ///< degrees
  std::string size = "1024x768";
  int samples = 1;
};

struct ImageSize {
  int width;
  int height;
};

void add_view_options(CLI::App& command, ViewOptions& options);
ImageSize parse_size(const std::string& text);
/// The view that the options name; without any, a valid one drawn at random with seed 1.
View chosen_view(const ViewOptions& options, const Scene& scene);
/// All views of the camera script, or the chosen one.
std::vector<View> chosen_views(const ViewOptions& options, const Scene& scene);

/// `name=value` texts as parameters of a technique or reference.
std::map<std::string, ParamValue> parse_params(std::span<const ParamSpec> specs,
                                               const std::vector<std::string>& texts);

}  // namespace lightbench
