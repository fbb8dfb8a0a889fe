#include "scene/obj_indices.h"

#include <algorithm>

#include <fmt/format.h>

namespace lightbench {
namespace {

// From 1, or negative from the end, to from 0; -1 for none, and for what lies before the first one.
std::int32_t from_zero(std::int32_t index, std::size_t count) {
  if (index >= 0) return index - 1;
  return std::int32_t(std::max<std::int64_t>(std::int64_t(count) + index, -1));
}

}  // namespace

ObjIndices::ObjIndices(ObjData& data, const std::filesystem::path& file, ProblemList& problems)
    : data_(data),
      file_(file),
      problems_(problems),
      out_of_range_(problems, Problem::Severity::error, "faces with an index out of range", file.string()) {}

void ObjIndices::Missing::add(std::size_t line) {
  if (count++ == 0) first_line = line;
}

std::optional<ObjCorner> ObjIndices::resolve(const WrittenCorner& written, std::size_t line) {
  const ObjCorner corner{from_zero(written.position, data_.positions.size()),
                         from_zero(written.uv, data_.uvs.size()),
                         from_zero(written.normal, data_.normals.size())};
  if (corner.position < 0) {
    report(written, line);
    return std::nullopt;
  }
  if (written.uv < 0 && corner.uv < 0) uvs_.add(line);
  if (written.normal < 0 && corner.normal < 0) normals_.add(line);
  return corner;
}

void ObjIndices::finish() {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < data_.faces.size(); ++i)
    if (check(data_.faces[i], face_lines_[i])) data_.faces[kept++] = data_.faces[i];
  data_.faces.resize(kept);
  warn_of(normals_, "normal", "a computed one is used");
  warn_of(uvs_, "texture coordinate", "none is used");
}

bool ObjIndices::check(const ObjFace& face, std::size_t line) {
  for (std::size_t i = face.first_corner; i < face.first_corner + face.corner_count; ++i) {
    ObjCorner& c = data_.corners[i];
    if (std::size_t(c.position) >= data_.positions.size()) {
      report({c.position + 1, c.uv + 1, c.normal + 1}, line);
      return false;
    }
    if (c.uv >= 0 && std::size_t(c.uv) >= data_.uvs.size()) {
      uvs_.add(line);
      c.uv = -1;
    }
    if (c.normal >= 0 && std::size_t(c.normal) >= data_.normals.size()) {
      normals_.add(line);
      c.normal = -1;
    }
  }
  return true;
}

void ObjIndices::report(const WrittenCorner& corner, std::size_t line) {
  const auto text = [](std::int32_t i) { return i == 0 ? std::string() : fmt::format("{}", i); };
  out_of_range_.add(
      fmt::format("index out of range: {}/{}/{} of {} vertices, {} texture coordinates and {} normals",
                  corner.position, text(corner.uv), text(corner.normal), data_.positions.size(),
                  data_.uvs.size(), data_.normals.size()),
      at_line(file_, line));
}

void ObjIndices::warn_of(const Missing& missing, const char* what, const char* instead) {
  if (missing.count == 0) return;
  problems_.warning(fmt::format("{} corners of faces name a {} that the file does not have: {}",
                                missing.count, what, instead),
                    at_line(file_, missing.first_line));
}

}  // namespace lightbench
