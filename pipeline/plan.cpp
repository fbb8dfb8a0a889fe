#include "pipeline/plan.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "base/files.h"
#include "base/hash.h"
#include "base/text.h"
#include "pipeline/concrete.h"
#include "pipeline/plan_bakes.h"
#include "pipeline/plan_draft.h"
#include "renderer/path_tracer.h"
#include "renderer/technique.h"
#include "reports/metric.h"
#include "scene/light_points.h"

namespace lightbench {
namespace {

/// Raised when a task's outputs change though nothing else in its key does.
constexpr int kSnapshotVersion = 2;
constexpr int kReferenceVersion = 2;
constexpr int kScoreVersion = 2;

/// Guesses for an image of a megapixel; what was measured in earlier runs replaces them.
constexpr double kSnapshotSeconds = 0.6;
constexpr double kPathSeconds = 20;
constexpr double kRadiositySeconds = 15;
constexpr double kScoreSeconds = 0.25;

/// How often a task holds the scene's textures: software OpenGL keeps 16 bits a component beside our 8, and
/// an export encodes them.
constexpr double kDrawnTextures = 3;
constexpr double kExportedTextures = 2;

/// Bytes as megabytes that fit a task's resources, however many.
int megabytes_of(double bytes) {
  return int(std::min(bytes / 1e6, 1e9));
}

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
  Planner(const Job& job, const PlanFacts& facts, const std::filesystem::path& out)
      : draft_(job, facts, out) {}

  Plan make() && {
    for (int scene = 0; scene < int(job().scenes.size()); ++scene) add_scene(scene);
    return std::move(draft_).take();
  }

 private:
  const Job& job() const { return draft_.job(); }
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

  /// What the shadow maps of a scene's lights take.
  static double shadow_seconds(const ParamValues& params, const SceneFacts& facts) {
    if (!params.all().contains("shadow_size") || params.text("shadows") == "none") return 0;
    const double size = params.integer("shadow_size") / 2048.0;
    return kShadowMapSeconds * double(facts.light_points) * size * size;
  }

  void add_size(KeyParts& parts) const {
    parts.emplace_back("size", fmt::format("{}x{}", job().width, job().height));
    parts.emplace_back("samples", std::to_string(job().samples));
  }

  std::size_t add_snapshot(int scene, int view, int variant_index) {
    const JobVariant& variant = draft_.variant(variant_index);
    const Technique& technique = find_technique(variant.technique, "");
    const SceneFacts& facts = draft_.facts(scene);
    Task task = draft_.start(TaskKind::snapshot, scene, view, {variant.name});
    task.variant = variant_index;
    const auto buffers = variant_buffers(job(), variant);
    task.key_parts = {{"version", std::to_string(kSnapshotVersion)}};
    add_files(task.key_parts, facts);
    add_view(task.key_parts, draft_.view(scene, view), facts);
    task.key_parts.emplace_back("technique", technique.name + " " + technique_fingerprint(technique));
    task.key_parts.emplace_back("parameters", to_text(variant_params(variant)));
    add_size(task.key_parts);
    task.key_parts.emplace_back("buffers", join(buffers, " "));
    if (technique.needs_gl) task.key_parts.emplace_back("renderer", draft_.facts().renderer);
    if (!draft_.facts().pictures.empty())
      for (const auto& part :
           draft_.facts().pictures[std::size_t(scene)][std::size_t(view)][std::size_t(variant_index)])
        task.key_parts.push_back(part);
    const std::string stem = image_stem(job(), scene, view, variant.name);
    task.outputs = {stem + ".exr", stem + ".png"};
    for (const auto& buffer : buffers) {
      task.outputs.push_back(buffer_stem(job(), scene, view, variant.name, buffer) + ".exr");
      task.outputs.push_back(buffer_stem(job(), scene, view, variant.name, buffer) + ".png");
    }
    task.group = "scene " + std::to_string(scene);
    task.expected_seconds = (technique.offline ? kPathSeconds : kSnapshotSeconds) * (0.3 + megapixels()) +
                            shadow_seconds(variant_params(variant), facts);
    task.timeout_seconds = std::max(task.timeout_seconds, 20 * task.expected_seconds);
    task.resources.memory_mb = int(200 + 300 * megapixels() + double(facts.triangles) / 2000) +
                               megabytes_of(kDrawnTextures * double(facts.texture_bytes));
    if (task.refused.empty() && !facts.unsupported.empty())
      task.refused = join(facts.unsupported[std::size_t(variant_index)], "; ");
    if (technique.needs_bake && task.refused.empty()) bakes_.need_objects(task);
    return draft_.add(std::move(task));
  }

  /// The files of a reference kind that all views of the scene share.
  std::size_t shared_export(int scene, const JobReference& reference, const KeyParts& parts) {
    if (const auto found = shared_exports_.find(reference.kind); found != shared_exports_.end())
      return found->second;
    Task task = draft_.start(TaskKind::export_, scene, kNone, {reference.kind});
    for (const auto& part : parts)
      if (part.first.starts_with("shared")) task.key_parts.push_back(part);
    task.reference = int(&reference - job().references.data());
    task.group = "scene " + std::to_string(scene);
    task.expected_seconds = 0.05 + double(draft_.facts(scene).triangles) * 3e-6;
    task.resources.memory_mb = int(100 + double(draft_.facts(scene).triangles) / 1000) +
                               megabytes_of(kExportedTextures * double(draft_.facts(scene).texture_bytes));
    return shared_exports_[reference.kind] = draft_.add(std::move(task));
  }

  std::size_t view_export(int scene, int view, int reference_index, const KeyParts& parts) {
    const JobReference& reference = job().references[std::size_t(reference_index)];
    Task task = draft_.start(TaskKind::export_, scene, view, {reference.name});
    task.reference = reference_index;
    task.key_parts = parts;
    const std::string stem = image_stem(job(), scene, view, reference.name);
    for (const auto& suffix :
         find_reference_kind(reference.kind, "").view_suffixes(reference_params(reference)))
      task.outputs.push_back(stem + suffix);
    task.group = "scene " + std::to_string(scene);
    task.expected_seconds = 0.02;
    task.resources.memory_mb = 100 + megabytes_of(double(draft_.facts(scene).texture_bytes));
    return draft_.add(std::move(task));
  }

  /// What decides a reference image, but for its size and the tool: the files that it is exported to, or
  /// those of the scene where the tool renders the scene itself.
  KeyParts reference_parts(int scene, int view, int reference_index) const {
    const SceneFacts& facts = draft_.facts(scene);
    const JobReference& reference = job().references[std::size_t(reference_index)];
    if (find_reference_kind(reference.kind, "").exports())
      return facts.exports.empty() ? KeyParts()
                                   : facts.exports[std::size_t(reference_index)][std::size_t(view)];
    KeyParts parts;
    add_files(parts, facts);
    add_view(parts, draft_.view(scene, view), facts);
    parts.emplace_back("parameters", to_text(reference_params(reference)));
    return parts;
  }

  std::size_t add_reference(int scene, int view, int reference_index) {
    const JobReference& reference = job().references[std::size_t(reference_index)];
    const ReferenceKind& kind = find_reference_kind(reference.kind, "");
    const ParamValues params = reference_params(reference);
    const SceneFacts& facts = draft_.facts(scene);
    Task task = draft_.start(TaskKind::reference, scene, view, {reference.name});
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
    const auto tool = draft_.facts().tools.find(reference.kind);
    task.key_parts.emplace_back("tool", tool == draft_.facts().tools.end() ? "none" : tool->second);
    const std::string stem = image_stem(job(), scene, view, reference.name);
    task.outputs = {stem + ".exr", stem + ".png"};
    const double seconds = kind.bounces(params) > 0 ? kRadiositySeconds : kRadiositySeconds / 10;
    task.expected_seconds = 1 + (0.3 + megapixels()) * seconds * detail(facts);
    task.timeout_seconds = double(renderings) * double(reference.timeout.count()) / 1000 + 60;
    task.resources.memory_mb = int(100 + 100 * megapixels() + double(facts.triangles) / 1000) +
                               megabytes_of(kExportedTextures * double(facts.texture_bytes));
    const auto missing = draft_.facts().missing_tools.find(reference.kind);
    if (task.refused.empty() && missing != draft_.facts().missing_tools.end()) task.refused = missing->second;
    return draft_.add(std::move(task));
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
    const auto& variant = draft_.variant(variant_index).name;
    const auto& reference = job().references[std::size_t(reference_index)].name;
    const auto& difference = job().difference;
    Task task = draft_.start(TaskKind::score, scene, view, {variant, reference});
    task.variant = variant_index;
    task.reference = reference_index;
    task.deps = {tasks.snapshots[std::size_t(variant_index)], tasks.references[std::size_t(reference_index)]};
    task.key_parts = {{"version", std::to_string(kScoreVersion)},
                      {"snapshot", draft_.tasks()[task.deps[0]].key},
                      {"reference", draft_.tasks()[task.deps[1]].key},
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
    draft_.add(std::move(task));
  }

  void add_baseline(Task& task, int scene, int view, const std::string& variant,
                    const std::vector<std::size_t>& snapshots) {
    const auto found = std::find_if(job().variants.begin(), job().variants.end(),
                                    [&](const JobVariant& v) { return v.name == job().baseline; });
    assert(found != job().variants.end());
    const std::size_t baseline = snapshots[std::size_t(found - job().variants.begin())];
    task.key_parts.emplace_back("baseline", draft_.tasks()[baseline].key);
    if (variant == job().baseline) return;
    task.deps.push_back(baseline);
    const bool first_reference = task.reference == 0;
    if (job().difference.images && job().difference.baseline && first_reference)
      task.outputs.push_back(score_stem(job(), scene, view, variant, job().baseline) + ".diff.png");
  }

  void add_previous(Task& task, std::size_t snapshot, std::size_t reference) {
    task.key_parts.emplace_back("snapshot before", draft_.tasks()[snapshot].key);
    task.key_parts.emplace_back("reference before", draft_.tasks()[reference].key);
    task.deps.push_back(snapshot);
    task.deps.push_back(reference);
  }

  PlanDraft draft_;
  BakePlanner bakes_{draft_};
  std::map<std::string, std::size_t> shared_exports_;
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
