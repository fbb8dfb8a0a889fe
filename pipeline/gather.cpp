#include "pipeline/gather.h"

#include <algorithm>
#include <set>

#include "pipeline/concrete.h"
#include "pipeline/tables.h"
#include "pipeline/version.h"
#include "renderer/technique.h"
#include "reports/value_text.h"

namespace lightbench {
namespace {

std::map<std::string, std::string> params_as_text(const ParamValues& params) {
  std::map<std::string, std::string> result;
  for (const auto& [name, value] : params.all()) result[name] = to_text(value);
  return result;
}

/// Of each task, the variants whose snapshots need the object's files that it makes.
std::vector<std::set<int>> variants_that_draw(const Plan& plan) {
  std::vector<std::set<int>> variants(plan.tasks.size());
  for (std::size_t i = plan.tasks.size(); i-- > 0;) {  // what needs them stands behind them
    const Task& task = plan.tasks[i];
    if (task.kind == TaskKind::snapshot) variants[i].insert(task.variant);
    if (task.kind == TaskKind::snapshot || task.kind == TaskKind::compress)
      for (const std::size_t dep : task.deps) variants[dep].insert(variants[i].begin(), variants[i].end());
  }
  return variants;
}

class Gatherer {
 public:
  Gatherer(const Plan& plan, const PlanFacts& facts, const std::vector<TaskOutcome>& outcomes)
      : plan_(plan), facts_(facts), outcomes_(outcomes), drawn_by_(variants_that_draw(plan)) {}

  RunReport gather() {
    const Job& job = plan_.job;
    report_.job = job.name;
    report_.job_file = job.file.string();
    report_.width = job.width;
    report_.height = job.height;
    report_.samples = job.samples;
    report_.baseline = job.baseline;
    report_.primary_reference = job.primary_reference;
    report_.metric_names = job.metrics;
    report_.tools = tool_versions();
    if (!facts_.renderer.empty()) report_.tools["OpenGL"] = facts_.renderer;
    for (const auto& [kind, version] : facts_.tools) report_.tools[kind] = version;
    add_sources();
    add_scenes();
    for (const auto& scene : job.scenes) add_sequences(scene);
    for (std::size_t i = 0; i < plan_.tasks.size(); ++i) add_task(i);
    return std::move(report_);
  }

 private:
  void add_sources() {
    for (const auto& variant : plan_.job.variants) {
      const Technique& technique = find_technique(variant.technique, "");
      const ParamValues params = variant_params(variant);
      report_.variants.push_back({.name = variant.name,
                                  .kind = variant.technique,
                                  .params = params_as_text(params),
                                  .bounces = technique_bounces(technique, params),
                                  .offline = technique.offline,
                                  .tool = technique.needs_gl ? facts_.renderer : "",
                                  .limited = technique.limited,
                                  .external = technique.external});
    }
    for (const auto& reference : plan_.job.references) {
      const ParamValues params = reference_params(reference);
      const auto tool = facts_.tools.find(reference.kind);
      report_.references.push_back({.name = reference.name,
                                    .kind = reference.kind,
                                    .params = params_as_text(params),
                                    .bounces = find_reference_kind(reference.kind, "").bounces(params),
                                    .tool = tool == facts_.tools.end() ? "" : tool->second});
    }
  }

  void add_scenes() {
    for (std::size_t i = 0; i < plan_.job.scenes.size(); ++i) {
      const SceneFacts& facts = facts_.scenes[i];
      ReportScene scene;
      scene.name = plan_.job.scenes[i].name;
      scene.file = plan_.job.scenes[i].as_written;
      scene.triangles = facts.triangles;
      scene.hash = plan_.scene_hashes[i];
      scene.warnings = facts.warnings;
      for (const auto& [kind, warnings] : facts.kind_warnings)
        for (const auto& warning : warnings) scene.warnings.push_back(kind + ": " + warning);
      if (!facts.error.empty()) scene.warnings.push_back("could not be read: " + facts.error);
      for (const auto& credit : facts.credits)
        scene.credits.push_back({credit.piece, credit.creator, credit.license});
      report_.scenes.push_back(std::move(scene));
    }
  }

  void add_sequences(const JobScene& scene) {
    std::vector<const View*> frames;
    for (const auto& view : views_of(scene))
      if (view.frame) frames.push_back(&view);
    std::ranges::stable_sort(frames, {}, [](const View* view) { return view->frame->number; });
    std::map<std::string, std::size_t> index;
    for (const View* view : frames) {
      const auto [entry, added] = index.try_emplace(view->frame->sequence, report_.sequences.size());
      if (added) report_.sequences.push_back({scene.name, view->frame->sequence, {}});
      report_.sequences[entry->second].frames.push_back({view->name, view->time});
    }
  }

  void add_task(std::size_t i) {
    switch (plan_.tasks[i].kind) {
      case TaskKind::snapshot:
      case TaskKind::reference:
        return add_image(i);
      case TaskKind::score:
        return add_score(i);
      case TaskKind::bake:
        report_.bakes.push_back(object_row(i));
        return;
      case TaskKind::compress:
        report_.compressions.push_back(object_row(i));
        return;
      case TaskKind::export_:
        return;  // told with the image that needs it
    }
  }

  /// An image that was not made because its export or bake failed has failed as well: it is the row that
  /// people see. So has a compression, which stands between the two.
  Outcome outcome_of(std::size_t i) const {
    switch (outcomes_[i].state) {
      case TaskState::done:
      case TaskState::cached:
        return Outcome::ok;
      case TaskState::failed:
        return Outcome::failed;
      default:
        break;
    }
    const Task& task = plan_.tasks[i];
    const bool failed_before =
        (task.kind == TaskKind::reference || task.kind == TaskKind::snapshot ||
         task.kind == TaskKind::compress) &&
        std::ranges::any_of(task.deps, [&](std::size_t dep) { return outcome_of(dep) == Outcome::failed; });
    return failed_before ? Outcome::failed : Outcome::skipped;
  }

  void add_image(std::size_t i) {
    const Task& task = plan_.tasks[i];
    const Job& job = plan_.job;
    ReportImage image;
    image.scene = job.scenes[std::size_t(task.scene)].name;
    image.view = views_of(job.scenes[std::size_t(task.scene)])[std::size_t(task.view)].name;
    image.is_reference = task.kind == TaskKind::reference;
    image.source = image.is_reference ? job.references[std::size_t(task.reference)].name
                                      : job.variants[std::size_t(task.variant)].name;
    image.outcome = outcome_of(i);
    image.error = outcomes_[i].reason;
    image.key = task.key;
    if (image.outcome == Outcome::ok) {
      const std::string stem = image_stem(job, task.scene, task.view, image.source);
      image.exr = stem + ".exr";
      image.png = stem + ".png";
      if (image.is_reference) add_export(task, stem, image);
      if (!image.is_reference)
        for (const auto& buffer : variant_buffers(job, job.variants[std::size_t(task.variant)]))
          image.buffers[buffer] = buffer_stem(job, task.scene, task.view, image.source, buffer) + ".png";
      const LedgerEntry& entry = *outcomes_[i].entry;
      if (!is_external(task)) add_cost(entry, image);
      image.noise = entry.result.noise;
      image.mean_luminance = entry.result.mean_luminance;
      image.ray_rates = entry.result.ray_rates;
      image.cached = outcomes_[i].state == TaskState::cached;
      image.contended = entry.contended;
      image.warnings = entry.result.warnings;
    }
    report_.images.push_back(std::move(image));
  }

  /// Reading a picture of another engine says nothing of what it cost to make.
  bool is_external(const Task& task) const {
    return task.kind == TaskKind::snapshot && report_.variants[std::size_t(task.variant)].external;
  }

  static void add_cost(const LedgerEntry& entry, ReportImage& image) {
    image.seconds = entry.result.seconds;
    image.cpu_seconds = entry.result.cpu_seconds;
    image.passes = entry.result.passes;
  }

  ReportObject object_row(std::size_t i) const {
    const Task& task = plan_.tasks[i];
    ReportObject row;
    row.scene = plan_.job.scenes[std::size_t(task.scene)].name;
    const auto& objects = facts_.scenes[std::size_t(task.scene)].objects;
    row.object = std::ranges::find(objects, task.object, &ObjectFacts::entity)->name;
    for (const int variant : drawn_by_[i])
      row.variants.push_back(plan_.job.variants[std::size_t(variant)].name);
    row.outcome = outcome_of(i);
    row.error = outcomes_[i].reason;
    if (row.outcome == Outcome::ok) {
      const LedgerEntry& entry = *outcomes_[i].entry;
      row.seconds = entry.result.seconds;
      row.cpu_seconds = entry.result.cpu_seconds;
      row.cached = outcomes_[i].state == TaskState::cached;
      row.contended = entry.contended;
      row.noise = entry.result.noise;
      row.ray_rates = entry.result.ray_rates;
      row.numbers = entry.result.metrics;
    }
    return row;
  }

  void add_export(const Task& task, const std::string& stem, ReportImage& image) {
    const JobReference& reference = plan_.job.references[std::size_t(task.reference)];
    const ReferenceKind& kind = find_reference_kind(reference.kind, "");
    if (!kind.exports()) return;
    const std::string file = stem + kind.view_suffixes(reference_params(reference)).front();
    std::error_code error;
    if (std::filesystem::exists(plan_.out / file, error)) image.pov = file;
  }

  void add_score(std::size_t i) {
    const Task& task = plan_.tasks[i];
    const Job& job = plan_.job;
    ReportScore score;
    score.scene = job.scenes[std::size_t(task.scene)].name;
    score.view = views_of(job.scenes[std::size_t(task.scene)])[std::size_t(task.view)].name;
    score.variant = job.variants[std::size_t(task.variant)].name;
    score.reference = job.references[std::size_t(task.reference)].name;
    score.outcome = outcome_of(i);
    score.error = outcomes_[i].reason;
    if (score.outcome == Outcome::ok) {
      const TaskResult& result = outcomes_[i].entry->result;
      score.metrics = result.metrics;
      score.warnings = result.warnings;
      const std::string stem = score_stem(job, task.scene, task.view, score.variant, score.reference);
      for (const auto& output : task.outputs) {
        if (output.ends_with(".heat.png"))
          score.heat_png = output;
        else if (output == stem + ".diff.png")
          score.difference_png = output;
        else if (output.ends_with(".diff.png"))
          score.baseline_difference_png = output;
      }
    }
    report_.scores.push_back(std::move(score));
  }

  const Plan& plan_;
  const PlanFacts& facts_;
  const std::vector<TaskOutcome>& outcomes_;
  const std::vector<std::set<int>> drawn_by_;
  RunReport report_;
};

ExitCode exit_code_of_gates(const RunReport& report, const RunCounts& counts) {
  if (counts.gates_not_met > 0) return ExitCode::gate_failed;
  return counts.gates_not_judged > 0 && !report.partial ? ExitCode::not_judged : ExitCode::ok;
}

}  // namespace

RunReport gather_report(const Plan& plan, const PlanFacts& facts, const std::vector<TaskOutcome>& outcomes,
                        GateScope scope) {
  RunReport report = Gatherer(plan, facts, outcomes).gather();
  report.partial = scope == GateScope::what_is_there;
  report.gates = evaluate_gates(plan.job.gates, report);
  return report;
}

ExitCode exit_code_of(const RunReport& report, const std::vector<TaskOutcome>& outcomes,
                      const std::vector<bool>& selected) {
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    const bool wanted = selected.empty() || selected[i];
    if (wanted && (outcomes[i].state == TaskState::failed || outcomes[i].state == TaskState::skipped))
      return ExitCode::task_failed;
  }
  return exit_code_of_gates(report, count_outcomes(report));
}

ExitCode exit_code_of(const RunReport& report) {
  const RunCounts counts = count_outcomes(report);
  return counts.failed > 0 ? ExitCode::task_failed : exit_code_of_gates(report, counts);
}

}  // namespace lightbench
