#include "base/error.h"
#include "base/files.h"
#include "base/text.h"
#include "fuzz_input.h"
#include "pipeline/commands/view_options.h"
#include "pipeline/tables.h"
#include "renderer/technique.h"

namespace lightbench::fuzz {
namespace {

/// `technique name=value ...`, each on a line.
void read_technique(const std::vector<std::string>& lines) {
  const Technique& technique = find_technique(lines.front(), "--technique");
  const auto given = parse_params(technique.params, {lines.begin() + 1, lines.end()});
  JobVariant variant;
  variant.technique = technique.name;
  variant.params = given;
  check_variant(variant, "--technique");
  const auto values = resolve_params(technique.params, technique.presets, "", given, "--param");
  for (const ParamSpec& spec : technique.params) {
    const ParamValue& value = values.all().at(spec.name);
    require(parse_param(spec, to_text(value), "again") == value, "a parameter that reads back as another");
  }
}

}  // namespace

/// What stands on a command line: patterns, sizes, paths with variables, parameters of a technique.
void fuzz_options(std::string_view bytes) {
  const std::vector<std::string> lines = split(bytes, '\n');
  matches_glob(lines.back(), lines.front());
  nearest_name(lines.front(), lines);
  require(escape_file_name(lines.front()).size() <= 120, "a file name that is too long");
  if (lines.front().starts_with("size "))
    parse_size(lines.front().substr(5));
  else if (lines.front().starts_with("path "))
    resolve_path(lines.front().substr(5), "/folder", "--path");
  else
    read_technique(lines);
}

}  // namespace lightbench::fuzz
