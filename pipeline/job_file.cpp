#include "pipeline/job_file.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/files.h"
#include "base/image_io.h"
#include "base/text.h"
#include "pipeline/concrete.h"
#include "pipeline/references.h"
#include "pipeline/tables.h"
#include "renderer/technique.h"
#include "reports/metric.h"
#include "scene/camera_script.h"

namespace lightbench {
namespace {

constexpr int kMaxSamples = 8;
constexpr int kMaxRandomViews = 10000;
constexpr std::size_t kMaxNameBytes = 200;

/// A name that a person reads in tables: not empty, one line, no control bytes.
std::string read_name(const JsonValue& value) {
  const std::string name = value.text();
  if (trimmed(name).empty()) value.fail("a name must not be empty");
  if (name.size() > kMaxNameBytes)
    value.fail(fmt::format("a name must have at most {} bytes", kMaxNameBytes));
  const auto is_control = [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; };
  if (std::any_of(name.begin(), name.end(), is_control))
    value.fail("a name must not have control characters");
  return name;
}

/// Throws where a name stands twice.
class UniqueNames {
 public:
  explicit UniqueNames(std::string what) : what_(std::move(what)) {}
  void add(const std::string& name, const JsonValue& place) {
    if (!seen_.insert(name).second) place.fail(fmt::format("{} '{}' stands twice", what_, name));
  }

 private:
  std::string what_;
  std::set<std::string> seen_;
};

std::string full_path(const std::string& text, const std::filesystem::path& base, const std::string& where) {
  return resolve_path(text, base, where).lexically_normal().string();
}

GivenParams read_params(JsonObject object, std::span<const ParamSpec> specs,
                        const std::filesystem::path& base) {
  GivenParams result;
  for (const auto& spec : specs)
    if (const auto value = object.find(spec.name)) {
      result[spec.name] = read_param(spec, *value);
      if (is_path_param(spec)) result[spec.name] = full_path(value->text(), base, value->where());
    }
  object.finish();
  return result;
}

/// Paths that nobody gives are relative to the job file too.
void add_default_paths(std::span<const ParamSpec> specs, const std::filesystem::path& base,
                       GivenParams& params) {
  for (const auto& spec : specs)
    if (is_path_param(spec) && !params.contains(spec.name))
      params[spec.name] = full_path(std::get<std::string>(spec.default_value), base, spec.name);
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
    return CameraScript{resolve_path(cameras->text(), base, cameras->where()).lexically_normal(),
                        views ? read_view_names(*views) : std::vector<std::string>()};
  if (views) return read_inline_views(*views);
  return read_random_views(random->object());
}

JobScene read_scene(const JsonValue& value, const std::filesystem::path& base) {
  JsonObject object = value.object();
  JobScene scene;
  const JsonValue path = object.at("scene");
  scene.as_written = path.text();
  scene.file = resolve_path(scene.as_written, base, path.where()).lexically_normal();
  const auto name = object.find("name");
  scene.name = name ? read_name(*name) : scene.file.stem().string();
  scene.views = read_views(object, base);
  object.finish();
  return scene;
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
  for (const auto& key : object.keys())
    if (variant.params.contains(key)) object.fail(fmt::format("'{}' stands in 'params' too", key));
  for (const auto& spec : technique.params)
    if (const auto list = object.find(spec.name))
      variant.sweep.emplace_back(spec.name, read_sweep_values(spec, *list));
  object.finish();
}

JobVariant read_variant(const JsonValue& value, const std::filesystem::path& base) {
  JsonObject object = value.object();
  JobVariant variant;
  const JsonValue technique_name = object.at("technique");
  const Technique& technique = find_technique(technique_name.text(), technique_name.where());
  variant.technique = technique.name;
  const auto name = object.find("name");
  variant.name = name ? read_name(*name) : technique.name;
  variant.preset = read_preset(object, technique.presets);
  if (const auto params = object.find("params"))
    variant.params = read_params(params->object(), technique.params, base);
  add_default_paths(technique.params, base, variant.params);
  if (const auto sweep = object.find("sweep")) read_sweep(sweep->object(), technique, variant);
  object.finish();
  return variant;
}

JobReference read_reference(const JsonValue& value, const std::filesystem::path& base) {
  JsonObject object = value.object();
  JobReference reference;
  const JsonValue kind_name = object.at("kind");
  const ReferenceKind& kind = find_reference_kind(kind_name.text(), kind_name.where());
  reference.kind = kind.name;
  const auto name = object.find("name");
  reference.name = name ? read_name(*name) : kind.name;
  reference.preset = read_preset(object, kind.presets);
  if (const auto params = object.find("params"))
    reference.params = read_params(params->object(), kind.params, base);
  if (const auto timeout = object.find("timeout"))
    reference.timeout = std::chrono::milliseconds(std::llround(timeout->number(0.1, 1e7) * 1000));
  object.finish();
  return reference;
}

/// One of the names, or a pattern that matches some.
void check_pattern(const JsonValue& value, const std::vector<std::string>& names, const std::string& what) {
  const std::string pattern = value.text();
  const auto matches = [&](const std::string& name) { return matches_name(name, pattern); };
  if (std::none_of(names.begin(), names.end(), matches))
    value.fail(fmt::format("no {} is called '{}'{}", what, pattern, did_you_mean(pattern, names)));
}

std::vector<std::string> all_variant_names(const Job& job) {
  std::vector<std::string> names = row_names(std::span(job.variants));
  for (const auto& variant : expand_sweeps(job.variants)) names.push_back(variant.name);
  return names;
}

Gate read_gate(const JsonValue& value, const Job& job) {
  JsonObject object = value.object();
  Gate gate;
  gate.as_written = value.raw().dump();
  gate.metric = object.at("metric").choice(job.metrics);
  const JsonValue variant = object.at("variant");
  check_pattern(variant, all_variant_names(job), "variant");
  gate.variant = variant.text();
  if (const auto reference = object.find("reference"))
    gate.reference = reference->choice(row_names(std::span(job.references)));
  if (const auto scene = object.find("scene")) {
    check_pattern(*scene, row_names(std::span(job.scenes)), "scene");
    gate.scene = scene->text();
  }
  if (const auto view = object.find("view")) gate.view = view->text();
  if (const auto min = object.find("min")) gate.min = min->number();
  if (const auto max = object.find("max")) gate.max = max->number();
  if (!gate.min && !gate.max) value.fail("a gate needs 'min' or 'max'");
  if (gate.min && gate.max && *gate.min > *gate.max) value.fail("'min' is above 'max'");
  if (const auto over = object.find("over")) gate.over = parse_gate_over(*over);
  object.finish();
  return gate;
}

JobDifference read_difference(JsonObject object) {
  JobDifference difference;
  if (const auto images = object.find("images")) difference.images = images->boolean();
  if (const auto heat = object.find("heat")) difference.heat = heat->boolean();
  if (const auto baseline = object.find("baseline")) difference.baseline = baseline->boolean();
  if (const auto scale = object.find("heat_scale")) difference.heat_scale = scale->number(1, 255);
  object.finish();
  return difference;
}

/// The job's baseline: as named, else its only `direct` variant.
std::string read_baseline(JsonObject& object, const Job& job) {
  const auto variants = expand_sweeps(job.variants);
  if (const auto value = object.find("baseline")) return value->choice(row_names(std::span(variants)));
  std::string found;
  for (const auto& variant : variants) {
    if (variant.technique != "direct") continue;
    if (!found.empty()) return "";
    found = variant.name;
  }
  return found;
}

std::vector<std::string> read_names(const JsonValue& list, const std::vector<std::string>& choices,
                                    const std::string& what) {
  std::vector<std::string> result;
  UniqueNames names(what);
  for (const auto& item : list.items()) {
    result.push_back(item.choice(choices));
    names.add(result.back(), item);
  }
  return result;
}

void read_image_settings(JsonObject& object, Job& job) {
  if (const auto size = object.find("size")) {
    const auto items = size->items();
    if (items.size() != 2) size->fail("must be [width, height]");
    const long long width = items[0].integer();
    const long long height = items[1].integer();
    check_image_size(width, height, size->where());
    job.width = int(width);
    job.height = int(height);
  }
  if (const auto samples = object.find("samples")) {
    job.samples = int(samples->integer(1, kMaxSamples));
    check_image_size(1LL * job.width * job.samples, 1LL * job.height * job.samples, samples->where());
  }
}

void read_scenes(JsonObject& object, const std::filesystem::path& base, Job& job) {
  const JsonValue scenes = object.at("scenes");
  UniqueNames names("the scene");
  for (const auto& item : scenes.items()) {
    job.scenes.push_back(read_scene(item, base));
    names.add(job.scenes.back().name, item);
  }
  if (job.scenes.empty()) scenes.fail("a job needs at least one scene");
}

void read_sources(JsonObject& object, const std::filesystem::path& base, Job& job) {
  const JsonValue variants = object.at("variants");
  UniqueNames names("the name");
  for (const auto& item : variants.items()) {
    job.variants.push_back(read_variant(item, base));
    for (const auto& variant : expand_sweeps({job.variants.back()})) names.add(variant.name, item);
    for (const auto& variant : expand_sweeps({job.variants.back()})) check_variant(variant, item.where());
  }
  if (job.variants.empty()) variants.fail("a job needs at least one variant");
  if (const auto references = object.find("references"))
    for (const auto& item : references->items()) {
      job.references.push_back(read_reference(item, base));
      names.add(job.references.back().name, item);
      check_reference(job.references.back(), item.where());
    }
}

void read_scoring(JsonObject& object, Job& job) {
  job.baseline = read_baseline(object, job);
  if (!job.references.empty()) job.primary_reference = job.references.front().name;
  if (const auto primary = object.find("primary_reference"))
    job.primary_reference = primary->choice(row_names(std::span(job.references)));
  job.metrics = row_names(metrics());
  if (const auto chosen = object.find("metrics"))
    job.metrics = read_names(*chosen, job.metrics, "the metric");
  if (const auto gates = object.find("gates"))
    for (const auto& item : gates->items()) {
      if (job.references.empty()) item.fail("a gate needs a reference in the job");
      job.gates.push_back(read_gate(item, job));
    }
  if (const auto difference = object.find("difference"))
    job.difference = read_difference(difference->object());
}

}  // namespace

Job parse_job(const std::string& text, const std::filesystem::path& file) {
  JsonObject object = JsonValue::parse(text, file.string()).object();
  const auto base = std::filesystem::absolute(file).parent_path();
  Job job;
  job.file = file;
  object.find("$schema");  // for editors
  const auto name = object.find("name");
  job.name = name ? read_name(*name) : file.stem().string();
  read_image_settings(object, job);
  read_scenes(object, base, job);
  read_sources(object, base, job);
  read_scoring(object, job);
  if (const auto buffers = object.find("buffers"))
    job.buffers = read_names(*buffers, known_buffers(job.variants), "the buffer");
  object.finish();
  return job;
}

Job read_job(const std::filesystem::path& file) {
  return parse_job(read_file(file), file);
}

}  // namespace lightbench
