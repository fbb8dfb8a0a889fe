#include "pipeline/kept_files.h"

#include <algorithm>
#include <unordered_set>

#include "base/error.h"
#include "pipeline/concrete.h"
#include "renderer/technique.h"
#include "renderer/techniques/images.h"
#include "reports/formats/res.h"

namespace lightbench {
namespace fs = std::filesystem;
namespace {

/// What a run writes, relative to its folder.
struct Outputs {
  std::unordered_set<std::string> files;
  std::vector<fs::path> folders;  ///< of exports, whose shared files are known only when they were made
};

Outputs outputs_of(const Plan& plan) {
  Outputs outputs;
  for (const NamedFile& file : run_files("")) outputs.files.insert(file.path.string());
  for (const JobVariant& variant : plan.job.variants) outputs.files.insert(res_file(variant.name));
  for (const Task& task : plan.tasks) {
    outputs.files.insert(task.outputs.begin(), task.outputs.end());
    if (task.kind != TaskKind::export_) continue;
    outputs.folders.emplace_back(
        shared_export_folder(plan.job, task.scene, plan.job.references[std::size_t(task.reference)].kind));
  }
  std::ranges::sort(outputs.folders);
  outputs.folders.erase(std::unique(outputs.folders.begin(), outputs.folders.end()), outputs.folders.end());
  return outputs;
}

bool is_below(const fs::path& file, const fs::path& folder) {
  return std::mismatch(folder.begin(), folder.end(), file.begin(), file.end()).first == folder.end();
}

bool is_replaced(const fs::path& relative, const Outputs& outputs) {
  return outputs.files.contains(relative.string()) ||
         std::ranges::any_of(outputs.folders, [&](const fs::path& f) { return is_below(relative, f); });
}

/// Files are replaced by renaming, so that a second name of an input (a hard link) keeps what it had: only
/// inputs whose place is below the folder can be lost.
void check_inputs(const fs::path& out, const Outputs& outputs, const std::vector<NamedFile>& inputs) {
  const fs::path folder = fs::weakly_canonical(out);
  for (const NamedFile& input : inputs) {
    std::error_code error;
    const fs::path place = fs::weakly_canonical(fs::absolute(input.path), error);
    const fs::path named = fs::absolute(input.path).lexically_normal();  // a link, which would be replaced
    for (const auto& [base, file] : {std::pair(folder, place), std::pair(out, named)})
      if (is_below(file, base) && is_replaced(file.lexically_relative(base), outputs))
        throw Error(input.name + " would be overwritten by the run: choose another folder for it",
                    input.path.string());
  }
}

void check_places(const fs::path& out, const Outputs& outputs) {
  for (const std::string& file : outputs.files) {
    std::error_code error;
    const fs::file_type type = fs::symlink_status(out / file, error).type();
    if (error || type == fs::file_type::not_found || type == fs::file_type::regular ||
        type == fs::file_type::symlink)
      continue;
    throw Error("is in the place of a file that the run writes, and is not a file itself",
                (out / file).string());
  }
}

}  // namespace

std::vector<NamedFile> job_files(const Job& job) {
  std::vector<NamedFile> files{{"the job", job.file}};
  for (const JobScene& scene : job.scenes) {
    files.push_back({"scene '" + scene.name + "'", scene.file});
    if (const auto* script = std::get_if<CameraScript>(&scene.views))
      files.push_back({"the camera script of scene '" + scene.name + "'", script->file});
  }
  return files;
}

std::vector<NamedFile> read_files(const Job& job, const PlanFacts& facts) {
  std::vector<NamedFile> files = job_files(job);
  for (std::size_t i = 0; i < job.scenes.size(); ++i) {
    const JobScene& scene = job.scenes[i];
    for (const std::string& file : facts.scenes[i].paths)
      files.push_back({"a file of scene '" + scene.name + "'", file});
    for (const JobVariant& variant : job.variants) {
      if (!find_technique(variant.technique, "").external) continue;
      for (const View& view : views_of(scene))
        files.push_back({"a picture of variant '" + variant.name + "'",
                         picture_path(variant_params(variant).text("pattern"), scene.name, view.name)});
    }
  }
  return files;
}

std::vector<NamedFile> run_files(const fs::path& out) {
  std::vector<NamedFile> files;
  for (const char* name : {"run.json", "plan.json", "ledger.jsonl", "index.html", "junit.xml", "summary.md",
                           "cost.svg", "res.txt"})
    files.push_back({std::string("the run's ") + name, out / name});
  return files;
}

void check_outputs_of(const Plan& plan, const PlanFacts& facts) {
  const Outputs outputs = outputs_of(plan);
  check_inputs(plan.out, outputs, read_files(plan.job, facts));
  check_places(plan.out, outputs);
}

}  // namespace lightbench
