#include "base/params.h"

#include <algorithm>
#include <cassert>
#include <charconv>
#include <cmath>

#include <fmt/format.h>

#include "base/error.h"
#include "base/text.h"

namespace lightbench {
namespace {

template <typename Row>
std::vector<std::string> names_of(std::span<const Row> rows) {
  std::vector<std::string> names;
  for (const auto& row : rows) names.push_back(row.name);
  return names;
}

template <typename Row>
const Row* find_row(std::span<const Row> rows, const std::string& name) {
  const auto found = std::find_if(rows.begin(), rows.end(), [&](const Row& r) { return r.name == name; });
  return found == rows.end() ? nullptr : &*found;
}

void check_range(const ParamSpec& spec, double value, const std::string& where) {
  if (!std::isfinite(value) || value < spec.min || value > spec.max)
    throw Error(fmt::format("'{}' must be between {} and {}, not {}", spec.name, spec.min, spec.max, value),
                where);
}

/// For errors: a text looks like the number in it, so it is called one.
std::string described(const ParamValue& value) {
  const auto* text = std::get_if<std::string>(&value);
  return text ? "the text '" + *text + "'" : to_text(value);
}

/// The value in the type of the specification; a whole number may stand for a number.
ParamValue converted(const ParamSpec& spec, const ParamValue& value, const std::string& where) {
  switch (spec.type) {
    case ParamType::boolean:
      if (std::holds_alternative<bool>(value)) return value;
      break;
    case ParamType::integer:
      if (const auto* number = std::get_if<double>(&value); number && *number == std::floor(*number)) {
        check_range(spec, *number, where);
        return static_cast<long long>(*number);
      }
      if (const auto* whole = std::get_if<long long>(&value)) {
        check_range(spec, double(*whole), where);
        return value;
      }
      break;
    case ParamType::number: {
      const auto* whole = std::get_if<long long>(&value);
      const auto* number = std::get_if<double>(&value);
      if (!whole && !number) break;
      const double result = whole ? double(*whole) : *number;
      check_range(spec, result, where);
      return result;
    }
    case ParamType::text:
      if (std::holds_alternative<std::string>(value)) return value;
      break;
    case ParamType::choice:
      if (const auto* text = std::get_if<std::string>(&value)) {
        if (std::find(spec.choices.begin(), spec.choices.end(), *text) != spec.choices.end()) return value;
        throw Error(fmt::format("'{}' must be one of {}, not '{}'{}", spec.name, join(spec.choices, ", "),
                                *text, did_you_mean(*text, spec.choices)),
                    where);
      }
      break;
  }
  static const char* const kTypeNames[] = {"true or false", "a whole number", "a number", "a text", "a text"};
  throw Error(fmt::format("'{}' must be {}, not {}", spec.name, kTypeNames[static_cast<int>(spec.type)],
                          described(value)),
              where);
}

}  // namespace

ParamSpec boolean_param(std::string name, bool default_value, std::string doc) {
  return {std::move(name), ParamType::boolean, default_value, 0, 0, {}, std::move(doc)};
}

ParamSpec integer_param(std::string name, long long default_value, long long min, long long max,
                        std::string doc) {
  return {std::move(name), ParamType::integer, default_value, double(min), double(max), {}, std::move(doc)};
}

ParamSpec number_param(std::string name, double default_value, double min, double max, std::string doc) {
  return {std::move(name), ParamType::number, default_value, min, max, {}, std::move(doc)};
}

ParamSpec text_param(std::string name, std::string default_value, std::string doc) {
  return {std::move(name), ParamType::text, std::move(default_value), 0, 0, {}, std::move(doc)};
}

ParamSpec choice_param(std::string name, std::vector<std::string> choices, std::string doc) {
  std::string first = choices.front();
  return choice_param(std::move(name), std::move(choices), std::move(first), std::move(doc));
}

ParamSpec choice_param(std::string name, std::vector<std::string> choices, std::string default_value,
                       std::string doc) {
  assert(std::ranges::find(choices, default_value) != choices.end());
  return {std::move(name),    ParamType::choice, std::move(default_value), 0, 0,
          std::move(choices), std::move(doc)};
}

const ParamValue& ParamValues::at(const std::string& name) const {
  const auto found = values_.find(name);
  assert(found != values_.end());
  return found->second;
}

bool ParamValues::boolean(const std::string& name) const {
  return std::get<bool>(at(name));
}
int ParamValues::integer(const std::string& name) const {
  return int(std::get<long long>(at(name)));
}
double ParamValues::number(const std::string& name) const {
  return std::get<double>(at(name));
}
const std::string& ParamValues::text(const std::string& name) const {
  return std::get<std::string>(at(name));
}

ParamValues resolve_params(std::span<const ParamSpec> specs, std::span<const ParamPreset> presets,
                           const std::string& preset, const std::map<std::string, ParamValue>& given,
                           const std::string& where) {
  std::map<std::string, ParamValue> values;
  for (const auto& spec : specs) values[spec.name] = converted(spec, spec.default_value, spec.name);
  const auto apply = [&](const std::map<std::string, ParamValue>& source) {
    for (const auto& [name, value] : source) {
      const ParamSpec* spec = find_row(specs, name);
      if (!spec)
        throw Error(fmt::format("unknown parameter '{}'{}", name, did_you_mean(name, names_of(specs))),
                    where);
      values[name] = converted(*spec, value, where);
    }
  };
  if (!preset.empty()) {
    const ParamPreset* row = find_row(presets, preset);
    if (!row)
      throw Error(fmt::format("unknown preset '{}'{}", preset, did_you_mean(preset, names_of(presets))),
                  where);
    apply(row->values);
  }
  apply(given);
  return ParamValues(std::move(values));
}

ParamValue read_param(const ParamSpec& spec, const JsonValue& value) {
  if (value.is_boolean()) return converted(spec, value.boolean(), value.where());
  if (value.is_string()) return converted(spec, value.text(), value.where());
  return converted(spec, value.number(), value.where());
}

ParamValue parse_param(const ParamSpec& spec, const std::string& text, const std::string& where) {
  if (spec.type == ParamType::text || spec.type == ParamType::choice) return converted(spec, text, where);
  if (spec.type == ParamType::boolean) {
    if (text == "true" || text == "false") return text == "true";
    throw Error(fmt::format("'{}' must be true or false, not '{}'", spec.name, text), where);
  }
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size())
    throw Error(fmt::format("'{}' must be a number, not '{}'", spec.name, text), where);
  return converted(spec, number, where);
}

std::string to_text(const ParamValue& value) {
  return std::visit(
      [](const auto& v) -> std::string {
        if constexpr (std::is_same_v<std::decay_t<decltype(v)>, std::string>)
          return v;
        else
          return fmt::format("{}", v);
      },
      value);
}

std::string to_text(const ParamValues& values) {
  std::vector<std::string> parts;
  for (const auto& [name, value] : values.all()) parts.push_back(name + "=" + to_text(value));
  return join(parts, " ");
}

}  // namespace lightbench
