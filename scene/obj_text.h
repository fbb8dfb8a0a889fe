#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

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
  /// What follows such a keyword. A mesh is named after its object and its group, so that one long name of an
  /// object would be copied for each of its groups.
  std::size_t name_bytes = 4'000;
};

/// A statement's argument and the line it stands in (from 1).
struct TextLine {
  std::string text;
  std::size_t line = 0;
};

/// The text of an OBJ file, checked and made safe for a parser that believes what it reads. Continued lines
/// are joined, statements that cannot be read are commented out (and are problems), lines keep their numbers.
struct ObjText {
  std::string text;
  std::vector<TextLine> material_libraries;
  std::vector<std::size_t> material_lines;  ///< of each `usemtl`
  std::vector<glm::vec3> colors;            ///< of each `v`, or empty where no vertex has one
};

/// Checks what the parser would swallow without a word: words that are not numbers, NaN and infinity,
/// statements that are too short, malformed corners of faces, a file that ends in the middle of a line.
/// Throws Error where the text has more than `limits` allows.
ObjText check_obj_text(std::string text, const std::filesystem::path& file, ProblemList& problems,
                       const ObjLimits& limits = {});

/// The line (from 1) of the nth (from 0) statement `keyword` of a checked text, or 0.
std::size_t line_of_statement(std::string_view text, std::string_view keyword, std::size_t n);

/// "file:line".
std::string at_line(const std::filesystem::path& file, std::size_t line);

}  // namespace lightbench
