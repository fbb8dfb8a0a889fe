#include "pipeline/tables.h"

#include <algorithm>

#include "base/files.h"
#include "base/text.h"
#include "pipeline/references.h"
#include "renderer/technique.h"

namespace lightbench {

bool matches_name(std::string_view name, std::string_view pattern) {
  return name == pattern || matches_glob(name, pattern);
}

bool is_path_param(const ParamSpec& spec) {
  return spec.type == ParamType::text &&
         (spec.name == "pattern" || spec.name == "folder" || spec.name == "file");
}

std::string resolve_path_param(const ParamSpec& spec, const std::string& text,
                               const std::filesystem::path& base, const std::string& where) {
  return spec.name == "pattern" ? resolve_pattern(text, base, where)
                                : resolve_path(text, base, where).string();
}

std::vector<std::string> known_buffers(const std::vector<JobVariant>& variants) {
  std::vector<std::string> names;
  for (const auto& variant : variants)
    for (const auto& buffer : find_technique(variant.technique, "").buffers)
      if (std::find(names.begin(), names.end(), buffer.name) == names.end()) names.push_back(buffer.name);
  return names;
}

const std::vector<std::string>& gate_over_names() {
  static const std::vector<std::string> names = {"each", "mean", "worst"};
  return names;
}

Gate::Over parse_gate_over(const JsonValue& value) {
  const std::string text = value.choice(gate_over_names());
  const auto& names = gate_over_names();
  return static_cast<Gate::Over>(std::find(names.begin(), names.end(), text) - names.begin());
}

std::string to_text(Gate::Over over) {
  return gate_over_names()[static_cast<std::size_t>(over)];
}

ParamValues variant_params(const JobVariant& variant) {
  const Technique& technique = find_technique(variant.technique, "");
  return resolve_params(technique.params, technique.presets, variant.preset, variant.params, "");
}

namespace {

ParamValues resolved_params(const JobReference& reference, const std::string& where) {
  const ReferenceKind& kind = find_reference_kind(reference.kind, where);
  const std::string& preset = reference.preset.empty() ? kind.default_preset : reference.preset;
  return resolve_params(kind.params, kind.presets, preset, reference.params, where);
}

}  // namespace

ParamValues reference_params(const JobReference& reference) {
  return resolved_params(reference, "");
}

void check_variant(const JobVariant& variant, const std::string& where) {
  const Technique& technique = find_technique(variant.technique, where);
  resolve_params(technique.params, technique.presets, variant.preset, variant.params, where);
}

void check_reference(const JobReference& reference, const std::string& where) {
  resolved_params(reference, where);
}

}  // namespace lightbench
