#pragma once

namespace lightbench {

/// Says on stderr that times will be too long where other programs run.
void warn_if_busy();

}  // namespace lightbench
