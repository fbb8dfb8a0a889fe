#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

namespace lightbench {

/// The sizes of a part's windows in pixels; 0 where the header has none.
struct ExrPart {
  std::int64_t data_width = 0;  ///< of the pixels that are stored
  std::int64_t data_height = 0;
  std::int64_t display_width = 0;  ///< of the picture
  std::int64_t display_height = 0;
};

/// The parts by the headers of an OpenEXR file, or nothing where the attributes do not end within the file.
/// The library takes memory for an attribute of any size and for a line of any width before it reads them,
/// so that a few bytes could ask for gigabytes. Throws Error where the file cannot be read.
std::optional<std::vector<ExrPart>> read_exr_parts(const std::filesystem::path& file);

}  // namespace lightbench
