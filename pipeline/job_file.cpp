#include "pipeline/job_file.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/error.h"
#include "base/files.h"
#include "base/image_io.h"
#include "base/text.h"
#include "pipeline/concrete.h"
#include "pipeline/job_gates.h"
#include "pipeline/job_problems.h"
#include "pipeline/job_sources.h"
#include "pipeline/references.h"
#include "pipeline/tables.h"
#include "renderer/technique.h"
#include "reports/metric.h"
#include "scene/scene_json.h"

namespace lightbench {
namespace {

constexpr int kMaxSamples = 8;

JobDifference read_difference(const JsonValue& value, ProblemList& problems) {
  KeyReader keys(value, problems);
  JobDifference difference;
  keys.optional("images", [&](const JsonValue& v) { difference.images = v.boolean(); });
  keys.optional("heat", [&](const JsonValue& v) { difference.heat = v.boolean(); });
  keys.optional("baseline", [&](const JsonValue& v) { difference.baseline = v.boolean(); });
  keys.optional("heat_scale", [&](const JsonValue& v) { difference.heat_scale = v.number(1, 255); });
  keys.finish();
  return difference;
}

/// The name of the only `direct` variant.
std::string default_baseline(const std::vector<JobVariant>& variants) {
  std::string found;
  for (const auto& variant : variants) {
    if (variant.technique != "direct") continue;
    if (!found.empty()) return "";
    found = variant.name;
  }
  return found;
}

std::vector<std::string> read_names(const JsonValue& list, const std::vector<std::string>& choices,
                                    const std::string& what, ProblemList& problems) {
  std::vector<std::string> result;
  UniqueNames names(what);
  for (const auto& item : list.items())
    collect(problems, [&] {
      result.push_back(item.choice(choices));
      names.add(result.back(), item);
    });
  return result;
}

void read_size(const JsonValue& size, Job& job) {
  const auto items = size.items();
  if (items.size() != 2) size.fail("must be [width, height]");
  const long long width = items[0].integer();
  const long long height = items[1].integer();
  check_image_size(width, height, size.where());
  job.width = int(width);
  job.height = int(height);
}

void read_image_settings(KeyReader& keys, Job& job) {
  keys.optional("size", [&](const JsonValue& v) { read_size(v, job); });
  keys.optional("samples", [&](const JsonValue& v) {
    job.samples = int(v.integer(1, kMaxSamples));
    check_image_size(1LL * job.width * job.samples, 1LL * job.height * job.samples, v.where());
  });
}

void read_scenes(const JsonValue& scenes, const JobReading& reading, Job& job) {
  const std::vector<JsonValue> items = scenes.items();
  if (items.empty()) scenes.fail("a job needs at least one scene");
  UniqueNames names("the scene");
  for (const auto& item : items) {
    JobScene scene;
    if (!collect(reading.problems, [&] { scene = read_scene(item, reading); })) continue;
    collect(reading.problems, [&] { names.add(scene.name, item); });
    job.scenes.push_back(std::move(scene));
  }
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
  const std::vector<JsonValue> items = variants.items();
  if (items.empty()) variants.fail("a job needs at least one variant");
  std::size_t count = 0;
  for (const auto& item : items) {
    JobVariant variant;
    std::size_t made = 0;
    const bool fine = collect(reading.problems, [&] {
      variant = read_variant(item, reading);
      made = checked_count(variant, item);
    });
    if (!fine) continue;
    if ((count += made) > kMaxVariants) item.fail(fmt::format("a job has at most {} variants", kMaxVariants));
    collect(reading.problems, [&] { check_swept(variant, item, names); });
    job.variants.push_back(std::move(variant));
  }
}

void read_references(const JsonValue& references, const JobReading& reading, UniqueNames& names, Job& job) {
  for (const auto& item : references.items()) {
    JobReference reference;
    if (!collect(reading.problems, [&] { reference = read_reference(item, reading); })) continue;
    collect(reading.problems, [&] {
      names.add(reference.name, item);
      check_reference(reference, item.where());
    });
    job.references.push_back(std::move(reference));
  }
}

WholeLists read_lists(KeyReader& keys, const JobReading& reading, Job& job) {
  ProblemList& problems = reading.problems;
  WholeLists whole;
  UniqueNames names("the name");
  whole.scenes = collect(
      problems, [&] { keys.required("scenes", [&](const JsonValue& v) { read_scenes(v, reading, job); }); });
  whole.variants = collect(problems, [&] {
    keys.required("variants", [&](const JsonValue& v) { read_variants(v, reading, names, job); });
  });
  whole.references = collect(problems, [&] {
    keys.optional("references", [&](const JsonValue& v) { read_references(v, reading, names, job); });
  });
  return whole;
}

void read_metrics(KeyReader& keys, ProblemList& problems, WholeLists& whole, Job& job) {
  job.metrics = default_metrics();
  if (std::ranges::any_of(job.scenes, [](const JobScene& scene) { return scene.sequence.has_value(); }))
    for (const auto& name : sequence_metrics()) job.metrics.push_back(name);
  const bool fine = collect(problems, [&] {
    keys.optional("metrics", [&](const JsonValue& v) {
      job.metrics = read_names(v, row_names(metrics()), "the metric", problems);
    });
  });
  whole.metrics = fine && (keys.has("metrics") || whole.scenes);  // sequences decide on the default
}

void read_scoring(KeyReader& keys, ProblemList& problems, WholeLists& whole, Job& job) {
  const std::vector<JobVariant> variants = expand_sweeps(job.variants);
  job.baseline = default_baseline(variants);
  keys.optional("baseline", [&](const JsonValue& v) {
    job.baseline = whole.variants ? v.choice(row_names(variants)) : v.text();
  });
  if (!job.references.empty()) job.primary_reference = job.references.front().name;
  keys.optional("primary_reference", [&](const JsonValue& v) {
    job.primary_reference = whole.references ? v.choice(row_names(job.references)) : v.text();
  });
  read_metrics(keys, problems, whole, job);
  keys.optional("gates", [&](const JsonValue& v) { read_gates(v, whole, problems, job); });
  keys.optional("difference", [&](const JsonValue& v) { job.difference = read_difference(v, problems); });
  keys.optional("buffers", [&](const JsonValue& v) {
    if (whole.variants) job.buffers = read_names(v, known_buffers(job.variants), "the buffer", problems);
  });
}

}  // namespace

Job parse_job(const std::string& text, const std::filesystem::path& file, JobText kind) {
  const bool written = kind == JobText::written;
  const JsonValue root = JsonValue::parse(text, file.string(), written ? kWrittenJson : kOwnJson);
  ProblemList problems;
  KeyReader keys(root, problems);
  const JobReading reading{std::filesystem::absolute(file).parent_path(),
                           written ? kMaxNameBytes : std::string::npos, problems};
  Job job;
  job.file = file;
  keys.optional("$schema", [](const JsonValue&) {});  // for editors
  keys.optional("name", [&](const JsonValue& v) { job.name = read_name(v, reading.longest_name); });
  if (!keys.has("name")) collect(problems, [&] { job.name = name_of_file(file, file.string()); });
  read_image_settings(keys, job);
  WholeLists whole = read_lists(keys, reading, job);
  read_scoring(keys, problems, whole, job);
  keys.finish();
  throw_problems(problems, file.string());
  return job;
}

Job read_job(const std::filesystem::path& file) {
  return parse_job(read_file(file, kLargestTextFile), file);
}

}  // namespace lightbench
