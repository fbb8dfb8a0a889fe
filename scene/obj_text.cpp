#include "scene/obj_text.h"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>
#include <glm/common.hpp>

#include "scene/text_scan.h"

namespace lightbench {
namespace {

// No mesh has more vertices than this; larger indices would overflow the parser's integers.
constexpr std::size_t kMaxIndexDigits = 9;

// Statements of the format that change nothing about polygons, and so are passed over.
constexpr std::array<std::string_view, 16> kIgnored{
    "s",   "vp",         "vw",        "t",     "mg",    "bevel", "c_interp", "d_interp",
    "lod", "shadow_obj", "trace_obj", "ctech", "stech", "deg",   "cstype",   "end"};
constexpr std::array<std::string_view, 4> kNaming{"o", "g", "usemtl", "mtllib"};
constexpr std::array<std::string_view, 12> kFreeForm{"curv", "curv2", "surf", "parm", "trim", "hole",
                                                     "scrv", "sp",    "con",  "bmat", "step", "cdc"};

template <std::size_t n>
bool contains(const std::array<std::string_view, n>& words, std::string_view word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

std::size_t line_end_length(std::string_view text, std::size_t at) {
  if (text.compare(at, 2, "\r\n") == 0) return 2;
  return at < text.size() && (text[at] == '\n' || text[at] == '\r') ? 1 : 0;
}

// Joins continued lines; the line ends that were taken out follow the joined line, so that lines keep their
// numbers.
std::string join_continued_lines(std::string text) {
  if (text.find("\\\n") == text.npos && text.find("\\\r") == text.npos) return text;
  std::string joined;
  joined.reserve(text.size());
  std::size_t owed = 0;
  bool comment = false;
  bool at_start = true;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t continued = text[i] == '\\' && !comment ? line_end_length(text, i + 1) : 0;
    if (continued > 0) {
      joined += ' ';
      ++owed;
      i += 1 + continued;
      continue;
    }
    if (const std::size_t end = line_end_length(text, i); end > 0) {
      joined.append(owed + 1, '\n');
      owed = 0;
      comment = false;
      at_start = true;
      i += end;
      continue;
    }
    if (at_start && text[i] != ' ' && text[i] != '\t') {
      comment = text[i] == '#';
      at_start = false;
    }
    joined += text[i++];
  }
  return joined;
}

// Takes "[+-]digits" off the front of `word`; false where they are malformed. An empty number is accepted.
bool take_index(std::string_view& word, bool& empty) {
  std::size_t i = 0;
  if (i < word.size() && (word[i] == '-' || word[i] == '+')) ++i;
  const std::size_t start = i;
  while (i < word.size() && word[i] >= '0' && word[i] <= '9') ++i;
  empty = i == 0;
  const bool fine = empty || (i > start && i - start <= kMaxIndexDigits);
  word.remove_prefix(i);
  return fine;
}

// v, v/vt, v//vn, v/vt/vn, and the same with nothing after a slash.
bool is_corner(std::string_view word) {
  bool empty = false;
  if (!take_index(word, empty) || empty) return false;
  for (int slashes = 0; slashes < 2 && word.starts_with('/'); ++slashes) {
    word.remove_prefix(1);
    if (!take_index(word, empty)) return false;
  }
  return word.empty();
}

class ObjTextChecker {
 public:
  ObjTextChecker(std::string text, const std::filesystem::path& file, ProblemList& problems,
                 const ObjLimits& limits)
      : file_(file),
        limits_(limits),
        bad_numbers_(problems, Problem::Severity::error, "lines with what is no finite number",
                     file.string()),
        short_lines_(problems, Problem::Severity::error, "lines that are too short", file.string()),
        bad_corners_(problems, Problem::Severity::error, "faces with a malformed corner", file.string()),
        bad_texture_coordinates_(problems, Problem::Severity::warning,
                                 "texture coordinates that are not finite", file.string()),
        unknown_(problems, Problem::Severity::warning, "unknown statements", file.string()),
        problems_(problems) {
    result_.text = join_continued_lines(std::move(text));
  }

  ObjText run() {
    LineScanner lines(result_.text);
    while (const auto line = lines.next()) {
      line_ = lines.line();
      truncated_ = !lines.ended_by_newline();
      check_line(*line);
    }
    finish();
    return std::move(result_);
  }

 private:
  void check_line(std::string_view line) {
    if (line.size() > limits_.line_bytes)
      throw Error(fmt::format("the line has {}, and at most {} are read", bytes_text(line.size()),
                              bytes_text(limits_.line_bytes)),
                  here());
    std::string_view rest = line;
    const std::string_view keyword = take_word(rest);
    if (keyword.empty() || keyword[0] == '#') return;
    if (keyword == "v") return check_vertex(arguments(rest));
    if (keyword == "vn") return check_vector(arguments(rest), 3, Kind::normal);
    if (keyword == "vt") return check_vector(arguments(rest), 1, Kind::texture_coordinate);
    if (keyword == "f") return check_face(keyword, arguments(rest));
    if (contains(kNaming, keyword)) return check_name(keyword, stripped(rest));
    if (contains(kIgnored, keyword)) return;
    if (keyword == "l" || keyword == "p") {
      ++lines_and_points_;
      comment_out(keyword);
    } else if (contains(kFreeForm, keyword)) {
      ++free_form_;
    } else {
      unknown_.add(fmt::format("unknown statement '{}'", keyword.substr(0, 40)), here());
      comment_out(keyword);
    }
  }

  void count(std::size_t& counted, std::size_t more, std::size_t most, const char* what) const {
    counted += more;
    if (counted > most) throw Error(fmt::format("the file has more than {} {}", most, what), here());
  }

  void check_name(std::string_view keyword, std::string_view name) {
    count(counts_.names, 1, limits_.names, "names of objects, groups, materials and libraries");
    if (name.size() > limits_.name_bytes)
      throw Error(fmt::format("the name has {}, and at most {} are read", bytes_text(name.size()),
                              bytes_text(limits_.name_bytes)),
                  here());
    if (keyword == "mtllib") result_.material_libraries.push_back({std::string(name), line_});
    if (keyword == "usemtl") check_material(keyword, name);
  }

  void check_material(std::string_view keyword, std::string_view name) {
    if (!name.empty()) return result_.material_lines.push_back(line_);
    short_lines_.add(fmt::format("usemtl without a name{}", cut()), here());
    comment_out(keyword);
  }

  enum class Kind { normal, texture_coordinate };

  // The words of a statement that has no names; a comment at its end is blanked.
  std::string_view arguments(std::string_view rest) {
    const std::size_t comment = rest.find('#');
    if (comment == rest.npos) return rest;
    const std::size_t start = position(rest) + comment;
    std::fill_n(result_.text.begin() + std::ptrdiff_t(start), rest.size() - comment, ' ');
    return rest.substr(0, comment);
  }

  // True when all words are finite numbers and there are enough of them.
  bool check_numbers(std::string_view rest, std::size_t at_least, bool& not_finite) {
    std::size_t count = 0;
    not_finite = false;
    for (std::string_view word = take_word(rest); !word.empty(); word = take_word(rest), ++count) {
      const NumberKind kind = classify_number(word);
      if (kind == NumberKind::malformed) {
        bad_numbers_.add(fmt::format("'{}' is not a number{}", word.substr(0, 40), cut()), here());
        return false;
      }
      not_finite |= kind == NumberKind::not_finite;
    }
    if (count >= at_least) return !not_finite;
    short_lines_.add(fmt::format("{} numbers where {} are needed{}", count, at_least, cut()), here());
    not_finite = false;
    return false;
  }

  void check_vertex(std::string_view rest) {
    count(counts_.vertices, 1, limits_.vertices, "vertices");
    bool not_finite = false;
    if (check_numbers(rest, 3, not_finite)) take_color(rest);
    if (not_finite) bad_numbers_.add("a vertex that is not finite, or beyond 1e18", here());
  }

  void check_vector(std::string_view rest, std::size_t at_least, Kind kind) {
    if (kind == Kind::normal)
      count(counts_.normals, 1, limits_.vertices, "normals");
    else
      count(counts_.uvs, 1, limits_.vertices, "texture coordinates");
    bool not_finite = false;
    check_numbers(rest, at_least, not_finite);
    if (!not_finite) return;
    // Zeros, so that a normal is computed instead.
    const std::size_t start = position(rest);
    for (std::size_t i = start; i < start + rest.size(); ++i)
      if (result_.text[i] != ' ' && result_.text[i] != '\t') result_.text[i] = '0';
    if (kind == Kind::texture_coordinate)
      bad_texture_coordinates_.add("a texture coordinate that is not finite is taken as 0", here());
  }

  void check_face(std::string_view keyword, std::string_view rest) {
    std::size_t corners = 0;
    for (std::string_view word = take_word(rest); !word.empty(); word = take_word(rest)) {
      count(counts_.corners, 1, limits_.corners, "corners of faces");
      if (++corners > limits_.polygon_corners)
        throw Error(fmt::format("a face has more than {} corners", limits_.polygon_corners), here());
      if (is_corner(word)) {
        blank_trailing_slashes(word);
        continue;
      }
      bad_corners_.add(fmt::format("'{}' is not a corner of a face{}", word.substr(0, 40), cut()), here());
      return comment_out(keyword);
    }
    if (corners >= 3) return count(counts_.triangles, corners - 2, limits_.triangles, "triangles");
    comment_out(keyword);
    if (truncated_)
      short_lines_.add(fmt::format("a face of {} corners{}", corners, cut()), here());
    else
      ++short_faces_;
  }

  // After "1/ 2" the parser would take 2 for a part of the first corner.
  void blank_trailing_slashes(std::string_view word) {
    for (; word.ends_with('/'); word.remove_suffix(1)) result_.text[position(word) + word.size() - 1] = ' ';
  }

  void take_color(std::string_view rest) {
    std::array<std::string_view, 6> words;
    for (std::string_view& word : words) word = take_word(rest);
    if (words[5].empty()) return;
    result_.colors.resize(counts_.vertices - 1, glm::vec3(1.0f));
    result_.colors.emplace_back(number_of(words[3]), number_of(words[4]), number_of(words[5]));
  }

  void finish_colors() {
    float largest = 0;
    for (glm::vec3& c : result_.colors) {
      c = glm::max(c, glm::vec3(0));
      largest = std::max({largest, c.x, c.y, c.z});
    }
    if (largest > 1) {
      problems_.warning("vertex colours above 1: they are taken as 0 to 255", file_.string());
      for (glm::vec3& c : result_.colors) c /= 255.0f;
    }
    // Those without one are white.
    if (!result_.colors.empty()) result_.colors.resize(counts_.vertices, glm::vec3(1.0f));
  }

  void finish() {
    finish_colors();
    if (short_faces_ > 0)
      problems_.note(fmt::format("{} faces of fewer than 3 corners are left out", short_faces_),
                     file_.string());
    if (lines_and_points_ > 0)
      problems_.warning(fmt::format("{} lines and points are not shown", lines_and_points_), file_.string());
    if (free_form_ > 0)
      problems_.warning("free-form curves and surfaces are not shown, only polygons", file_.string());
  }

  std::size_t position(std::string_view part) const { return std::size_t(part.data() - result_.text.data()); }
  void comment_out(std::string_view keyword) { result_.text[position(keyword)] = '#'; }
  std::string here() const { return at_line(file_, line_); }
  const char* cut() const { return truncated_ ? "; the file ends in the middle of this line" : ""; }

  struct Counts {
    std::size_t vertices = 0, uvs = 0, normals = 0, corners = 0, triangles = 0, names = 0;
  };

  const std::filesystem::path& file_;
  const ObjLimits& limits_;
  Counts counts_;
  ObjText result_;
  RepeatedProblem bad_numbers_;
  RepeatedProblem short_lines_;
  RepeatedProblem bad_corners_;
  RepeatedProblem bad_texture_coordinates_;
  RepeatedProblem unknown_;
  ProblemList& problems_;
  std::size_t short_faces_ = 0;
  std::size_t lines_and_points_ = 0;
  std::size_t free_form_ = 0;
  std::size_t line_ = 0;
  bool truncated_ = false;
};

}  // namespace

ObjText check_obj_text(std::string text, const std::filesystem::path& file, ProblemList& problems,
                       const ObjLimits& limits) {
  if (text.starts_with("\xEF\xBB\xBF")) text.replace(0, 3, "   ");
  if (text.find('\0') != text.npos) {
    problems.error("is not a text file: it has zero bytes", file.string());
    return {};
  }
  return ObjTextChecker(std::move(text), file, problems, limits).run();
}

std::size_t line_of_statement(std::string_view text, std::string_view keyword, std::size_t n) {
  LineScanner lines(text);
  while (auto line = lines.next())
    if (take_word(*line) == keyword && n-- == 0) return lines.line();
  return 0;
}

std::string at_line(const std::filesystem::path& file, std::size_t line) {
  return fmt::format("{}:{}", file.string(), line);
}

}  // namespace lightbench
