#include "pipeline/version.h"

namespace lightbench {

std::string lightbench_version() {
  return LIGHTBENCH_VERSION;
}

std::map<std::string, std::string> tool_versions() {
  return {{"lightbench", lightbench_version()}, {"compiler", "g++ " __VERSION__}};
}

}  // namespace lightbench
