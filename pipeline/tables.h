#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/json_reader.h"
#include "base/params.h"
#include "pipeline/job.h"

/// Small helpers around the tables of techniques, references and metrics.
namespace lightbench {

template <typename Row, std::size_t Extent>
std::vector<std::string> row_names(std::span<Row, Extent> rows) {
  std::vector<std::string> names;
  for (const auto& row : rows) names.push_back(row.name);
  return names;
}

template <typename Row>
std::vector<std::string> row_names(const std::vector<Row>& rows) {
  return row_names(std::span(rows));
}

/// Whether `name` is the pattern itself, or matches it as a shell pattern.
bool matches_name(std::string_view name, std::string_view pattern);

/// Whether a text parameter holds a path, which a job gives relative to its own folder.
bool is_path_param(const ParamSpec& spec);

/// The value of such a parameter as it stands in a file in `base`: absolute where that is, its variables
/// replaced.
std::string resolve_path_param(const ParamSpec& spec, const std::string& text,
                               const std::filesystem::path& base, const std::string& where);

/// Buffers that at least one of the variants' techniques has, in the order of the tables.
std::vector<std::string> known_buffers(const std::vector<JobVariant>& variants);

const std::vector<std::string>& gate_over_names();
Gate::Over parse_gate_over(const JsonValue& value);
std::string to_text(Gate::Over over);

/// Throw Error where the parameters do not go together with the technique or reference.
void check_variant(const JobVariant& variant, const std::string& where);
void check_reference(const JobReference& reference, const std::string& where);

}  // namespace lightbench
