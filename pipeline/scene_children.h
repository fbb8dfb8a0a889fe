#pragma once

#include <filesystem>
#include <vector>

#include "base/error.h"
#include "pipeline/plan.h"

namespace lightbench {

/// A signal asked for the end.
class Interrupted : public Error {
 public:
  Interrupted() : Error("interrupted: the same command goes on from here") {}
};

/// Reads scenes in child processes of this program. A scene whose reading crashes or hangs is then the error
/// of that scene alone, and so is one for which a child runs out of memory.
class SceneChildren {
 public:
  /// At most `places` children run at a time.
  SceneChildren(std::filesystem::path program, int places) : program_(std::move(program)), places_(places) {}

  /// Returns the facts of all scenes of a concrete job, in their order; those of a child that died have its
  /// end as their error. Throws Interrupted when INT, TERM or HUP has ended the children.
  std::vector<SceneFacts> inspect(const Job& job) const;

  /// Draws random views of a scene of the job. Throws Error where that is not possible, and Interrupted.
  std::vector<View> draw_views(const Job& job, const JobScene& scene,
                               const RandomViewsRequest& request) const;

 private:
  std::filesystem::path program_;
  int places_;
};

}  // namespace lightbench
