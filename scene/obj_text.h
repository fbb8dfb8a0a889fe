#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>

#include "base/input_file.h"
#include "scene/problem_list.h"

namespace lightbench {

/// How much an OBJ file may hold. A triangle takes some 200 bytes while its mesh is made, however short its
/// line is, so that the size of the file alone says too little.
struct ObjLimits {
  std::uint64_t file_bytes = kLargestModelFile;
  std::size_t line_bytes = 4'000'000;
  std::size_t polygon_corners = 100'000;
  std::size_t vertices = 50'000'000;   ///< of `v`, of `vt` and of `vn`
  std::size_t corners = 150'000'000;   ///< of all faces
  std::size_t triangles = 50'000'000;  ///< that all faces are cut into
  std::size_t names = 2'000'000;       ///< statements `o`, `g`, `usemtl` and `mtllib`
  std::size_t libraries = 50'000;      ///< statements `mtllib`: each word of one may be a file to look for
  /// What follows such a keyword. A mesh is named after its object and its group, so that one long name of an
  /// object would be copied for each of its groups.
  std::size_t name_bytes = 4'000;
};

/// A statement's argument and the line it stands in (from 1).
struct TextLine {
  std::string text;
  std::size_t line = 0;
};

/// The text of an OBJ file without a byte order mark and with its continued lines joined: empty lines follow
/// a joined one, so that lines keep their numbers. A file that is no text is a problem, and empty.
std::string readable_obj_text(std::string text, const std::filesystem::path& file, ProblemList& problems);

/// "file:line".
std::string at_line(const std::filesystem::path& file, std::size_t line);

}  // namespace lightbench
