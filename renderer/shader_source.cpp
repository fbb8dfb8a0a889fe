#include "renderer/shader_source.h"

#include <algorithm>
#include <optional>
#include <stdexcept>

namespace lightbench {
namespace {

std::string_view embedded_text(std::string_view name) {
  for (const EmbeddedShader& shader : embedded_shaders())
    if (shader.name == name) return shader.text;
  throw std::logic_error("no shader file is named " + std::string(name));
}

// The path of an `#include "path"` line.
std::optional<std::string_view> included_path(std::string_view line) {
  constexpr std::string_view kStart = "#include \"";
  if (!line.starts_with(kStart)) return std::nullopt;
  line.remove_prefix(kStart.size());
  const auto end = line.find('"');
  if (end == std::string_view::npos)
    throw std::logic_error("an #include without an end: " + std::string(line));
  return line.substr(0, end);
}

class Expander {
 public:
  explicit Expander(bool with_lines) : with_lines_(with_lines) {}

  void expand(std::string_view name) {
    const std::size_t number = result_.files.size();
    result_.files.emplace_back(name);
    mark(1, number);
    std::string_view rest = embedded_text(name);
    for (int line_number = 1; !rest.empty(); ++line_number) {
      const std::string_view line = rest.substr(0, rest.find('\n'));
      rest.remove_prefix(std::min(line.size() + 1, rest.size()));
      if (const auto path = included_path(line)) {
        if (std::find(result_.files.begin(), result_.files.end(), *path) == result_.files.end())
          expand(*path);
        mark(line_number + 1, number);
      } else {
        result_.text.append(line).append("\n");
      }
    }
  }

  NumberedShader take() { return std::move(result_); }

 private:
  void mark(int line, std::size_t number) {
    if (with_lines_) result_.text += "#line " + std::to_string(line) + " " + std::to_string(number) + "\n";
  }

  bool with_lines_;
  NumberedShader result_;
};

}  // namespace

std::string shader_source(std::string_view name) {
  Expander expander(false);
  expander.expand(name);
  return expander.take().text;
}

NumberedShader numbered_shader_source(std::string_view name) {
  Expander expander(true);
  expander.expand(name);
  return expander.take();
}

}  // namespace lightbench
