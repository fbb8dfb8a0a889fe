#include "scene/obj_names.h"

#include "scene/obj_parser.h"
#include "scene/text_scan.h"

namespace lightbench {

void ObjNames::begin_object(std::string_view name) {
  object_ = name;
  group_.clear();
  begin_shape();
}

void ObjNames::begin_group(std::string_view names) {
  group_.clear();
  for (std::string_view word = take_word(names); !word.empty(); word = take_word(names)) {
    if (!group_.empty()) group_ += ' ';
    group_ += word;
  }
  begin_shape();
}

void ObjNames::begin_shape() {
  if (shapes_.names().size() > kMostMeshes) return;
  const bool both = !object_.empty() && !group_.empty() && object_ != group_;
  shape_ = shapes_.index_of(both ? object_ + "/" + group_ : group_.empty() ? object_ : group_);
}

void ObjNames::begin_smoothing(std::string_view group) {
  const std::string name = lower_case(group);
  const bool zero = classify_number(name) == NumberKind::finite && number_of(name) == 0;
  const bool off = name.empty() || name == "off" || name == "null" || zero;
  smoothing_ = off ? kSmoothingOff : kSmoothingOff + 1 + smoothing_groups_.index_of(name);
}

void ObjNames::use_material(std::string_view name, std::size_t line) {
  material_name_ = {std::string(name), line};
  material_ = -1;
}

std::int32_t ObjNames::shape() {
  if (shape_ < 0) shape_ = shapes_.index_of("");
  return shape_;
}

std::int32_t ObjNames::material() {
  if (material_ >= 0 || material_name_.text.empty()) return material_;
  material_ = materials_.index_of(material_name_.text);
  if (used_materials_.size() < materials_.names().size()) used_materials_.push_back(material_name_);
  return material_;
}

}  // namespace lightbench
