#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "scene/name_table.h"
#include "scene/obj_text.h"

namespace lightbench {

/// What the statements `o`, `g`, `s` and `usemtl` before a face say of it.
class ObjNames {
 public:
  void begin_object(std::string_view name);
  /// A face may be in several groups: the words are one name.
  void begin_group(std::string_view names);
  /// "off", 0 and nothing switch smoothing off.
  void begin_smoothing(std::string_view group);
  /// A name of nothing means no material.
  void use_material(std::string_view name, std::size_t line);

  /// Return what a face that stands here has, as ObjFace holds it. Objects and groups beyond kMostMeshes are
  /// one.
  std::int32_t shape();
  std::int32_t material();
  std::int32_t smoothing() const { return smoothing_; }
  std::size_t smoothing_groups() const { return smoothing_groups_.names().size(); }

  std::vector<std::string> shapes() const { return {shapes_.names().begin(), shapes_.names().end()}; }
  /// Returns the materials that faces have, each with the line of its statement.
  const std::vector<TextLine>& materials() const { return used_materials_; }

 private:
  void begin_shape();

  NameTable shapes_;
  NameTable materials_;
  NameTable smoothing_groups_;
  std::vector<TextLine> used_materials_;
  std::string object_;
  std::string group_;
  TextLine material_name_;
  std::int32_t shape_ = -1;
  std::int32_t material_ = -1;  // -1 too while no face has it
  std::int32_t smoothing_ = -1;
};

}  // namespace lightbench
