#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace lightbench {

/// A format of image files that lightbench reads: one row of the table in image_kinds.cpp.
struct ImageKind {
  const char* name;
  const char* reader;  ///< what OpenImageIO calls the one reader that may open it
  /// No sound file of this format packs more pixels into a byte: a size that asks for more is made up.
  std::uint64_t most_pixels_per_byte;
};

/// "PNG, JPEG, OpenEXR, ...", for help texts and errors.
std::string image_kind_names();

/// The kind by the file's first bytes, whatever its name; TGA, which has no mark there, by the extension .tga
/// and a header that makes sense. Throws Error with the path for a file that is not there, that is not a
/// regular file, or that is of another format; the error says which one it seems to be.
const ImageKind& image_kind(const std::filesystem::path& file);

}  // namespace lightbench
