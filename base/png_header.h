#pragma once

#include <filesystem>
#include <optional>

namespace lightbench {

/// What a PNG file's components, 0..1, are raised to for linear light, or nothing where they are sRGB. That
/// is what a chunk gAMA says, unless there is one of sRGB or iCCP, which stand above it; profiles are taken
/// as sRGB. A gAMA of 1/2.2 beside sRGB's primaries in cHRM is what the PNG specification gives as the
/// stand-in of an sRGB chunk, and ImageMagick writes that: it counts as sRGB. Other primaries are not looked
/// at. Throws Error with the path for a file that is cut: the library would write to the terminal, too.
std::optional<float> read_png_exponent(const std::filesystem::path& file);

}  // namespace lightbench
