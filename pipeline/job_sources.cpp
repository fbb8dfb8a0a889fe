#include "pipeline/job_sources.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/error.h"
#include "base/files.h"
#include "base/text.h"
#include "pipeline/references.h"
#include "pipeline/tables.h"
#include "renderer/technique.h"
#include "scene/camera_script.h"
#include "scene/scene_json.h"

namespace lightbench {
namespace {

constexpr int kMaxRandomViews = 10000;

GivenParams read_params(JsonObject object, std::span<const ParamSpec> specs,
                        const std::filesystem::path& base) {
  GivenParams result;
  for (const auto& spec : specs)
    if (const auto value = object.find(spec.name)) {
      result[spec.name] = read_param(spec, *value);
      if (is_path_param(spec))
        result[spec.name] = resolve_path_param(spec, value->text(), base, value->where());
    }
  object.finish();
  return result;
}

/// Paths that nobody gives are relative to the job file too.
void add_default_paths(std::span<const ParamSpec> specs, const std::filesystem::path& base,
                       GivenParams& params) {
  for (const auto& spec : specs)
    if (is_path_param(spec) && !params.contains(spec.name))
      params[spec.name] =
          resolve_path_param(spec, std::get<std::string>(spec.default_value), base, spec.name);
}

std::string read_preset(JsonObject& object, std::span<const ParamPreset> presets) {
  const auto value = object.find("preset");
  if (!value) return "";
  if (presets.empty()) value->fail("there are no presets here");
  return value->choice(row_names(presets));
}

RandomViewsRequest read_random_views(JsonObject object) {
  RandomViewsRequest request;
  request.count = int(object.at("count").integer(1, kMaxRandomViews));
  if (const auto seed = object.find("seed")) request.seed = std::uint64_t(seed->integer(0));
  if (const auto fov = object.find("fov")) request.fov = fov->number(1, 170);
  if (const auto version = object.find("version"))
    request.version = int(version->integer(1, kNewestGenerator));
  object.finish();
  return request;
}

std::vector<View> read_inline_views(const JsonValue& list) {
  std::vector<View> views;
  UniqueNames names("the view");
  for (const auto& item : list.items()) {
    views.push_back(read_view(item));
    names.add(views.back().name, item);
  }
  if (views.empty()) list.fail("needs at least one view");
  return views;
}

std::vector<std::string> read_view_names(const JsonValue& list) {
  std::vector<std::string> result;
  UniqueNames names("the view");
  for (const auto& item : list.items()) {
    if (!item.is_string()) item.fail("must be the name of a view in 'cameras'");
    result.push_back(item.text());
    names.add(result.back(), item);
  }
  if (result.empty()) list.fail("needs at least one view");
  return result;
}

JobViews read_views(JsonObject& object, const std::filesystem::path& base) {
  const auto cameras = object.find("cameras");
  const auto views = object.find("views");
  const auto random = object.find("random");
  if (random ? cameras || views : !cameras && !views)
    object.fail("needs 'cameras' (with the names of some 'views' or without), 'views' or 'random'");
  if (cameras)
    return CameraScript{resolve_path(cameras->text(), base, cameras->where()),
                        views ? read_view_names(*views) : std::vector<std::string>()};
  if (views) return read_inline_views(*views);
  return read_random_views(random->object());
}

JobSequence read_sequence(JsonObject object) {
  JobSequence sequence;
  if (const auto start = object.find("start")) sequence.start = read_time(*start);
  sequence.frames = int(object.at("frames").integer(2, kMaxFrames));
  sequence.rate = object.at("rate").number(kMinFrameRate, kMaxFrameRate);
  if (std::abs(sequence.start + (sequence.frames - 1) / sequence.rate) > kLargestTime)
    object.fail(fmt::format("the last frame must be at most at {:.0f} seconds", kLargestTime));
  object.finish();
  return sequence;
}

std::vector<ParamValue> read_sweep_values(const ParamSpec& spec, const JsonValue& list) {
  std::vector<ParamValue> values;
  std::set<std::string> seen;
  for (const auto& item : list.items()) {
    values.push_back(read_param(spec, item));
    if (!seen.insert(to_text(values.back())).second) item.fail("stands twice in the sweep");
  }
  if (values.empty()) list.fail("a sweep needs at least one value");
  return values;
}

void read_sweep(JsonObject object, const Technique& technique, JobVariant& variant) {
  for (const auto& spec : technique.params)
    if (is_path_param(spec) && object.has(spec.name))
      object.fail(fmt::format("'{}' is a path and cannot be swept: name a variant for each", spec.name));
  for (const auto& key : object.keys())
    if (variant.params.contains(key)) object.fail(fmt::format("'{}' stands in 'params' too", key));
  for (const auto& spec : technique.params)
    if (const auto list = object.find(spec.name))
      variant.sweep.emplace_back(spec.name, read_sweep_values(spec, *list));
  object.finish();
}

}  // namespace

std::string name_of_file(const std::filesystem::path& file, const std::string& where) {
  std::string name = file.stem().string();
  if (const std::string problem = name_problem(name); !problem.empty())
    throw Error(
        fmt::format("the name is taken from the file's name, which {}; give a 'name' instead", problem),
        where);
  return name;
}

JobScene read_scene(const JsonValue& value, const JobReading& reading) {
  JsonObject object = value.object();
  JobScene scene;
  const JsonValue path = object.at("scene");
  scene.as_written = path.text();
  scene.file = resolve_path(scene.as_written, reading.base, path.where());
  const auto name = object.find("name");
  scene.name = name ? read_name(*name, reading.longest_name) : name_of_file(scene.file, path.where());
  scene.views = read_views(object, reading.base);
  if (const auto sequence = object.find("sequence")) scene.sequence = read_sequence(sequence->object());
  object.finish();
  return scene;
}

JobVariant read_variant(const JsonValue& value, const JobReading& reading) {
  JsonObject object = value.object();
  JobVariant variant;
  const JsonValue technique_name = object.at("technique");
  const Technique& technique = find_technique(technique_name.text(), technique_name.where());
  variant.technique = technique.name;
  const auto name = object.find("name");
  variant.name = name ? read_name(*name, reading.longest_name) : technique.name;
  variant.preset = read_preset(object, technique.presets);
  if (const auto params = object.find("params"))
    variant.params = read_params(params->object(), technique.params, reading.base);
  if (const auto sweep = object.find("sweep")) read_sweep(sweep->object(), technique, variant);
  add_default_paths(technique.params, reading.base, variant.params);
  object.finish();
  return variant;
}

JobReference read_reference(const JsonValue& value, const JobReading& reading) {
  JsonObject object = value.object();
  JobReference reference;
  const JsonValue kind_name = object.at("kind");
  const ReferenceKind& kind = find_reference_kind(kind_name.text(), kind_name.where());
  reference.kind = kind.name;
  const auto name = object.find("name");
  reference.name = name ? read_name(*name, reading.longest_name) : kind.name;
  reference.preset = read_preset(object, kind.presets);
  if (const auto params = object.find("params"))
    reference.params = read_params(params->object(), kind.params, reading.base);
  if (const auto timeout = object.find("timeout"))
    reference.timeout = std::chrono::milliseconds(std::llround(timeout->number(0.1, 1e7) * 1000));
  object.finish();
  return reference;
}

}  // namespace lightbench
