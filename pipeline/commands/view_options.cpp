#include "pipeline/commands/view_options.h"

#include <algorithm>
#include <charconv>

#include <CLI/CLI.hpp>
#include <glm/trigonometric.hpp>

#include "base/error.h"
#include "base/image_io.h"
#include "base/text.h"
#include "pipeline/commands/number_range.h"
#include "pipeline/console.h"
#include "pipeline/tables.h"
#include "renderer/rays.h"
#include "scene/camera_script.h"
#include "scene/motion.h"
#include "scene/random_views.h"
#include "scene/scene_json.h"

namespace lightbench {
namespace {

glm::vec3 vector_of(const std::vector<float>& values) {
  return {values[0], values[1], values[2]};
}

View drawn_view(const ViewOptions& options, const Scene& scene) {
  const ImageSize size = parse_size(options.size);
  const SceneRays rays(scene);
  RandomViewOptions random;
  random.fov = glm::radians(options.fov);
  random.aspect = float(size.width) / float(size.height);
  return draw_random_views(scene, random,
                           [&rays](const glm::vec3& origin, const glm::vec3& direction) {
                             return rays.closest_hit(origin, direction);
                           })
      .front();
}

View given_view(const ViewOptions& options) {
  if (options.look_at.empty()) throw Error("--position needs --look-at");
  View view{"view", {vector_of(options.position), vector_of(options.look_at), vector_of(options.up)}};
  view.camera.fov = glm::radians(options.fov);
  const std::string text = camera_script_text({view});
  return read_view(JsonValue::parse(text, "--position").object().at("views").items().front());
}

}  // namespace

void add_view_options(CLI::App& command, ViewOptions& options) {
  command.add_option("scene", options.scene, "Scene file (.json) or OBJ")->required();
  auto* cameras = command.add_option("--cameras", options.cameras, "Camera script");
  command.add_option("--view", options.view, "Name of a view in the camera script; default: its first")
      ->needs(cameras);
  auto* position = command.add_option("--position", options.position, "Camera position: x y z")->expected(3);
  position->excludes(cameras);
  const CLI::Validator coordinate = number_between(-kLargestCoordinate, kLargestCoordinate);
  position->check(coordinate);
  command.add_option("--look-at", options.look_at, "Point that the camera looks at: x y z")
      ->expected(3)
      ->check(coordinate)
      ->needs(position);
  command.add_option("--up", options.up, "Up direction: x y z")
      ->expected(3)
      ->check(coordinate)
      ->needs(position)
      ->capture_default_str();
  command
      .add_option("--fov", options.fov, "Vertical field of view, degrees, of --position and of a drawn view")
      ->check(number_between(1.0, 170.0))
      ->capture_default_str();
  command.add_option("--time", options.time, "Seconds: where keyframes stand; default: the view's time")
      ->check(number_between(-kLargestTime, kLargestTime));
  command.add_option("--size", options.size, "Image size, WIDTHxHEIGHT")->capture_default_str();
  command.add_option("--samples", options.samples, "Supersampling per axis")
      ->check(number_between(1, 8))
      ->capture_default_str();
}

ImageSize parse_size(const std::string& text) {
  const auto parts = split(text, 'x');
  long long sides[2] = {0, 0};
  bool ok = parts.size() == 2;
  for (std::size_t i = 0; ok && i < 2; ++i) {
    const auto [end, error] = std::from_chars(parts[i].data(), parts[i].data() + parts[i].size(), sides[i]);
    ok = error == std::errc() && end == parts[i].data() + parts[i].size();
  }
  if (!ok) throw Error("must be WIDTHxHEIGHT, such as 1024x768, not '" + text + "'", "--size");
  check_image_size(sides[0], sides[1], "--size");
  return {int(sides[0]), int(sides[1])};
}

namespace {

/// Returns the views that the options name, as the camera script has them.
std::vector<View> named_views(const ViewOptions& options, const Scene& scene) {
  if (options.cameras.empty()) {
    if (!options.position.empty()) return {given_view(options)};
    say_aside("no camera is given: a view is drawn at random (seed 1)");
    return {drawn_view(options, scene)};
  }
  const auto views = read_camera_script(options.cameras);
  if (options.view.empty()) return views;
  const auto found =
      std::find_if(views.begin(), views.end(), [&](const View& v) { return v.name == options.view; });
  if (found == views.end())
    throw Error("there is no view '" + options.view + "' in " + options.cameras +
                    did_you_mean(options.view, row_names(views)),
                "--view");
  return {*found};
}

}  // namespace

std::vector<View> chosen_views(const ViewOptions& options, Scene& scene) {
  set_time(scene, options.time.value_or(0));  // a view is drawn where the entities stand
  auto views = named_views(options, scene);
  if (options.time)
    for (auto& view : views) view = view_at(view, *options.time);
  return views;
}

View chosen_view(const ViewOptions& options, Scene& scene) {
  const View view = chosen_views(options, scene).front();
  set_time(scene, view.time);
  return view;
}

std::vector<NamedFile> input_files(const ViewOptions& options, const Scene& scene) {
  std::vector<NamedFile> files = named("a file of the scene", file_paths(scene));
  files.push_back({"the camera script", options.cameras});
  return files;
}

void print_warnings(const std::vector<std::string>& warnings) {
  for (const auto& warning : warnings) warn(warning);
}

void check_picture_name(const std::filesystem::path& output) {
  if (output.extension() != ".png" && output.extension() != ".exr")
    throw Error("must end in .png or .exr", "-o " + output.string());
}

std::map<std::string, ParamValue> parse_params(std::span<const ParamSpec> specs,
                                               const std::vector<std::string>& texts) {
  std::map<std::string, ParamValue> result;
  for (const auto& text : texts) {
    const auto equals = text.find('=');
    if (equals == std::string::npos) throw Error("must be NAME=VALUE, not '" + text + "'", "--param");
    const std::string name = text.substr(0, equals);
    const auto spec =
        std::find_if(specs.begin(), specs.end(), [&](const ParamSpec& s) { return s.name == name; });
    if (spec == specs.end())
      throw Error("unknown parameter '" + name + "'" + did_you_mean(name, row_names(specs)), "--param");
    if (result.contains(name)) throw Error("the parameter '" + name + "' is given twice", "--param");
    const std::string value = text.substr(equals + 1), where = "--param " + name;
    if (is_path_param(*spec))
      result[name] = resolve_path_param(*spec, value, std::filesystem::current_path(), where);
    else
      result[name] = parse_param(*spec, value, where);
  }
  return result;
}

}  // namespace lightbench
