#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "base/json_reader.h"

namespace lightbench {

/// A parameter's value: a boolean, a whole number, a number, or text (also the name of a choice).
using ParamValue = std::variant<bool, long long, double, std::string>;

enum class ParamType { boolean, integer, number, text, choice };

/// One parameter of a technique or reference. `--help`, `list`, the job schema and the docs read these rows.
struct ParamSpec {
  std::string name;
  ParamType type;
  ParamValue default_value;
  double min = 0;  ///< of integer and number
  double max = 0;
  std::vector<std::string> choices;  ///< of choice
  std::string doc;
};

ParamSpec boolean_param(std::string name, bool default_value, std::string doc);
ParamSpec integer_param(std::string name, long long default_value, long long min, long long max,
                        std::string doc);
ParamSpec number_param(std::string name, double default_value, double min, double max, std::string doc);
ParamSpec text_param(std::string name, std::string default_value, std::string doc);
/// The first choice is the default.
ParamSpec choice_param(std::string name, std::vector<std::string> choices, std::string doc);
/// As that, but for the default.
ParamSpec choice_param(std::string name, std::vector<std::string> choices, std::string default_value,
                       std::string doc);

/// A named set of values that a variant may start from ("preset": "paper").
struct ParamPreset {
  std::string name;
  std::map<std::string, ParamValue> values;
  std::string doc;
};

/// A complete, checked set: every parameter of the specification has a value.
class ParamValues {
 public:
  ParamValues() = default;
  explicit ParamValues(std::map<std::string, ParamValue> values) : values_(std::move(values)) {}

  bool boolean(const std::string& name) const;
  int integer(const std::string& name) const;
  double number(const std::string& name) const;
  const std::string& text(const std::string& name) const;
  const std::map<std::string, ParamValue>& all() const { return values_; }

 private:
  const ParamValue& at(const std::string& name) const;  ///< asserts that it is there
  std::map<std::string, ParamValue> values_;
};

/// The defaults, then the preset, then the given values. Throws Error(…, where) for an unknown preset or name
/// (with the nearest known one), a wrong type, or a value out of range.
ParamValues resolve_params(std::span<const ParamSpec> specs, std::span<const ParamPreset> presets,
                           const std::string& preset, const std::map<std::string, ParamValue>& given,
                           const std::string& where);

/// A JSON scalar as the value of `spec`, with its place in errors.
ParamValue read_param(const ParamSpec& spec, const JsonValue& value);
/// The text of a command line option (`--param name=value`) as the value of `spec`.
ParamValue parse_param(const ParamSpec& spec, const std::string& text, const std::string& where);

/// Shortest text that reads back to the same value; for names, keys and reports.
std::string to_text(const ParamValue& value);
/// "name=value name=value", by name.
std::string to_text(const ParamValues& values);

}  // namespace lightbench
