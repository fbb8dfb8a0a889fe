#pragma once

#include <string>

#include "base/error.h"
#include "pipeline/concrete.h"
#include "pipeline/job_file.h"
#include "pipeline/plan.h"

namespace lightbench::test {

/// A job of two scenes: two views and one, two variants, one reference.
inline const char* const kJobText = R"({
  "name": "job", "size": [8, 6],
  "scenes": [
    {"name": "one", "scene": "one.json",
     "views": [{"name": "a", "position": [0, 0, 1], "look_at": [0, 0, 0]},
               {"name": "b", "position": [0, 0, 2], "look_at": [0, 0, 0]}]},
    {"name": "two", "scene": "two.obj", "views": [{"name": "a", "position": [1, 0, 0], "look_at": [0, 0, 0]}]}
  ],
  "variants": [{"name": "direct", "technique": "direct"}, {"name": "other", "technique": "ambient"}],
  "references": [{"name": "truth", "kind": "povray"}],
  "metrics": ["mean_error", "gain"]
})";

/// What reading the job says, or "no error".
inline std::string error_of(const std::string& text) {
  try {
    parse_job(text, "/jobs/job.json");
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

inline Job concrete_job(const std::string& text = kJobText) {
  return make_concrete(parse_job(text, "/jobs/job.json"), "/out", nullptr);
}

/// What a look at the scenes of `job` could have told.
inline PlanFacts facts_for(const Job& job) {
  PlanFacts facts;
  facts.gl = "osmesa";
  facts.renderer = "a renderer";
  facts.tools["povray"] = "POV-Ray 3.7";
  for (const auto& scene : job.scenes) {
    SceneFacts scene_facts;
    scene_facts.triangles = 12;
    scene_facts.files = {{scene.file.filename().string(), "hash of " + scene.name}};
    for (const auto& reference : job.references) {
      auto& views = scene_facts.exports.emplace_back();
      for (const auto& view : views_of(scene))
        views.push_back({{"shared meshes.inc", "meshes of " + scene.name},
                         {"scene description", reference.name + " of " + view.name}});
    }
    facts.scenes.push_back(scene_facts);
  }
  return facts;
}

inline Plan plan_of(const Job& job) {
  return make_plan(job, facts_for(job), "/out");
}

inline const Task& task_called(const Plan& plan, const std::string& id) {
  for (const auto& task : plan.tasks)
    if (task.id == id) return task;
  throw std::out_of_range(id);
}

inline std::size_t index_of(const Plan& plan, const std::string& id) {
  return std::size_t(&task_called(plan, id) - plan.tasks.data());
}

inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const auto place = text.find(from);
  if (place == std::string::npos) throw std::out_of_range(from);
  return text.replace(place, from.size(), to);
}

}  // namespace lightbench::test
