#pragma once

#include <map>
#include <string>

namespace lightbench {

/// "0.1.0"
std::string lightbench_version();

/// Versions of what decides images and numbers: lightbench itself, the compiler, OpenImageIO.
std::map<std::string, std::string> tool_versions();

}  // namespace lightbench
