#pragma once

#include <optional>
#include <string_view>

namespace lightbench {

/// The kinds of statements of OBJ files.
enum class ObjStatement {
  vertex,
  normal,
  uv,
  face,
  object,
  group,
  smoothing,
  material,
  library,
  line_or_point,
  free_form,
  ignored,  ///< changes nothing about polygons
};

/// What a keyword means; nothing where no OBJ file has it. Nearly all files write keywords in lower case, and
/// any case is read.
std::optional<ObjStatement> find_obj_statement(std::string_view keyword);

}  // namespace lightbench
