#include "pipeline/commands/busy.h"

#include <cstdio>
#include <cstdlib>
#include <thread>

namespace lightbench {

void warn_if_busy() {
  double load = 0;
  if (getloadavg(&load, 1) == 1 && load > 0.5 * std::thread::hardware_concurrency())
    std::fprintf(stderr, "warning: the machine is busy (load %.1f), so these times are too long\n", load);
}

}  // namespace lightbench
