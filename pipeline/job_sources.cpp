#include "pipeline/job_sources.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/error.h"
#include "base/files.h"
#include "base/text.h"
#include "pipeline/job_problems.h"
#include "pipeline/references.h"
#include "pipeline/tables.h"
#include "renderer/technique.h"
#include "scene/camera_script.h"
#include "scene/scene_json.h"

namespace lightbench {
namespace {

constexpr int kMaxRandomViews = 10000;

GivenParams read_params(const JsonValue& value, std::span<const ParamSpec> specs, const JobReading& reading) {
  KeyReader keys(value, reading.problems);
  GivenParams result;
  for (const auto& spec : specs)
    keys.optional(spec.name, [&](const JsonValue& v) {
      result[spec.name] = read_param(spec, v);
      if (is_path_param(spec))
        result[spec.name] = resolve_path_param(spec, v.text(), reading.base, v.where());
    });
  keys.finish();
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

std::string read_preset(const JsonValue& value, std::span<const ParamPreset> presets) {
  if (presets.empty()) value.fail("there are no presets here");
  return value.choice(row_names(presets));
}

RandomViewsRequest read_random_views(const JsonValue& value, ProblemList& problems) {
  KeyReader keys(value, problems);
  RandomViewsRequest request;
  keys.required("count", [&](const JsonValue& v) { request.count = int(v.integer(1, kMaxRandomViews)); });
  keys.optional("seed", [&](const JsonValue& v) { request.seed = std::uint64_t(v.integer(0)); });
  keys.optional("fov", [&](const JsonValue& v) { request.fov = v.number(1, 170); });
  keys.optional("version",
                [&](const JsonValue& v) { request.version = int(v.integer(1, kNewestGenerator)); });
  keys.finish();
  return request;
}

std::vector<View> read_inline_views(const JsonValue& list, ProblemList& problems) {
  const std::vector<JsonValue> items = list.items();
  if (items.empty()) list.fail("needs at least one view");
  std::vector<View> views;
  UniqueNames names("the view");
  for (const auto& item : items)
    collect(problems, [&] {
      views.push_back(read_view(item));
      names.add(views.back().name, item);
    });
  return views;
}

std::vector<std::string> read_view_names(const JsonValue& list, ProblemList& problems) {
  const std::vector<JsonValue> items = list.items();
  if (items.empty()) list.fail("needs at least one view");
  std::vector<std::string> result;
  UniqueNames names("the view");
  for (const auto& item : items)
    collect(problems, [&] {
      if (!item.is_string()) item.fail("must be the name of a view in 'cameras'");
      result.push_back(item.text());
      names.add(result.back(), item);
    });
  return result;
}

JobViews read_views(KeyReader& keys, const JobReading& reading) {
  const bool scripted = keys.has("cameras"), listed = keys.has("views"), drawn = keys.has("random");
  if (drawn ? scripted || listed : !scripted && !listed)
    keys.fail("needs 'cameras' (with the names of some 'views' or without), 'views' or 'random'");
  JobViews views;
  CameraScript script;
  keys.optional("cameras",
                [&](const JsonValue& v) { script.file = resolve_path(v.text(), reading.base, v.where()); });
  keys.optional("views", [&](const JsonValue& v) {
    if (scripted)
      script.names = read_view_names(v, reading.problems);
    else
      views = read_inline_views(v, reading.problems);
  });
  keys.optional("random", [&](const JsonValue& v) { views = read_random_views(v, reading.problems); });
  if (scripted) views = script;
  return views;
}

JobSequence read_sequence(const JsonValue& value, ProblemList& problems) {
  KeyReader keys(value, problems);
  JobSequence sequence;
  keys.optional("start", [&](const JsonValue& v) { sequence.start = read_time(v); });
  keys.required("frames", [&](const JsonValue& v) { sequence.frames = int(v.integer(2, kMaxFrames)); });
  keys.required("rate", [&](const JsonValue& v) { sequence.rate = v.number(kMinFrameRate, kMaxFrameRate); });
  if (std::abs(sequence.start + (sequence.frames - 1) / sequence.rate) > kLargestTime)
    keys.fail(fmt::format("the last frame must be at most at {:.0f} seconds", kLargestTime));
  keys.finish();
  return sequence;
}

std::vector<ParamValue> read_sweep_values(const ParamSpec& spec, const JsonValue& list,
                                          ProblemList& problems) {
  const std::vector<JsonValue> items = list.items();
  if (items.empty()) list.fail("a sweep needs at least one value");
  std::vector<ParamValue> values;
  std::set<std::string> seen;
  for (const auto& item : items)
    collect(problems, [&] {
      values.push_back(read_param(spec, item));
      if (!seen.insert(to_text(values.back())).second) item.fail("stands twice in the sweep");
    });
  return values;
}

void read_sweep(const JsonValue& value, const Technique& technique, ProblemList& problems,
                JobVariant& variant) {
  KeyReader keys(value, problems);
  for (const auto& spec : technique.params)
    keys.optional(spec.name, [&](const JsonValue& list) {
      if (is_path_param(spec))
        value.fail(fmt::format("'{}' is a path and cannot be swept: name a variant for each", spec.name));
      if (variant.params.contains(spec.name))
        value.fail(fmt::format("'{}' stands in 'params' too", spec.name));
      variant.sweep.emplace_back(spec.name, read_sweep_values(spec, list, problems));
    });
  keys.finish();
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
  KeyReader keys(value, reading.problems);
  JobScene scene;
  keys.required("scene", [&](const JsonValue& v) {
    scene.as_written = v.text();
    scene.file = resolve_path(scene.as_written, reading.base, v.where());
    if (!keys.has("name")) scene.name = name_of_file(scene.file, v.where());
  });
  keys.optional("name", [&](const JsonValue& v) { scene.name = read_name(v, reading.longest_name); });
  scene.views = read_views(keys, reading);
  keys.optional("sequence", [&](const JsonValue& v) { scene.sequence = read_sequence(v, reading.problems); });
  keys.finish();
  return scene;
}

JobVariant read_variant(const JsonValue& value, const JobReading& reading) {
  KeyReader keys(value, reading.problems);
  JobVariant variant;
  const Technique* technique = nullptr;  // without it nobody knows what its parameters are
  keys.required("technique", [&](const JsonValue& v) { technique = &find_technique(v.text(), v.where()); });
  if (technique) variant.name = variant.technique = technique->name;
  keys.optional("name", [&](const JsonValue& v) { variant.name = read_name(v, reading.longest_name); });
  keys.optional("preset", [&](const JsonValue& v) {
    if (technique) variant.preset = read_preset(v, technique->presets);
  });
  keys.optional("params", [&](const JsonValue& v) {
    if (technique) variant.params = read_params(v, technique->params, reading);
  });
  keys.optional("sweep", [&](const JsonValue& v) {
    if (technique) read_sweep(v, *technique, reading.problems, variant);
  });
  if (technique) add_default_paths(technique->params, reading.base, variant.params);
  keys.finish();
  return variant;
}

JobReference read_reference(const JsonValue& value, const JobReading& reading) {
  KeyReader keys(value, reading.problems);
  JobReference reference;
  const ReferenceKind* kind = nullptr;
  keys.required("kind", [&](const JsonValue& v) { kind = &find_reference_kind(v.text(), v.where()); });
  if (kind) reference.name = reference.kind = kind->name;
  keys.optional("name", [&](const JsonValue& v) { reference.name = read_name(v, reading.longest_name); });
  keys.optional("preset", [&](const JsonValue& v) {
    if (kind) reference.preset = read_preset(v, kind->presets);
  });
  keys.optional("params", [&](const JsonValue& v) {
    if (kind) reference.params = read_params(v, kind->params, reading);
  });
  keys.optional("timeout", [&](const JsonValue& v) {
    reference.timeout = std::chrono::milliseconds(std::llround(v.number(0.1, 1e7) * 1000));
  });
  keys.finish();
  return reference;
}

}  // namespace lightbench
