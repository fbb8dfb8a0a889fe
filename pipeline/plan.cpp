#include "pipeline/plan.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>
#include <set>

#include <fmt/format.h>

#include "base/files.h"
#include "base/hash.h"
#include "base/text.h"
#include "pipeline/concrete.h"
#include "renderer/path_tracer.h"
#include "renderer/radiance/bake_settings.h"
#include "renderer/radiance/radiance_codecs.h"
#include "renderer/technique.h"
#include "reports/metric.h"

namespace lightbench {
namespace {

/// Raised when a task's outputs change though nothing else in its key does.
constexpr int kSnapshotVersion = 1;
constexpr int kBakeTaskVersion = 1;
constexpr int kCompressVersion = 1;
constexpr int kReferenceVersion = 1;
constexpr int kScoreVersion = 1;

/// Guesses for an image of a megapixel; what was measured in earlier runs replaces them.
constexpr double kSnapshotSeconds = 0.6;
constexpr double kPathSeconds = 20;
constexpr double kRadiositySeconds = 15;
constexpr double kScoreSeconds = 0.25;
constexpr double kTexelSeconds = 2e-5;  // with 72 light points
constexpr double kPathOfTexelSeconds = 1e-6;
constexpr double kCompressSeconds = 5e-8;  // of a texel in a direction
constexpr double kBytesOfRadiance = 14;    // of a texel in a direction: as it is read, and on the GPU
constexpr double kTaskTimeout = 1800;

std::string vec_text(const glm::vec3& v) {
  return fmt::format("{} {} {}", v.x, v.y, v.z);
}

std::string view_text(const Camera& camera) {
  return fmt::format("position {} look_at {} up {} fov {}", vec_text(camera.position),
                     vec_text(camera.look_at), vec_text(camera.up), camera.fov);
}

/// What decides a view of a scene. The time is left out where nothing depends on it.
void add_view(KeyParts& parts, const View& view, const SceneFacts& facts) {
  parts.emplace_back("view", view_text(view.camera));
  if (facts.moves) parts.emplace_back("time", fmt::format("{}", view.time));
}

class Planner {
 public:
  Planner(const Job& job, const PlanFacts& facts, const std::filesystem::path& out) : facts_(facts) {
    plan_.job = job;
    plan_.out = out;
    plan_.gl = facts.gl;
    for (const auto& scene : facts.scenes) plan_.scene_hashes.push_back(key_of(scene.files));
  }

  Plan make() {
    for (int scene = 0; scene < int(job().scenes.size()); ++scene) add_scene(scene);
    return std::move(plan_);
  }

 private:
  const Job& job() const { return plan_.job; }
  const View& view_of(int scene, int view) const {
    return views_of(job().scenes[std::size_t(scene)])[std::size_t(view)];
  }
  double megapixels() const {
    return double(job().width) * job().height * job().samples * job().samples / 786432.0;
  }

  /// By how much a scene takes longer than a bare box: measured for rooms of 20 thousand to 300 thousand
  /// triangles.
  static double detail(const SceneFacts& facts) {
    return 1 + std::max(0.0, std::log10(double(facts.triangles) / 100));
  }

  /// What is rendered of a view: tasks by variant and by reference.
  struct ViewTasks {
    std::vector<std::size_t> snapshots, references;
  };

  void add_scene(int scene) {
    const auto& views = views_of(job().scenes[std::size_t(scene)]);
    shared_exports_.clear();
    object_files_.clear();
    std::vector<ViewTasks> tasks(views.size());
    for (std::size_t view = 0; view < views.size(); ++view) {
      auto& [snapshots, references] = tasks[view];
      for (int v = 0; v < int(job().variants.size()); ++v)
        snapshots.push_back(add_snapshot(scene, int(view), v));
      for (int r = 0; r < int(job().references.size()); ++r)
        references.push_back(add_reference(scene, int(view), r));
      const auto before = previous_frame(views, view);
      for (std::size_t r = 0; r < references.size(); ++r)
        for (std::size_t v = 0; v < snapshots.size(); ++v)
          add_score(scene, int(view), int(v), int(r), tasks[view], before ? &tasks[*before] : nullptr);
    }
  }

  Task start_task(TaskKind kind, int scene, int view, const std::vector<std::string>& names) {
    Task task;
    task.kind = kind;
    task.scene = scene;
    task.view = view;
    const auto& job_scene = job().scenes[std::size_t(scene)];
    std::vector<std::string> plain = {job_scene.name};
    if (view != kNone) plain.push_back(view_of(scene, view).name);
    plain.insert(plain.end(), names.begin(), names.end());
    std::vector<std::string> escaped;
    for (const auto& name : plain) escaped.push_back(escape_file_name(name));
    task.id = to_text(kind) + ":" + join(escaped, "/");
    task.label = join(plain, "/");
    task.timeout_seconds = kTaskTimeout;
    const auto& error = facts_.scenes[std::size_t(scene)].error;
    if (!error.empty()) task.refused = error;
    return task;
  }

  std::size_t finish_task(Task task) {
    task.key = key_of(task.key_parts);
    plan_.tasks.push_back(std::move(task));
    return plan_.tasks.size() - 1;
  }

  void add_size(KeyParts& parts) const {
    parts.emplace_back("size", fmt::format("{}x{}", job().width, job().height));
    parts.emplace_back("samples", std::to_string(job().samples));
  }

  static void add_files(KeyParts& parts, const SceneFacts& facts) {
    for (const auto& [name, hash] : facts.files) parts.emplace_back("file " + name, hash);
  }

  /// What makes the files of all objects that a variant draws; variants that bake, or compress, alike share
  /// it.
  const std::vector<std::size_t>& object_files(int scene, int variant_index) {
    const JobVariant& variant = job().variants[std::size_t(variant_index)];
    const std::string baked = baked_folder(job(), scene, variant);
    const std::string compressed = compressed_folder(job(), scene, variant);
    std::vector<std::size_t>& bakes = object_files_[baked];
    const std::size_t objects = facts_.scenes[std::size_t(scene)].objects.size();
    if (bakes.empty())
      for (std::size_t i = 0; i < objects; ++i) bakes.push_back(add_bake(scene, variant_index, i, baked));
    std::vector<std::size_t>& files = object_files_[compressed];
    if (files.empty())
      for (std::size_t i = 0; i < objects; ++i)
        files.push_back(add_compression(scene, variant_index, i, compressed, bakes[i]));
    return files;
  }

  std::size_t add_compression(int scene, int variant_index, std::size_t object, const std::string& folder,
                              std::size_t bake) {
    const JobVariant& variant = job().variants[std::size_t(variant_index)];
    const SceneFacts& facts = facts_.scenes[std::size_t(scene)];
    const ObjectFacts& compressed = facts.objects[object];
    const ParamValues params = variant_params(variant);
    Task task = start_task(TaskKind::compress, scene, kNone, {variant.name, compressed.file_stem});
    task.variant = variant_index;
    task.object = compressed.entity;
    task.deps = {bake};
    task.key_parts = {{"version", std::to_string(kCompressVersion)},
                      {"bake", plan_.tasks[bake].key},
                      {"parameters", codec_params_text(params)}};
    for (const char* extension : radiance_codec(params).extensions)
      task.outputs.push_back(folder + "/" + compressed.file_stem + extension);
    task.group = "compress " + std::to_string(scene);
    const double values =
        facts.texels[std::size_t(variant_index)][object] * bake_settings(params).trace.grid.layers();
    task.expected_seconds = 0.1 + values * kCompressSeconds;
    task.timeout_seconds = kTaskTimeout;
    task.resources.memory_mb = int(200 + values * kBytesOfRadiance / 1e6);
    return finish_task(std::move(task));
  }

  std::size_t add_bake(int scene, int variant_index, std::size_t object, const std::string& folder) {
    const JobVariant& variant = job().variants[std::size_t(variant_index)];
    const SceneFacts& facts = facts_.scenes[std::size_t(scene)];
    const ObjectFacts& baked = facts.objects[object];
    Task task = start_task(TaskKind::bake, scene, kNone, {variant.name, baked.file_stem});
    task.variant = variant_index;
    task.object = baked.entity;
    task.key_parts = {{"version", fmt::format("{} {}", kBakeTaskVersion, kBakeVersion)},
                      {"embree", path_tracer_version()}};
    add_files(task.key_parts, facts);
    const ParamValues params = variant_params(variant);
    task.key_parts.emplace_back("object", std::to_string(baked.entity));
    task.key_parts.emplace_back("parameters", bake_params_text(params));
    task.outputs = {folder + "/" + baked.file_stem + ".mtex"};
    task.group = "scene " + std::to_string(scene);
    const double texels = facts.texels[std::size_t(variant_index)][object];
    const BakeSettings settings = bake_settings(params);
    const double paths = settings.trace.bounces > 0 ? settings.trace.bounce_samples : 0;
    task.expected_seconds = texels * (kTexelSeconds + paths * settings.trace.bounces * kPathOfTexelSeconds);
    task.timeout_seconds = std::max(kTaskTimeout, 20 * task.expected_seconds);
    task.resources.memory_mb = int(200 + texels * settings.trace.grid.layers() * kBytesOfRadiance / 1e6 +
                                   double(facts.triangles) / 1000);
    return finish_task(std::move(task));
  }

  /// Has the snapshot wait for what it draws.
  void need_objects(Task& task, int scene, int variant_index) {
    const SceneFacts& facts = facts_.scenes[std::size_t(scene)];
    if (!facts.error.empty()) return;
    task.deps = object_files(scene, variant_index);
    std::vector<std::string> keys;
    for (const std::size_t dep : task.deps) keys.push_back(plan_.tasks[dep].key);
    task.key_parts.emplace_back("baked", join(keys, " "));
    const auto& texels = facts.texels[std::size_t(variant_index)];
    const DirectionGrid grid =
        bake_settings(variant_params(job().variants[std::size_t(variant_index)])).trace.grid;
    task.resources.memory_mb +=
        int(std::accumulate(texels.begin(), texels.end(), 0.0) * grid.layers() * kBytesOfRadiance / 1e6);
  }

  std::size_t add_snapshot(int scene, int view, int variant_index) {
    const JobVariant& variant = job().variants[std::size_t(variant_index)];
    const Technique& technique = find_technique(variant.technique, "");
    const SceneFacts& facts = facts_.scenes[std::size_t(scene)];
    Task task = start_task(TaskKind::snapshot, scene, view, {variant.name});
    task.variant = variant_index;
    const auto buffers = variant_buffers(job(), variant);
    task.key_parts = {{"version", std::to_string(kSnapshotVersion)}};
    add_files(task.key_parts, facts);
    add_view(task.key_parts, view_of(scene, view), facts);
    task.key_parts.emplace_back("technique", technique.name + " " + technique_fingerprint(technique));
    task.key_parts.emplace_back("parameters", to_text(variant_params(variant)));
    add_size(task.key_parts);
    task.key_parts.emplace_back("buffers", join(buffers, " "));
    if (technique.needs_gl) task.key_parts.emplace_back("renderer", facts_.renderer);
    if (!facts_.pictures.empty())
      for (const auto& part :
           facts_.pictures[std::size_t(scene)][std::size_t(view)][std::size_t(variant_index)])
        task.key_parts.push_back(part);
    const std::string stem = image_stem(job(), scene, view, variant.name);
    task.outputs = {stem + ".exr", stem + ".png"};
    for (const auto& buffer : buffers) {
      task.outputs.push_back(buffer_stem(job(), scene, view, variant.name, buffer) + ".exr");
      task.outputs.push_back(buffer_stem(job(), scene, view, variant.name, buffer) + ".png");
    }
    task.group = "scene " + std::to_string(scene);
    task.expected_seconds = (technique.offline ? kPathSeconds : kSnapshotSeconds) * (0.3 + megapixels());
    task.resources.memory_mb = int(200 + 300 * megapixels() + double(facts.triangles) / 2000);
    if (task.refused.empty() && !facts.unsupported.empty())
      task.refused = join(facts.unsupported[std::size_t(variant_index)], "; ");
    if (technique.needs_bake && task.refused.empty()) need_objects(task, scene, variant_index);
    return finish_task(std::move(task));
  }

  /// The files of a reference kind that all views of the scene share.
  std::size_t shared_export(int scene, const JobReference& reference, const KeyParts& parts) {
    if (const auto found = shared_exports_.find(reference.kind); found != shared_exports_.end())
      return found->second;
    Task task = start_task(TaskKind::export_, scene, kNone, {reference.kind});
    for (const auto& part : parts)
      if (part.first.starts_with("shared")) task.key_parts.push_back(part);
    task.reference = int(&reference - job().references.data());
    task.group = "scene " + std::to_string(scene);
    task.expected_seconds = 0.05 + double(facts_.scenes[std::size_t(scene)].triangles) * 3e-6;
    task.resources.memory_mb = int(100 + double(facts_.scenes[std::size_t(scene)].triangles) / 1000);
    return shared_exports_[reference.kind] = finish_task(std::move(task));
  }

  std::size_t view_export(int scene, int view, int reference_index, const KeyParts& parts) {
    const JobReference& reference = job().references[std::size_t(reference_index)];
    Task task = start_task(TaskKind::export_, scene, view, {reference.name});
    task.reference = reference_index;
    task.key_parts = parts;
    const std::string stem = image_stem(job(), scene, view, reference.name);
    for (const auto& suffix :
         find_reference_kind(reference.kind, "").view_suffixes(reference_params(reference)))
      task.outputs.push_back(stem + suffix);
    task.group = "scene " + std::to_string(scene);
    task.expected_seconds = 0.02;
    task.resources.memory_mb = 100;
    return finish_task(std::move(task));
  }

  /// What decides a reference image, but for its size and the tool: the files that it is exported to, or
  /// those of the scene where the tool renders the scene itself.
  KeyParts reference_parts(int scene, int view, int reference_index) const {
    const SceneFacts& facts = facts_.scenes[std::size_t(scene)];
    const JobReference& reference = job().references[std::size_t(reference_index)];
    if (find_reference_kind(reference.kind, "").exports())
      return facts.exports.empty() ? KeyParts()
                                   : facts.exports[std::size_t(reference_index)][std::size_t(view)];
    KeyParts parts;
    add_files(parts, facts);
    add_view(parts, view_of(scene, view), facts);
    parts.emplace_back("parameters", to_text(reference_params(reference)));
    return parts;
  }

  std::size_t add_reference(int scene, int view, int reference_index) {
    const JobReference& reference = job().references[std::size_t(reference_index)];
    const ReferenceKind& kind = find_reference_kind(reference.kind, "");
    const ParamValues params = reference_params(reference);
    const SceneFacts& facts = facts_.scenes[std::size_t(scene)];
    Task task = start_task(TaskKind::reference, scene, view, {reference.name});
    task.reference = reference_index;
    task.key_parts = reference_parts(scene, view, reference_index);
    if (kind.exports())
      task.deps = {shared_export(scene, reference, task.key_parts),
                   view_export(scene, view, reference_index, task.key_parts)};
    else
      task.group = "scene " + std::to_string(scene);
    const std::size_t renderings = kind.exports() ? kind.view_suffixes(params).size() : 1;
    task.key_parts.emplace_back("version", std::to_string(kReferenceVersion));
    add_size(task.key_parts);
    const auto tool = facts_.tools.find(reference.kind);
    task.key_parts.emplace_back("tool", tool == facts_.tools.end() ? "none" : tool->second);
    const std::string stem = image_stem(job(), scene, view, reference.name);
    task.outputs = {stem + ".exr", stem + ".png"};
    const double seconds = kind.bounces(params) > 0 ? kRadiositySeconds : kRadiositySeconds / 10;
    task.expected_seconds = 1 + (0.3 + megapixels()) * seconds * detail(facts);
    task.timeout_seconds = double(renderings) * double(reference.timeout.count()) / 1000 + 60;
    task.resources.memory_mb = int(100 + 100 * megapixels() + double(facts.triangles) / 1000);
    const auto missing = facts_.missing_tools.find(reference.kind);
    if (task.refused.empty() && missing != facts_.missing_tools.end()) task.refused = missing->second;
    return finish_task(std::move(task));
  }

  std::string metric_versions() const {
    std::vector<std::string> parts;
    for (const auto& name : job().metrics)
      parts.push_back(fmt::format("{}:{}", name, find_metric(name, "").version));
    return join(parts, " ");
  }

  /// `before` are the tasks of the frame before; null where there is none.
  void add_score(int scene, int view, int variant_index, int reference_index, const ViewTasks& tasks,
                 const ViewTasks* before) {
    const auto& variant = job().variants[std::size_t(variant_index)].name;
    const auto& reference = job().references[std::size_t(reference_index)].name;
    const auto& difference = job().difference;
    Task task = start_task(TaskKind::score, scene, view, {variant, reference});
    task.variant = variant_index;
    task.reference = reference_index;
    task.deps = {tasks.snapshots[std::size_t(variant_index)], tasks.references[std::size_t(reference_index)]};
    task.key_parts = {{"version", std::to_string(kScoreVersion)},
                      {"snapshot", plan_.tasks[task.deps[0]].key},
                      {"reference", plan_.tasks[task.deps[1]].key},
                      {"metrics", metric_versions()}};
    task.key_parts.emplace_back("difference", fmt::format("{} {} {} {}", difference.images, difference.heat,
                                                          difference.baseline, difference.heat_scale));
    const std::string stem = score_stem(job(), scene, view, variant, reference);
    task.outputs = {stem + ".score.json"};
    if (difference.images) task.outputs.push_back(stem + ".diff.png");
    if (difference.heat) task.outputs.push_back(stem + ".heat.png");
    if (!job().baseline.empty()) add_baseline(task, scene, view, variant, tasks.snapshots);
    if (before && needs_previous(job().metrics))
      add_previous(task, before->snapshots[std::size_t(variant_index)],
                   before->references[std::size_t(reference_index)]);
    task.group = "scores " + std::to_string(scene);
    task.expected_seconds = kScoreSeconds * megapixels() / (job().samples * job().samples);
    task.resources.memory_mb = int(100 + 100 * megapixels());
    task.timeout_seconds = kTaskTimeout;
    finish_task(std::move(task));
  }

  void add_baseline(Task& task, int scene, int view, const std::string& variant,
                    const std::vector<std::size_t>& snapshots) {
    const auto found = std::find_if(job().variants.begin(), job().variants.end(),
                                    [&](const JobVariant& v) { return v.name == job().baseline; });
    assert(found != job().variants.end());
    const std::size_t baseline = snapshots[std::size_t(found - job().variants.begin())];
    task.key_parts.emplace_back("baseline", plan_.tasks[baseline].key);
    if (variant == job().baseline) return;
    task.deps.push_back(baseline);
    const bool first_reference = task.reference == 0;
    if (job().difference.images && job().difference.baseline && first_reference)
      task.outputs.push_back(score_stem(job(), scene, view, variant, job().baseline) + ".diff.png");
  }

  void add_previous(Task& task, std::size_t snapshot, std::size_t reference) {
    task.key_parts.emplace_back("snapshot before", plan_.tasks[snapshot].key);
    task.key_parts.emplace_back("reference before", plan_.tasks[reference].key);
    task.deps.push_back(snapshot);
    task.deps.push_back(reference);
  }

  const PlanFacts& facts_;
  Plan plan_;
  std::map<std::string, std::size_t> shared_exports_;
  std::map<std::string, std::vector<std::size_t>> object_files_;  ///< of the scene, by folder
};

}  // namespace

const std::vector<std::string>& task_kind_names() {
  static const std::vector<std::string> names = {"bake",   "compress",  "snapshot",
                                                 "export", "reference", "score"};
  return names;
}

std::string to_text(TaskKind kind) {
  return task_kind_names()[static_cast<std::size_t>(kind)];
}

std::string key_of(const KeyParts& parts) {
  Hasher hasher;
  for (const auto& [name, value] : parts) hasher.field(name, value);
  return hasher.digest();
}

Plan make_plan(const Job& job, const PlanFacts& facts, const std::filesystem::path& out) {
  return Planner(job, facts, out).make();
}

}  // namespace lightbench
