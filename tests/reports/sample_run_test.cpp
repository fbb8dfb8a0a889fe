#include "tests/reports/sample_run.h"

namespace lightbench::test {
namespace {

ReportImage image(const std::string& scene, const std::string& view, const std::string& source,
                  const std::string& folder, double seconds) {
  ReportImage result;
  result.scene = scene;
  result.view = view;
  result.source = source;
  result.png = folder + source + ".png";
  result.exr = folder + source + ".exr";
  result.seconds = seconds;
  return result;
}

ReportScore score(const std::string& scene, const std::string& view, const std::string& variant,
                  const std::string& folder, const std::vector<double>& values) {
  ReportScore result;
  result.scene = scene;
  result.view = view;
  result.variant = variant;
  result.reference = "povray";
  const char* names[] = {"mean_error", "pearson", "gain"};
  for (std::size_t i = 0; i < values.size(); ++i) result.metrics[names[i]] = MetricValue::of(values[i]);
  result.difference_png = folder + variant + "~povray.diff.png";
  result.heat_png = folder + variant + "~povray.heat.png";
  return result;
}

void add_view(RunReport& run, const std::string& scene, const std::string& view, const std::string& folder) {
  ReportImage reference = image(scene, view, "povray", folder, 41.5);
  reference.is_reference = true;
  reference.pov = folder + "povray.pov";
  reference.key = "0123456789abcdef";
  reference.cpu_seconds = 41;
  reference.noise = 0.25;
  reference.mean_luminance = 0.45;
  run.images.push_back(reference);
  ReportImage converged = image(scene, view, "converged", folder, 90);
  converged.is_reference = true;
  converged.mean_luminance = 0.5;
  converged.ray_rates = {{"primary", 8e6}, {"shadow", 1.25e7}};
  run.images.push_back(converged);
  run.images.push_back(image(scene, view, "direct", folder, 0.25));
  run.images.push_back(image(scene, view, "isr-48", folder, 0.5));
  run.images.back().passes = {{"g-buffer", 0.125}, {"gather", 0.375}};
}

ReportObject object(const std::string& name, const std::vector<std::string>& variants, double cpu_seconds,
                    const std::map<std::string, double>& numbers) {
  ReportObject result;
  result.scene = "office";
  result.object = name;
  result.variants = variants;
  result.seconds = cpu_seconds + 0.5;
  result.cpu_seconds = cpu_seconds;
  for (const auto& [key, value] : numbers) result.numbers[key] = MetricValue::of(value);
  return result;
}

void add_objects(RunReport& run) {
  const std::vector<std::string> baked{"raw", "packed"}, packed{"packed"};
  run.bakes = {
      object("floor", baked, 4, {{"width", 130}, {"height", 100}, {"texels", 12000}, {"directions", 400}}),
      object(kHostileObject, baked, 1,
             {{"width", 64}, {"height", 128}, {"texels", 4000}, {"directions", 400}})};
  run.bakes[0].noise = 0.5;
  run.bakes[1].noise = 0.1;
  run.bakes[0].ray_rates = {{"shadow", 2e7}};
  run.bakes[1].cached = true;
  run.compressions = {object("floor", packed, 2,
                             {{"width", 130},
                              {"height", 100},
                              {"texels", 12500},
                              {"directions", 400},
                              {"raw_bytes", 1.5e7},
                              {"bytes.mti", 5e4},
                              {"bytes.mtnc", 2e5},
                              {"ratio", 60},
                              {"changed_values", 1e6},
                              {"changed", 0.2},
                              {"mean_changed_error", 1.25},
                              {"error_99", 4},
                              {"max_error", 5.5},
                              {"max_component_error", 9},
                              {"colors", 2345}}),
                      object(kHostileObject, packed, 0, {})};
  run.compressions[1].outcome = Outcome::failed;
  run.compressions[1].error = kHostileError;
}

void describe_job(RunReport& run) {
  run.job = "rooms & more";
  run.job_file = "jobs/rooms.json";
  run.started = "2026-01-02T03:04:05Z";
  run.seconds = 200;
  run.width = 320;
  run.height = 240;
  run.baseline = "direct";
  run.primary_reference = "povray";
  run.metric_names = {"mean_error", "pearson", "gain"};
  run.tools = {{"POV-Ray", "3.7.0.10"}, {"lightbench", "0.1.0"}};
  run.variants = {{"direct", "direct", {{"shadows", "esm"}}, 0, false, "llvmpipe"},
                  {"isr-48", "isr", {{"samples", "48"}}, 1, false, "llvmpipe"},
                  {"path", "path_tracer", {{"bounces", "2"}}, 2, true, ""}};
  run.references = {{"povray", "povray", {{"count", "250"}}, 2, false, "POV-Ray 3.7.0.10"},
                    {"converged", "path_tracer", {{"bounces", "16"}}, 16, false, "path tracer 1"}};
  run.scenes = {{"office", "office.json", 297123, "00ff", {}, {{"chair", "someone", "CC-BY 3.0"}}},
                {kHostileScene, "x.obj", 12, "", {"map_Bump is not used"}, {}}};
}

}  // namespace

RunReport sample_run() {
  RunReport run;
  describe_job(run);
  add_view(run, "office", "desk", "views/office/desk/");
  add_view(run, kHostileScene, kHostileView, "views/%3C/a b#?/");
  run.scores = {score("office", "desk", "direct", "views/office/desk/", {8, 0.9, 0}),
                score("office", "desk", "isr-48", "views/office/desk/", {6, 0.95, 25}),
                score(kHostileScene, kHostileView, "direct", "views/%3C/a b#?/", {4, 0.5, 0}),
                score(kHostileScene, kHostileView, "isr-48", "", {})};
  run.scores[2].metrics["pearson"] = MetricValue::undefined("the reference is constant");
  run.scores[3].outcome = Outcome::failed;
  run.scores[3].error = kHostileError;
  run.scores[3].difference_png = run.scores[3].heat_png = "";
  run.scores.push_back(score("office", "desk", "path", "views/office/desk/", {0.4, 0.999, 95}));
  add_objects(run);
  run.images.back().outcome = Outcome::failed;
  run.images.back().error = kHostileError;
  run.images.back().png = run.images.back().exr = "";
  run.images[2].cached = true;
  run.scores[1].warnings = {"1 bounce compared with a reference of 2"};
  run.gates = {{"{\"metric\":\"gain\",\"variant\":\"isr-48\",\"min\":0}", GateState::not_met, kHostileError},
               {"mean mean_error of direct <= 10", GateState::met, "6 mean of 2 views"},
               {"mean mean_error of direct <= 6.1", GateState::within_noise, "6 mean of 2 views; by 0.1"}};
  run.gates[0].name = "gain of isr-48, each view, min";
  run.gates[0].views = {{kHostileScene, kHostileView, "", GateState::not_met, kHostileError},
                        {"office", "desk", "", GateState::met, "25"}};
  run.gates[2].name = "mean_error of direct, mean, max";
  return run;
}

}  // namespace lightbench::test
