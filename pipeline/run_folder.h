#pragma once

#include <filesystem>

#include "pipeline/plan.h"

/// A run writes only below its folder. The folder itself may be a link, as its user chose it; nothing below
/// it that a run makes may be one, since that would lead its files elsewhere.
namespace lightbench {

/// Throws Error where a folder on the way from `out` down to `out / relative` is a link or not a folder.
/// Folders that are not there yet are fine.
void check_inside(const std::filesystem::path& out, const std::filesystem::path& relative);
/// Checks all folders that the task writes to in this way.
void check_output_folders(const Plan& plan, const Task& task);

/// The run's folder while work goes on; only for who holds the lock of its ledger. At the start and at the
/// end it removes what killed workers left: their temporary files, and files that were not in place yet.
class Workspace {
 public:
  /// Throws Error where a task would write elsewhere, or the folder for temporary files cannot be made.
  explicit Workspace(const Plan& plan);
  Workspace(const Workspace&) = delete;
  Workspace& operator=(const Workspace&) = delete;
  ~Workspace();

  /// Where workers keep their temporary files.
  const std::filesystem::path& scratch() const { return scratch_; }

 private:
  void clean() const;

  std::filesystem::path out_;
  std::filesystem::path scratch_;
};

}  // namespace lightbench
