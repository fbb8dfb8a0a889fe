#include "pipeline/commands/busy.h"

#include <cstdlib>
#include <thread>

#include <fmt/format.h>

#include "pipeline/console.h"

namespace lightbench {

void warn_if_busy() {
  double load = 0;
  if (getloadavg(&load, 1) == 1 && load > 0.5 * std::thread::hardware_concurrency())
    warn(fmt::format("the machine is busy (load {:.1f}), so these times are too long", load));
}

}  // namespace lightbench
