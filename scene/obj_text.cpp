#include "scene/obj_text.h"

#include <fmt/format.h>

namespace lightbench {
namespace {

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

}  // namespace

std::string readable_obj_text(std::string text, const std::filesystem::path& file, ProblemList& problems) {
  if (text.starts_with("\xEF\xBB\xBF")) text.replace(0, 3, "   ");
  if (text.find('\0') != text.npos) {
    problems.error("is not a text file: it has zero bytes", file.string());
    return {};
  }
  return join_continued_lines(std::move(text));
}

std::string at_line(const std::filesystem::path& file, std::size_t line) {
  return fmt::format("{}:{}", file.string(), line);
}

}  // namespace lightbench
