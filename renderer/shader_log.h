#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace lightbench {

/// What a driver says of a shader, with names of files in place of their numbers: "2:17" (Mesa) or "2(17)"
/// (NVIDIA) at the start of a line becomes "name:17".
std::string with_file_names(std::string_view log, const std::vector<std::string>& files);

}  // namespace lightbench
