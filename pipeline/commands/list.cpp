#include <algorithm>
#include <cstdio>

#include <CLI/CLI.hpp>

#include "base/error.h"
#include "base/text.h"
#include "pipeline/commands/commands.h"
#include "pipeline/commands/usage_errors.h"
#include "pipeline/references.h"
#include "pipeline/tables.h"
#include "renderer/technique.h"
#include "reports/metric.h"
#include "reports/report_formats.h"

namespace lightbench {
namespace {

struct ListParams {
  std::string what;
  std::string name;
};

void print_row(const std::string& name, const std::string& doc) {
  std::printf("  %-24s %s\n", name.c_str(), doc.c_str());
}

std::string range_text(const ParamSpec& spec) {
  if (spec.type == ParamType::choice) return join(spec.choices, " | ");
  if (spec.type == ParamType::boolean) return "true | false";
  if (spec.type == ParamType::text) return "text";
  return to_text(ParamValue(spec.min)) + " to " + to_text(ParamValue(spec.max));
}

std::string preset_text(const ParamPreset& preset) {
  std::vector<std::string> values;
  for (const auto& [name, value] : preset.values) values.push_back(name + "=" + to_text(value));
  return preset.doc + (values.empty() ? "" : " (" + join(values, ", ") + ")");
}

void print_params(const std::string& name, std::span<const ParamSpec> params,
                  std::span<const ParamPreset> presets) {
  std::printf("%s\n", name.c_str());
  for (const auto& spec : params)
    print_row(spec.name,
              spec.doc + " [" + range_text(spec) + "; default " + to_text(spec.default_value) + "]");
  for (const auto& preset : presets) print_row("preset " + preset.name, preset_text(preset));
}

void list_techniques() {
  std::printf("techniques\n");
  for (const auto& technique : techniques()) print_row(technique.name, technique.doc);
}

void list_metrics() {
  std::printf("metrics\n");
  for (const auto& metric : metrics())
    print_row(metric.name, metric.doc + (metric.unit.empty() ? "" : " [" + metric.unit + "]"));
}

void list_references() {
  std::printf("references\n");
  for (const auto& kind : reference_kinds()) print_row(kind.name, kind.doc);
}

void list_formats() {
  std::printf("formats\n");
  for (const auto& format : report_formats()) print_row(format.name, format.doc);
}

void list_params_of(const Technique& technique) {
  print_params(technique.name, technique.params, technique.presets);
  for (const auto& buffer : technique.buffers) print_row("buffer " + buffer.name, buffer.doc);
}

void list_params_of(const ReferenceKind& kind) {
  print_params(kind.name, kind.params, kind.presets);
}

void list_params() {
  for (const auto& technique : techniques()) list_params_of(technique);
  for (const auto& kind : reference_kinds()) list_params_of(kind);
}

/// Prints the parameters of the technique and of the reference that have the name: there may be both.
void list_params_named(const std::string& name) {
  std::vector<std::string> names = row_names(techniques());
  for (const auto& kind : row_names(reference_kinds()))
    if (std::ranges::find(names, kind) == names.end()) names.push_back(kind);
  if (std::ranges::find(names, name) == names.end())
    throw Error("no technique or reference is called '" + name + "'" + did_you_mean(name, names) +
                    "; there are: " + join(names, ", "),
                "list params");
  for (const auto& technique : techniques())
    if (technique.name == name) list_params_of(technique);
  for (const auto& kind : reference_kinds())
    if (kind.name == name) list_params_of(kind);
}

struct Listing {
  const char* name;
  void (*print)();
};

std::span<const Listing> listings() {
  static const Listing table[] = {{"techniques", list_techniques},
                                  {"metrics", list_metrics},
                                  {"references", list_references},
                                  {"formats", list_formats},
                                  {"params", list_params}};
  return table;
}

ExitCode run_list(const ListParams& params) {
  if (!params.name.empty()) {
    if (params.what != "params")
      throw Error("only 'params' takes the name of a technique or reference", "list");
    list_params_named(params.name);
    return ExitCode::ok;
  }
  for (const auto& listing : listings())
    if (params.what.empty() || params.what == listing.name) listing.print();
  return ExitCode::ok;
}

}  // namespace

void add_list_command(CLI::App& app, Action& action) {
  CLI::App* command = nullptr;
  auto params = add_command<ListParams>(
      app, "list", "List techniques, metrics, references, formats, parameters", action, run_list, command);
  const auto names = row_names(listings());
  command->add_option("what", params->what, join(names, ", ") + "; default: all")->check(one_of(names));
  command->add_option("name", params->name, "With params: of this technique or reference alone");
  command->footer("Examples:\n  lightbench list metrics\n  lightbench list params isr");
}

}  // namespace lightbench
