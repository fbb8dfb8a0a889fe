#pragma once

namespace lightbench {

/// What every command ends with.
enum class ExitCode {
  ok = 0,           ///< done, and all gates met
  gate_failed = 1,  ///< a gate of the job was not met
  task_failed = 2,  ///< at least one task failed; the rest is finished
  bad_input = 3,    ///< bad usage, a bad file, a missing tool, an unwritable place
  bug = 4,          ///< an error that should not be possible
  not_judged = 5,   ///< a gate could not be judged, or only on a part of what it is about
};

}  // namespace lightbench
