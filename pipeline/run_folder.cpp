#include "pipeline/run_folder.h"

#include <set>

#include "base/error.h"
#include "base/files.h"
#include "base/orphans.h"
#include "pipeline/references.h"

namespace lightbench {
namespace fs = std::filesystem;
namespace {

/// Nobody else gives this name to a folder, so it may be removed with all that is in it.
constexpr const char* kScratch = ".lightbench-tmp";

void add_folders(const Plan& plan, const Task& task, std::set<fs::path>& folders) {
  for (const auto& output : task.outputs) folders.insert(fs::path(output).parent_path());
  if (task.kind == TaskKind::export_)
    folders.insert(
        shared_export_folder(plan.job, task.scene, plan.job.references[std::size_t(task.reference)].kind));
}

}  // namespace

void check_inside(const fs::path& out, const fs::path& relative) {
  fs::path folder = out;
  for (const auto& part : relative) {
    folder /= part;
    std::error_code error;
    const fs::file_type type = fs::symlink_status(folder, error).type();
    if (type == fs::file_type::not_found) return;
    if (type == fs::file_type::symlink)
      throw Error(
          "is a link, which would lead files of the run out of its folder: remove the link, or choose "
          "another folder",
          folder.string());
    if (type != fs::file_type::directory) throw Error("is in the place of a folder", folder.string());
  }
}

void check_output_folders(const Plan& plan, const Task& task) {
  std::set<fs::path> folders;
  add_folders(plan, task, folders);
  for (const fs::path& folder : folders) check_inside(plan.out, folder);
}

Workspace::Workspace(const Plan& plan) : out_(plan.out), scratch_(plan.out / kScratch) {
  std::set<fs::path> folders;
  for (const Task& task : plan.tasks) add_folders(plan, task, folders);
  for (const fs::path& folder : folders) check_inside(out_, folder);
  clean();
  std::error_code error;
  fs::create_directory(scratch_, error);
  if (error) throw Error("cannot make a folder for temporary files: " + error.message(), scratch_.string());
}

Workspace::~Workspace() {
  clean();
}

void Workspace::clean() const {
  std::error_code ignored;
  fs::remove_all(scratch_, ignored);  // of a link the link alone
  remove_orphans_in(out_);
  for (const char* folder : {"views", "baked", "cameras"}) remove_orphans(out_ / folder);
  for (const auto& kind : reference_kinds()) remove_orphans(out_ / escape_file_name(kind.name));
}

}  // namespace lightbench
