#include "renderer/shader_log.h"

#include <charconv>
#include <optional>

namespace lightbench {
namespace {

struct Place {
  std::size_t file = 0;
  std::size_t line = 0;
  std::size_t length = 0;  ///< of the text that says it
};

/// Takes the number at the start of a text off it.
std::optional<std::size_t> take_number(std::string_view& text) {
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc()) return std::nullopt;
  text.remove_prefix(std::size_t(end - text.data()));
  return number;
}

bool take(std::string_view& text, std::string_view start) {
  if (!text.starts_with(start)) return false;
  text.remove_prefix(start.size());
  return true;
}

std::optional<Place> place_at_start(std::string_view line) {
  std::string_view rest = line;
  if (!take(rest, "ERROR: ")) take(rest, "WARNING: ");
  const auto file = take_number(rest);
  if (!file || (!take(rest, ":") && !take(rest, "("))) return std::nullopt;
  const auto number = take_number(rest);
  if (!number) return std::nullopt;
  take(rest, ")");
  return Place{*file, *number, line.size() - rest.size()};
}

std::string line_with_file_name(std::string_view line, const std::vector<std::string>& files) {
  const auto place = place_at_start(line);
  if (!place) return std::string(line);
  const std::string file = place->file < files.size() ? files[place->file] : std::to_string(place->file);
  return file + ":" + std::to_string(place->line) + std::string(line.substr(place->length));
}

}  // namespace

std::string with_file_names(std::string_view log, const std::vector<std::string>& files) {
  std::string result;
  std::size_t end;
  for (; (end = log.find('\n')) != std::string_view::npos; log.remove_prefix(end + 1))
    result += line_with_file_name(log.substr(0, end), files) + "\n";
  return result + line_with_file_name(log, files);
}

}  // namespace lightbench
