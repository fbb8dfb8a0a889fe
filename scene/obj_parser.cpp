#include "scene/obj_parser.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <istream>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <glm/common.hpp>

// The distribution's library has floats, so its header is compiled here.
#define TINYOBJLOADER_USE_DOUBLE
#define TINYOBJLOADER_IMPLEMENTATION
#include <tiny_obj_loader.h>

#include "base/files.h"
#include "scene/line_feed.h"
#include "scene/obj_corner.h"
#include "scene/obj_indices.h"
#include "scene/obj_keywords.h"
#include "scene/obj_names.h"
#include "scene/text_scan.h"

namespace lightbench {
namespace {

// This stands for no colour: no file has one so far below zero.
const glm::vec3 kNoColor(-1e30f);
// Colours of 0 to 1 may be a little above; the smallest white of 0 to 255 is far above.
constexpr float kLargestRoundedColor = 2;

// What a statement's numbers are, apart from their values.
struct Numbers {
  std::size_t count = 0;
  std::size_t finite = 0;  // so many before the first one that is not
  std::string_view odd;    // that one
  std::string_view used;   // the text of those that the library is to parse

  bool are_fine(std::size_t wanted) const { return count > 0 && finite >= std::min(count, wanted); }
};

// Checks the statements one by one, keeps what they name, and lets the library parse the numbers of those
// that have no fault.
class ObjReader {
 public:
  ObjReader(const std::filesystem::path& file, ProblemList& problems, const ObjLimits& limits)
      : file_(file),
        limits_(limits),
        problems_(problems),
        bad_numbers_(problems, Problem::Severity::error, "lines with what is no finite number",
                     file.string()),
        short_lines_(problems, Problem::Severity::error, "lines that are too short", file.string()),
        bad_corners_(problems, Problem::Severity::error, "faces with a malformed corner", file.string()),
        bad_uvs_(problems, Problem::Severity::warning, "texture coordinates that are not finite",
                 file.string()),
        bad_colors_(problems, Problem::Severity::warning, "vertex colours that are not finite",
                    file.string()),
        nameless_(problems, Problem::Severity::note, "usemtl without a name", file.string()),
        unknown_(problems, Problem::Severity::warning, "unknown statements", file.string()),
        indices_(data_, file, problems) {}

  ObjData run(std::string_view text) {
    LineScanner lines(text);
    LineFeed feed([&](std::string& checked) { return next_checked(lines, checked); });
    std::istream stream(&feed);
    tinyobj::callback_t callbacks;
    callbacks.vertex_cb = [](void* self, double x, double y, double z, double) {
      as(self).data_.positions.emplace_back(finite(x), finite(y), finite(z));
    };
    callbacks.normal_cb = [](void* self, double x, double y, double z) {
      as(self).data_.normals.emplace_back(finite(x), finite(y), finite(z));
    };
    callbacks.texcoord_cb = [](void* self, double x, double y, double) {
      as(self).data_.uvs.emplace_back(finite(x), finite(y));
    };
    tinyobj::LoadObjWithCallback(stream, callbacks, this);
    feed.rethrow();
    finish();
    return std::move(data_);
  }

 private:
  static ObjReader& as(void* self) { return *static_cast<ObjReader*>(self); }
  // The library makes NaN of words like 0e999.
  static double finite(double x) { return std::isfinite(x) ? x : 0.0; }

  // Reads on to the next statement whose numbers the library is to parse; false at the end.
  bool next_checked(LineScanner& lines, std::string& checked) {
    checked.clear();
    while (const auto line = lines.next()) {
      line_ = lines.line();
      truncated_ = !lines.ended_by_newline();
      read_line(*line, checked);
      if (!checked.empty()) return true;
    }
    return false;
  }

  void read_line(std::string_view rest, std::string& checked) {
    if (rest.size() > limits_.line_bytes)
      throw Error(fmt::format("the line has {}, and at most {} are read", bytes_text(rest.size()),
                              bytes_text(limits_.line_bytes)),
                  here());
    const std::string_view word = take_word(rest);
    if (word.empty() || word[0] == '#') return;
    if (const auto statement = find_obj_statement(word)) return read_statement(*statement, rest, checked);
    unknown_.add(fmt::format("unknown statement '{}'", word.substr(0, 40)), here());
  }

  void read_statement(ObjStatement statement, std::string_view rest, std::string& checked) {
    switch (statement) {
      case ObjStatement::vertex:
        return read_vertex(without_comment(rest), checked);
      case ObjStatement::normal:
        return read_normal(without_comment(rest), checked);
      case ObjStatement::uv:
        return read_uv(without_comment(rest), checked);
      case ObjStatement::face:
        return read_face(without_comment(rest));
      case ObjStatement::object:
        return names_.begin_object(name_in(rest));
      case ObjStatement::group:
        return names_.begin_group(name_in(rest));
      case ObjStatement::smoothing:
        names_.begin_smoothing(stripped(without_comment(rest)));
        return count(names_.smoothing_groups(), limits_.names, "smoothing groups");
      case ObjStatement::material:
        return use_material(name_in(rest));
      case ObjStatement::library:
        data_.material_libraries.push_back({std::string(name_in(rest)), line_});
        return count(data_.material_libraries.size(), limits_.libraries, "statements mtllib");
      case ObjStatement::line_or_point:
        ++lines_and_points_;
        return;
      case ObjStatement::free_form:
        ++free_form_;
        return;
      case ObjStatement::ignored:
        return;
    }
  }

  void count(std::size_t counted, std::size_t most, const char* what) const {
    if (counted > most) throw Error(fmt::format("the file has more than {} {}", most, what), here());
  }

  std::string_view name_in(std::string_view rest) {
    count(++name_count_, limits_.names, "names of objects, groups, materials and libraries");
    const std::string_view name = stripped(rest);
    if (name.size() > limits_.name_bytes)
      throw Error(fmt::format("the name has {}, and at most {} are read", bytes_text(name.size()),
                              bytes_text(limits_.name_bytes)),
                  here());
    return name;
  }

  void use_material(std::string_view name) {
    names_.use_material(name, line_);
    if (!name.empty()) return;
    // A file that ends here may have lost the name, and more.
    if (truncated_) return short_lines_.add(fmt::format("usemtl without a name{}", cut()), here());
    nameless_.add("usemtl without a name: the faces after it have no material", here());
  }

  // At least so many numbers must be there, and at most so many are used. None where the statement is
  // malformed.
  Numbers check_numbers(std::string_view text, std::size_t at_least, std::size_t used) {
    Numbers numbers;
    std::string_view rest = text;
    for (std::string_view word = take_word(rest); !word.empty(); word = take_word(rest)) {
      const NumberKind kind = classify_number(word);
      if (kind == NumberKind::malformed) {
        bad_numbers_.add(fmt::format("'{}' is not a number{}", word.substr(0, 40), cut()), here());
        return {};
      }
      if (kind == NumberKind::finite && numbers.odd.empty()) ++numbers.finite;
      if (kind == NumberKind::not_finite && numbers.odd.empty()) numbers.odd = word.substr(0, 40);
      if (++numbers.count <= used) numbers.used = text.substr(0, std::size_t(rest.data() - text.data()));
    }
    if (numbers.count >= at_least) return numbers;
    short_lines_.add(fmt::format("{} numbers where {} are needed{}", numbers.count, at_least, cut()), here());
    return {};
  }

  // Gives the statement to the library, or counts one that cannot be read as zeros, so that the indices of
  // faces stay right.
  template <typename Vector>
  static void parse_or_zero(const char* keyword, std::string_view numbers, bool fine,
                            std::vector<Vector>& values, std::string& checked) {
    if (fine)
      checked.append(keyword).append(numbers).append("\n");
    else
      values.emplace_back(0);
  }

  void read_vertex(std::string_view rest, std::string& checked) {
    const std::size_t index = data_.positions.size();
    count(index + 1, limits_.vertices, "vertices");
    const Numbers n = check_numbers(rest, 3, 3);
    parse_or_zero("v ", n.used, n.are_fine(3), data_.positions, checked);
    if (n.count > 0 && !n.are_fine(3))
      bad_numbers_.add(fmt::format("a vertex has '{}', which is no finite number up to 1e18", n.odd), here());
    else if (n.count >= 6)
      read_color(rest, n, index);
  }

  // The library's callbacks leave out what stands behind a position.
  void read_color(std::string_view rest, const Numbers& n, std::size_t index) {
    if (!n.are_fine(6))
      return bad_colors_.add(fmt::format("a vertex colour with '{}' is left out", n.odd), here());
    std::array<double, 6> values{};
    for (double& value : values) value = number_of(take_word(rest));
    data_.colors.resize(index, kNoColor);
    data_.colors.emplace_back(values[3], values[4], values[5]);
  }

  // A normal that is not finite is zero, and so computed.
  void read_normal(std::string_view rest, std::string& checked) {
    count(data_.normals.size() + 1, limits_.vertices, "normals");
    const Numbers n = check_numbers(rest, 3, 3);
    parse_or_zero("vn ", n.used, n.are_fine(3), data_.normals, checked);
  }

  void read_uv(std::string_view rest, std::string& checked) {
    count(data_.uvs.size() + 1, limits_.vertices, "texture coordinates");
    const Numbers n = check_numbers(rest, 1, 2);
    parse_or_zero("vt ", n.used, n.are_fine(2), data_.uvs, checked);
    if (n.count > 0 && !n.are_fine(2))
      bad_uvs_.add(fmt::format("a texture coordinate '{}' is taken as 0", n.odd), here());
  }

  // Faces are read here: the library takes what is no corner for one, and says nothing of it.
  void read_face(std::string_view rest) {
    const std::size_t first = data_.corners.size();
    for (std::string_view word = take_word(rest); !word.empty(); word = take_word(rest)) {
      count(++corner_count_, limits_.corners, "corners of faces");
      if (data_.corners.size() - first == limits_.polygon_corners)
        throw Error(fmt::format("a face has more than {} corners", limits_.polygon_corners), here());
      const auto written = read_corner(word);
      if (!written) {
        data_.corners.resize(first);
        return bad_corners_.add(fmt::format("'{}' is not a corner of a face{}", word.substr(0, 40), cut()),
                                here());
      }
      const auto corner = indices_.resolve(*written, line_);
      if (!corner) return data_.corners.resize(first);
      data_.corners.push_back(*corner);
    }
    add_face(first);
  }

  void add_face(std::size_t first) {
    const std::size_t corners = data_.corners.size() - first;
    if (corners < 3) {
      data_.corners.resize(first);
      if (truncated_) return short_lines_.add(fmt::format("a face of {} corners{}", corners, cut()), here());
      ++short_faces_;
      return;
    }
    count(triangle_count_ += corners - 2, limits_.triangles, "triangles");
    data_.faces.push_back({std::uint32_t(first), std::uint32_t(corners), names_.material(), names_.shape(),
                           names_.smoothing()});
    indices_.add_face(line_);
  }

  void finish_colors() {
    float largest = 0;
    for (const glm::vec3& c : data_.colors) largest = std::max({largest, c.x, c.y, c.z});
    const bool bytes = largest > kLargestRoundedColor;
    if (bytes) problems_.warning("vertex colours above 2: all are taken as 0 to 255", file_.string());
    for (glm::vec3& c : data_.colors)
      c = c == kNoColor ? glm::vec3(1) : glm::clamp(bytes ? c / 255.0f : c, glm::vec3(0), glm::vec3(1));
    // The vertices behind the last colour have none either, and are white.
    if (!data_.colors.empty()) data_.colors.resize(data_.positions.size(), glm::vec3(1.0f));
  }

  void finish() {
    indices_.finish();
    finish_colors();
    data_.shapes = names_.shapes();
    data_.materials = names_.materials();
    if (short_faces_ > 0)
      problems_.note(fmt::format("{} faces of fewer than 3 corners are left out", short_faces_),
                     file_.string());
    if (lines_and_points_ > 0)
      problems_.warning(fmt::format("{} lines and points are not shown", lines_and_points_), file_.string());
    if (free_form_ > 0)
      problems_.warning("free-form curves and surfaces are not shown, only polygons", file_.string());
  }

  std::string here() const { return at_line(file_, line_); }
  const char* cut() const { return truncated_ ? "; the file ends in the middle of this line" : ""; }

  const std::filesystem::path& file_;
  const ObjLimits& limits_;
  ProblemList& problems_;
  RepeatedProblem bad_numbers_;
  RepeatedProblem short_lines_;
  RepeatedProblem bad_corners_;
  RepeatedProblem bad_uvs_;
  RepeatedProblem bad_colors_;
  RepeatedProblem nameless_;
  RepeatedProblem unknown_;
  ObjData data_;
  ObjIndices indices_;
  ObjNames names_;
  std::size_t name_count_ = 0;
  std::size_t corner_count_ = 0;
  std::size_t triangle_count_ = 0;
  std::size_t short_faces_ = 0;
  std::size_t lines_and_points_ = 0;
  std::size_t free_form_ = 0;
  std::size_t line_ = 0;
  bool truncated_ = false;
};

}  // namespace

ObjData parse_obj(const std::filesystem::path& file, ProblemList& problems, const ObjLimits& limits) {
  const std::string text = readable_obj_text(read_file(file, limits.file_bytes), file, problems);
  return ObjReader(file, problems, limits).run(text);
}

}  // namespace lightbench
