#include "scene/obj_parser.h"

#include <cmath>
#include <deque>
#include <istream>
#include <streambuf>
#include <string_view>
#include <unordered_map>
#include <utility>

#include <fmt/format.h>
#include <tiny_obj_loader.h>

#include "base/files.h"
#include "scene/text_scan.h"

namespace lightbench {
namespace {

// A stream over text that stays where it is.
class ViewBuffer : public std::streambuf {
 public:
  explicit ViewBuffer(std::string& text) { setg(text.data(), text.data(), text.data() + text.size()); }
};

// A table of names in the order of their first use.
class NameTable {
 public:
  std::int32_t index_of(std::string_view name) {
    if (const auto found = indices_.find(name); found != indices_.end()) return found->second;
    const auto index = std::int32_t(names_.size());
    indices_.emplace(names_.emplace_back(name), index);
    return index;
  }
  const std::deque<std::string>& names() const { return names_; }

 private:
  std::deque<std::string> names_;  // which stay where they are
  std::unordered_map<std::string_view, std::int32_t> indices_;
};

// Receives the parser's calls.
class ObjReceiver {
 public:
  ObjReceiver(const std::string& text, const std::filesystem::path& file, ProblemList& problems)
      : text_(text),
        file_(file),
        out_of_range_(problems, Problem::Severity::error, "faces with an index out of range", file.string()) {
  }

  void read(std::istream& stream) {
    tinyobj::callback_t callbacks;
    callbacks.vertex_cb = [](void* self, float x, float y, float z, float) { as(self).vertex({x, y, z}); };
    callbacks.normal_cb = [](void* self, float x, float y, float z) { as(self).normal({x, y, z}); };
    callbacks.texcoord_cb = [](void* self, float x, float y, float) { as(self).uv({x, y}); };
    callbacks.index_cb = [](void* self, tinyobj::index_t* indices, int count) {
      as(self).face(indices, std::size_t(count));
    };
    callbacks.usemtl_cb = [](void* self, const char* name, int) { as(self).use_material(name); };
    callbacks.group_cb = [](void* self, const char** names, int count) {
      as(self).group(names, std::size_t(count));
    };
    callbacks.object_cb = [](void* self, const char* name) { as(self).object(name); };
    tinyobj::LoadObjWithCallback(stream, callbacks, this);
  }

  ObjData take(const std::vector<std::size_t>& material_lines) {
    drop_forward_references();
    data_.shapes.assign(shapes_.names().begin(), shapes_.names().end());
    for (std::size_t i = 0; i < materials_.names().size(); ++i)
      data_.materials.push_back({materials_.names()[i], material_lines[first_use_[i]]});
    return std::move(data_);
  }

 private:
  static ObjReceiver& as(void* self) { return *static_cast<ObjReceiver*>(self); }
  // The parser makes NaN of words like 0e999.
  static float finite(float x) { return std::isfinite(x) ? x : 0.0f; }

  void vertex(const glm::vec3& p) { data_.positions.emplace_back(finite(p.x), finite(p.y), finite(p.z)); }
  void normal(const glm::vec3& n) { data_.normals.emplace_back(finite(n.x), finite(n.y), finite(n.z)); }
  void uv(const glm::vec2& t) { data_.uvs.emplace_back(finite(t.x), finite(t.y)); }

  // From 1, or negative from the end, to from 0; 0 is none. False where it points before the first one.
  static bool resolve(int index, std::size_t count, std::int32_t& result) {
    result = index > 0 ? index - 1 : index == 0 ? -1 : std::int32_t(count) + index;
    return index >= 0 || result >= 0;
  }

  void face(const tinyobj::index_t* indices, std::size_t count) {
    const std::size_t number = face_count_++;
    const std::size_t first = data_.corners.size();
    for (std::size_t i = 0; i < count; ++i) {
      ObjCorner corner;
      const bool fine = resolve(indices[i].vertex_index, data_.positions.size(), corner.position) &&
                        resolve(indices[i].texcoord_index, data_.uvs.size(), corner.uv) &&
                        resolve(indices[i].normal_index, data_.normals.size(), corner.normal) &&
                        corner.position >= 0;
      if (!fine) {
        data_.corners.resize(first);
        return report(number, indices[i]);
      }
      data_.corners.push_back(corner);
    }
    if (shape_ < 0) shape_ = shapes_.index_of("");
    face_numbers_.push_back(std::uint32_t(number));
    data_.faces.push_back({std::uint32_t(first), std::uint32_t(count), material_, shape_});
  }

  void report(std::size_t face_number, const tinyobj::index_t& index) {
    const auto text = [](int i) { return i == 0 ? std::string() : fmt::format("{}", i); };
    std::string where = file_.string();
    if (out_of_range_.lists_next()) where = at_line(file_, line_of_statement(text_, "f", face_number));
    out_of_range_.add(
        fmt::format("index out of range: {}/{}/{} of {} vertices, {} texture coordinates and {} normals",
                    index.vertex_index, text(index.texcoord_index), text(index.normal_index),
                    data_.positions.size(), data_.uvs.size(), data_.normals.size()),
        std::move(where));
  }

  // A positive index may point at what the file defines later, so these are checked at the end.
  void drop_forward_references() {
    std::vector<ObjFace> kept;
    kept.reserve(data_.faces.size());
    for (std::size_t i = 0; i < data_.faces.size(); ++i)
      if (in_range(data_.faces[i], face_numbers_[i])) kept.push_back(data_.faces[i]);
    data_.faces = std::move(kept);
  }

  bool in_range(const ObjFace& face, std::size_t number) {
    for (std::size_t i = face.first_corner; i < face.first_corner + face.corner_count; ++i) {
      const ObjCorner& c = data_.corners[i];
      if (c.position < std::int32_t(data_.positions.size()) && c.uv < std::int32_t(data_.uvs.size()) &&
          c.normal < std::int32_t(data_.normals.size()))
        continue;
      tinyobj::index_t index;
      index.vertex_index = c.position + 1;
      index.texcoord_index = c.uv + 1;
      index.normal_index = c.normal + 1;
      report(number, index);
      return false;
    }
    return true;
  }

  void use_material(std::string_view name) {
    const std::size_t statement = usemtl_count_++;
    material_ = materials_.index_of(stripped(name));
    if (first_use_.size() < materials_.names().size()) first_use_.push_back(statement);
  }

  void group(const char** names, std::size_t count) {
    group_.clear();
    for (std::size_t i = 0; i < count; ++i) group_ += (i > 0 ? " " : "") + std::string(names[i]);
    begin_shape();
  }
  void object(std::string_view name) {
    object_ = stripped(name);
    group_.clear();
    begin_shape();
  }
  void begin_shape() {
    if (shapes_.names().size() > kMostMeshes) return;
    const bool both = !object_.empty() && !group_.empty() && object_ != group_;
    shape_ = shapes_.index_of(both ? object_ + "/" + group_ : group_.empty() ? object_ : group_);
  }

  const std::string& text_;
  const std::filesystem::path& file_;
  RepeatedProblem out_of_range_;
  ObjData data_;
  std::vector<std::uint32_t> face_numbers_;  // of data_.faces among all statements `f`
  std::size_t face_count_ = 0;
  std::size_t usemtl_count_ = 0;
  NameTable materials_;
  std::vector<std::size_t> first_use_;
  NameTable shapes_;
  std::string object_;
  std::string group_;
  std::int32_t material_ = -1;
  std::int32_t shape_ = -1;
};

}  // namespace

ObjData parse_obj(const std::filesystem::path& file, ProblemList& problems, const ObjLimits& limits) {
  ObjText checked = check_obj_text(read_file(file, limits.file_bytes), file, problems, limits);
  ObjReceiver receiver(checked.text, file, problems);
  ViewBuffer buffer(checked.text);
  std::istream stream(&buffer);
  receiver.read(stream);
  ObjData data = receiver.take(checked.material_lines);
  data.colors = std::move(checked.colors);
  data.material_libraries = std::move(checked.material_libraries);
  return data;
}

}  // namespace lightbench
