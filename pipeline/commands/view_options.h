#pragma once

#include <optional>
#include <string>
#include <vector>

#include <CLI/App.hpp>

#include "base/file_clashes.h"
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
  float fov = 60;              ///< degrees
  std::optional<double> time;  ///< seconds; else that of the view
  std::string size = "1024x768";
  int samples = 1;
};

struct ImageSize {
  int width;
  int height;
};

void add_view_options(CLI::App& command, ViewOptions& options);
ImageSize parse_size(const std::string& text);
/// All views of the camera script, or the chosen one, each at its time; without a camera, a valid one drawn
/// at random with seed 1.
std::vector<View> chosen_views(const ViewOptions& options, Scene& scene);
/// The first of them, with the scene put at its time.
View chosen_view(const ViewOptions& options, Scene& scene);

/// What was read for them: the scene's files and the camera script.
std::vector<NamedFile> input_files(const ViewOptions& options, const Scene& scene);
void print_warnings(const std::vector<std::string>& warnings);  ///< to standard error
/// Throws Error unless a picture's name ends in .png or .exr.
void check_picture_name(const std::filesystem::path& output);

/// `name=value` texts as parameters of a technique or reference; paths are relative to the working directory.
std::map<std::string, ParamValue> parse_params(std::span<const ParamSpec> specs,
                                               const std::vector<std::string>& texts);

}  // namespace lightbench
