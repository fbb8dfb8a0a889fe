#include "pipeline/job_file.h"

#include <algorithm>

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

namespace lightbench {
namespace {

constexpr int kMaxSamples = 8;

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
    names.add(job.variants.back().name, item);
    for (const auto& variant : expand_sweeps({job.variants.back()})) {
      if (!variant.swept_from.empty()) names.add(variant.name, item);
      check_variant(variant, item.where());
    }
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
  job.metrics = default_metrics();
  if (std::ranges::any_of(job.scenes, [](const JobScene& scene) { return scene.sequence.has_value(); }))
    for (const auto& name : sequence_metrics()) job.metrics.push_back(name);
  if (const auto chosen = object.find("metrics"))
    job.metrics = read_names(*chosen, row_names(metrics()), "the metric");
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
