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
#include "pipeline/job_sources.h"
#include "pipeline/references.h"
#include "pipeline/tables.h"
#include "renderer/technique.h"
#include "reports/metric.h"
#include "scene/scene_json.h"

namespace lightbench {
namespace {

constexpr int kMaxSamples = 8;

/// The names of one kind that gates may give, exactly or by a pattern.
struct Names {
  std::vector<std::string> listed;
  std::set<std::string> exact;  ///< those, and the names that stand for all that a sweep makes

  explicit Names(std::vector<std::string> names)
      : listed(std::move(names)), exact(listed.begin(), listed.end()) {}

  void check(const JsonValue& value, const std::string& what) const {
    const std::string pattern = value.text();
    if (exact.contains(pattern)) return;
    const auto matches = [&](const std::string& name) { return matches_glob(name, pattern); };
    if (std::none_of(listed.begin(), listed.end(), matches))
      value.fail(fmt::format("no {} is called '{}'{}", what, pattern, did_you_mean(pattern, listed)));
  }
};

struct GateNames {
  Names variants;
  std::vector<std::string> references;
  Names scenes;
};

GateNames gate_names(const Job& job) {
  GateNames names{Names(row_names(expand_sweeps(job.variants))), row_names(job.references),
                  Names(row_names(job.scenes))};
  for (const auto& variant : job.variants) names.variants.exact.insert(variant.name);
  return names;
}

Gate read_gate(const JsonValue& value, const Job& job, const GateNames& names) {
  JsonObject object = value.object();
  Gate gate;
  gate.as_written = value.raw().dump();
  gate.metric = object.at("metric").choice(job.metrics);
  const JsonValue variant = object.at("variant");
  names.variants.check(variant, "variant");
  gate.variant = variant.text();
  if (const auto reference = object.find("reference")) gate.reference = reference->choice(names.references);
  if (const auto scene = object.find("scene")) {
    names.scenes.check(*scene, "scene");
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

void read_scenes(JsonObject& object, const JobReading& reading, Job& job) {
  const JsonValue scenes = object.at("scenes");
  UniqueNames names("the scene");
  for (const auto& item : scenes.items()) {
    job.scenes.push_back(read_scene(item, reading));
    names.add(job.scenes.back().name, item);
  }
  if (job.scenes.empty()) scenes.fail("a job needs at least one scene");
}

/// How many variants the sweep makes; too many are an error with their place.
std::size_t checked_count(const JobVariant& variant, const JsonValue& item) {
  try {
    return swept_count(variant);
  } catch (const Error& error) {
    item.fail(error.message());
  }
}

/// Checks the variant and all that its sweep makes, whose names have what the sweep's texts have.
void check_swept(const JobVariant& variant, const JsonValue& item, UniqueNames& names) {
  names.add(variant.name, item);
  for (const auto& one : expand_sweeps({variant})) {
    if (!one.swept_from.empty()) names.add(one.name, item);
    if (const std::string problem = name_problem(one.name, std::string::npos); !problem.empty())
      item.fail("a name that the sweep makes " + problem);
    check_variant(one, item.where());
  }
}

void read_variants(const JsonValue& variants, const JobReading& reading, UniqueNames& names, Job& job) {
  std::size_t count = 0;
  for (const auto& item : variants.items()) {
    job.variants.push_back(read_variant(item, reading));
    count += checked_count(job.variants.back(), item);
    if (count > kMaxVariants) item.fail(fmt::format("a job has at most {} variants", kMaxVariants));
    check_swept(job.variants.back(), item, names);
  }
  if (job.variants.empty()) variants.fail("a job needs at least one variant");
}

void read_sources(JsonObject& object, const JobReading& reading, Job& job) {
  UniqueNames names("the name");
  read_variants(object.at("variants"), reading, names, job);
  if (const auto references = object.find("references"))
    for (const auto& item : references->items()) {
      job.references.push_back(read_reference(item, reading));
      names.add(job.references.back().name, item);
      check_reference(job.references.back(), item.where());
    }
}

void read_gates(const JsonValue& list, Job& job) {
  const std::vector<JsonValue> items = list.items();
  if (items.empty()) return;
  if (job.references.empty()) items.front().fail("a gate needs a reference in the job");
  if (items.size() > kMaxGates) list.fail(fmt::format("a job has at most {} gates", kMaxGates));
  const GateNames names = gate_names(job);
  for (const auto& item : items) job.gates.push_back(read_gate(item, job, names));
}

void read_scoring(JsonObject& object, Job& job) {
  job.baseline = read_baseline(object, job);
  if (!job.references.empty()) job.primary_reference = job.references.front().name;
  if (const auto primary = object.find("primary_reference"))
    job.primary_reference = primary->choice(row_names(std::span(job.references)));
  job.metrics = default_metrics();
  if (std::ranges::any_of(job.scenes, [](const JobScene& scene) { return scene.sequence.has_value(); }))
    for (const auto& name : sequence_metrics()) job.metrics.push_back(name);
  if (const auto chosen = object.find("metrics"))
    job.metrics = read_names(*chosen, row_names(metrics()), "the metric");
  if (const auto gates = object.find("gates")) read_gates(*gates, job);
  if (const auto difference = object.find("difference"))
    job.difference = read_difference(difference->object());
}

}  // namespace

Job parse_job(const std::string& text, const std::filesystem::path& file, JobText kind) {
  const bool written = kind == JobText::written;
  JsonObject object = JsonValue::parse(text, file.string(), written ? kWrittenJson : kOwnJson).object();
  const JobReading reading{std::filesystem::absolute(file).parent_path(),
                           written ? kMaxNameBytes : std::string::npos};
  Job job;
  job.file = file;
  object.find("$schema");  // for editors
  const auto name = object.find("name");
  job.name = name ? read_name(*name, reading.longest_name) : name_of_file(file, file.string());
  read_image_settings(object, job);
  read_scenes(object, reading, job);
  read_sources(object, reading, job);
  read_scoring(object, job);
  if (const auto buffers = object.find("buffers"))
    job.buffers = read_names(*buffers, known_buffers(job.variants), "the buffer");
  object.finish();
  return job;
}

Job read_job(const std::filesystem::path& file) {
  return parse_job(read_file(file, kLargestTextFile), file);
}

}  // namespace lightbench
