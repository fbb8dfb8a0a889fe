#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "scene/obj_corner.h"
#include "scene/obj_parser.h"
#include "scene/problem_list.h"

namespace lightbench {

/// Turns the indices of faces into those of ObjData. A face without one of its positions is an error and is
/// left out; a corner whose texture coordinate or normal is not there has none, with a warning.
class ObjIndices {
 public:
  ObjIndices(ObjData& data, const std::filesystem::path& file, ProblemList& problems);

  /// Resolves a corner of a face that stands in `line`; nothing where it has no position. A positive index
  /// may point at what the file defines later: `finish` checks that.
  std::optional<ObjCorner> resolve(const WrittenCorner& written, std::size_t line);
  /// The last of ObjData::faces stands in `line`.
  void add_face(std::size_t line) { face_lines_.push_back(std::uint32_t(line)); }
  void finish();

 private:
  struct Missing {
    std::size_t count = 0;
    std::size_t first_line = 0;

    void add(std::size_t line);
  };

  void report(const WrittenCorner& corner, std::size_t line);
  void warn_of(const Missing& missing, const char* what, const char* instead);
  bool check(const ObjFace& face, std::size_t line);

  ObjData& data_;
  const std::filesystem::path& file_;
  ProblemList& problems_;
  RepeatedProblem out_of_range_;
  std::vector<std::uint32_t> face_lines_;  // of data_.faces
  Missing uvs_;
  Missing normals_;
};

}  // namespace lightbench
