#pragma once

#include <filesystem>

namespace lightbench {

/// Whether the attributes in the headers of an OpenEXR file end within the file. The library takes memory for
/// an attribute of any size before it reads it, so that a few bytes could ask for gigabytes. Throws Error
/// where the file cannot be read.
bool exr_attributes_fit(const std::filesystem::path& file);

}  // namespace lightbench
