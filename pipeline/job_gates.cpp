#include "pipeline/job_gates.h"

#include <algorithm>
#include <optional>
#include <set>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/text.h"
#include "pipeline/concrete.h"
#include "pipeline/job_problems.h"
#include "pipeline/tables.h"
#include "reports/metric.h"
#include "scene/scene_json.h"

namespace lightbench {
namespace {

/// The names of one kind that gates may give, exactly or by a pattern.
class Names {
 public:
  Names(const char* what, std::vector<std::string> names, bool whole)
      : what_(what), listed_(std::move(names)), exact_(listed_.begin(), listed_.end()), whole_(whole) {}

  /// A name that stands for several.
  void add_alias(const std::string& name) { exact_.insert(name); }

  bool is_missing(const std::string& name) const { return whole_ && !exact_.contains(name); }

  std::string name(const JsonValue& value) const { return whole_ ? value.choice(listed_) : value.text(); }

  std::string pattern(const JsonValue& value) const {
    std::string pattern = value.text();
    const auto matches = [&](const std::string& name) { return matches_glob(name, pattern); };
    if (is_missing(pattern) && std::ranges::none_of(listed_, matches))
      value.fail(fmt::format("no {} is called '{}'{}", what_, pattern,
                             did_you_mean(pattern, {exact_.begin(), exact_.end()})));
    return pattern;
  }

 private:
  const char* what_;
  std::vector<std::string> listed_;
  std::set<std::string> exact_;
  bool whole_;
};

struct GateNames {
  Names metrics, variants, references, scenes;

  GateNames(const Job& job, const WholeLists& whole)
      : metrics("metric", job.metrics, whole.metrics),
        variants("variant", row_names(expand_sweeps(job.variants)), whole.variants),
        references("reference", row_names(job.references), whole.references),
        scenes("scene", row_names(job.scenes), whole.scenes) {
    for (const auto& variant : job.variants) variants.add_alias(variant.name);
  }
};

/// A metric that the job computes.
std::string read_metric(const JsonValue& value, const Names& computed) {
  const std::string name = value.text();
  find_metric(name, value.where());  // or an error that names the nearest one
  if (computed.is_missing(name))
    value.fail("the job does not compute '" + name + "': name it in the job's 'metrics'");
  return computed.name(value);
}

Gate read_gate(const JsonValue& value, const GateNames& names, ProblemList& problems) {
  KeyReader keys(value, problems);
  Gate gate;
  gate.as_written = value.raw().dump();
  gate.where = value.where();
  keys.required("metric", [&](const JsonValue& v) { gate.metric = read_metric(v, names.metrics); });
  keys.required("variant", [&](const JsonValue& v) { gate.variant = names.variants.pattern(v); });
  keys.optional("reference", [&](const JsonValue& v) { gate.reference = names.references.name(v); });
  keys.optional("scene", [&](const JsonValue& v) { gate.scene = names.scenes.pattern(v); });
  keys.optional("view", [&](const JsonValue& v) { gate.view = v.text(); });
  keys.optional("min", [&](const JsonValue& v) { gate.min = v.number(); });
  keys.optional("max", [&](const JsonValue& v) { gate.max = v.number(); });
  keys.optional("over", [&](const JsonValue& v) { gate.over = parse_gate_over(v); });
  if (!keys.has("min") && !keys.has("max")) keys.fail("a gate needs 'min' or 'max'");
  if (gate.min && gate.max && *gate.min > *gate.max) keys.fail("'min' is above 'max'");
  keys.finish();
  return gate;
}

/// The views of all scenes that the gate is about; nothing where those of one are not known yet.
std::optional<std::vector<std::string>> known_views(const Gate& gate, const std::vector<JobScene>& scenes) {
  std::vector<std::string> names;
  const bool is_named = std::ranges::count(scenes, gate.scene, &JobScene::name) > 0;
  for (const JobScene& scene : scenes) {
    if (!gate.scene.empty() && (is_named ? scene.name != gate.scene : !matches_name(scene.name, gate.scene)))
      continue;
    if (scene.sequence || !std::holds_alternative<std::vector<View>>(scene.views)) return std::nullopt;
    for (const View& view : views_of(scene)) names.push_back(view.name);
  }
  return names;
}

}  // namespace

void read_gates(const JsonValue& list, const WholeLists& whole, ProblemList& problems, Job& job) {
  const std::vector<JsonValue> items = list.items();
  if (items.empty()) return;
  if (job.references.empty() && whole.references) items.front().fail("a gate needs a reference in the job");
  if (items.size() > kMaxGates) list.fail(fmt::format("a job has at most {} gates", kMaxGates));
  const GateNames names(job, whole);
  for (const auto& item : items) {
    if (problems.errors() >= kMostProblems) return;
    collect(problems, [&] { job.gates.push_back(read_gate(item, names, problems)); });
  }
}

void check_gate_views(const std::vector<Gate>& gates, const std::vector<JobScene>& scenes,
                      ProblemList& problems) {
  for (const Gate& gate : gates) {
    if (gate.view.empty()) continue;
    const auto views = known_views(gate, scenes);
    const auto matches = [&](const std::string& name) { return matches_name(name, gate.view); };
    if (!views || std::ranges::any_of(*views, matches)) continue;
    problems.error(
        fmt::format("no view {}is called '{}'{}", gate.scene.empty() ? "" : "of scene '" + gate.scene + "' ",
                    gate.view, did_you_mean(gate.view, *views)),
        gate.where + ".view");
  }
}

}  // namespace lightbench
