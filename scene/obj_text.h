#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

#include "scene/problem_list.h"

namespace lightbench {

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
ObjText check_obj_text(std::string text, const std::filesystem::path& file, ProblemList& problems);

/// The line (from 1) of the nth (from 0) statement `keyword` of a checked text, or 0.
std::size_t line_of_statement(std::string_view text, std::string_view keyword, std::size_t n);

/// "file:line".
std::string at_line(const std::filesystem::path& file, std::size_t line);

}  // namespace lightbench
