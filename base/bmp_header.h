#pragma once

#include <filesystem>

namespace lightbench {

/// Whether a BMP file's pixels have an alpha: they do if they have 32 bits and a mask in the header tells
/// which of them are it. Otherwise the fourth byte is spare, and mostly 0. Throws Error with the path for
/// colours in an order that OpenImageIO takes for another one.
bool read_bmp_has_alpha(const std::filesystem::path& file);

}  // namespace lightbench
