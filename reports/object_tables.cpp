#include "reports/object_tables.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <span>

#include <fmt/format.h>

#include "reports/value_text.h"

namespace lightbench {
namespace {

/// One, or all of a scene that have numbers: then they are summed up.
using Objects = std::span<const ReportObject* const>;
using Number = std::optional<double>;

struct Column {
  ObjectColumn about;
  std::function<std::string(Objects)> text;
};

constexpr double kMegabyte = 1e6;
const std::string kBytesOf = "bytes.";

Number number(const ReportObject& object, const std::string& name) {
  const auto found = object.numbers.find(name);
  return found == object.numbers.end() ? std::nullopt : found->second.value;
}

/// Over all; none where one of them is not known.
Number sum(Objects objects, const std::function<Number(const ReportObject&)>& of) {
  double total = 0;
  for (const ReportObject* object : objects) {
    const Number value = of(*object);
    if (!value) return std::nullopt;
    total += *value;
  }
  return total;
}

Number sum(Objects objects, const std::string& name) {
  return sum(objects, [&](const ReportObject& object) { return number(object, name); });
}

Number product(Number a, Number b) {
  return a && b ? Number(*a * *b) : std::nullopt;
}

Number quotient(Number a, Number b) {
  return a && b && *b > 0 ? Number(*a / *b) : std::nullopt;
}

Number largest(Objects objects, const std::string& name) {
  Number result;
  for (const ReportObject* object : objects) {
    const Number value = number(*object, name);
    if (!value) return std::nullopt;
    result = std::max(result.value_or(*value), *value);
  }
  return result;
}

/// The one value that all have.
Number common(Objects objects, const std::string& name) {
  const Number most = largest(objects, name);
  const auto same = [&](const ReportObject* object) { return number(*object, name) == most; };
  return std::ranges::all_of(objects, same) ? most : std::nullopt;
}

Number cpu_seconds(Objects objects) {
  return sum(objects, [](const ReportObject& object) {
    return object.cpu_seconds > 0 ? Number(object.cpu_seconds) : std::nullopt;
  });
}

Number radiance_samples(Objects objects) {
  return sum(objects, [](const ReportObject& object) {
    return product(number(object, "texels"), number(object, "directions"));
  });
}

/// The mean over texels.
Number noise(Objects objects) {
  const Number total = sum(
      objects, [](const ReportObject& object) { return product(object.noise, number(object, "texels")); });
  return quotient(total, sum(objects, "texels"));
}

Number file_bytes(Objects objects) {
  return sum(objects, [](const ReportObject& object) {
    Number total;
    for (const auto& [name, value] : object.numbers)
      if (name.starts_with(kBytesOf)) {
        if (!value.value) return Number();
        total = total.value_or(0) + *value.value;
      }
    return total;
  });
}

/// Of all values: each has three bytes.
Number changed_share(Objects objects) {
  return quotient(product(sum(objects, "changed_values"), 3), sum(objects, "raw_bytes"));
}

Number mean_changed_error(Objects objects) {
  const Number total = sum(objects, [](const ReportObject& object) {
    return product(number(object, "mean_changed_error"), number(object, "changed_values"));
  });
  const Number changed = sum(objects, "changed_values");
  return changed == 0 ? 0 : quotient(total, changed);
}

std::string shown(Number value, int decimals, double factor = 1) {
  return value ? fmt::format("{:.{}f}", factor * *value, decimals) : "-";
}

std::string texture_size(Objects objects) {
  if (objects.size() != 1) return "-";
  const Number width = number(*objects[0], "width"), height = number(*objects[0], "height");
  return width && height ? fmt::format("{:.0f}x{:.0f}", *width, *height) : "-";
}

const Column kTextureSize{{"texture", "Width and height of a layer, in texels"}, texture_size};
const Column kDirections{{"directions", "Of each texel"},
                         [](Objects all) { return shown(common(all, "directions"), 0); }};

std::vector<Column> bake_columns(Objects) {
  return {
      kTextureSize,
      {{"texels", "That were traced, on one side"}, [](Objects all) { return shown(sum(all, "texels"), 0); }},
      kDirections,
      {{"CPU s", "Seconds of processor time"}, [](Objects all) { return shown(cpu_seconds(all), 2); }},
      {{"texels/s", "In a second of processor time"},
       [](Objects all) { return shown(quotient(sum(all, "texels"), cpu_seconds(all)), 0); }},
      {{"million radiance samples/s", "Texels times directions, in a second of processor time"},
       [](Objects all) { return shown(quotient(radiance_samples(all), cpu_seconds(all)), 2, 1e-6); }},
      {{"noise of 255", "Estimated mean error of the indirect light, over the texels"},
       [](Objects all) { return shown(noise(all), 2); }},
  };
}

/// One for each file that any of the objects has.
std::vector<Column> file_columns(Objects objects) {
  std::set<std::string> names;
  for (const ReportObject* object : objects)
    for (const auto& [name, value] : object->numbers)
      if (name.starts_with(kBytesOf)) names.insert(name);
  std::vector<Column> columns;
  for (const std::string& name : names)
    columns.push_back({{name.substr(kBytesOf.size()) + " MB", "Size of this file, in millions of bytes"},
                       [name](Objects all) { return shown(sum(all, name), 3, 1 / kMegabyte); }});
  return columns;
}

std::vector<Column> compression_columns(Objects objects) {
  std::vector<Column> columns{
      kTextureSize,
      {{"texels", "That hold radiance, those of gutters and of a back that is kept included"},
       [](Objects all) { return shown(sum(all, "texels"), 0); }},
      kDirections,
      {{"raw MB", "Three bytes for each texel in each direction, in millions of bytes"},
       [](Objects all) { return shown(sum(all, "raw_bytes"), 2, 1 / kMegabyte); }},
  };
  std::ranges::move(file_columns(objects), std::back_inserter(columns));
  const std::vector<Column> rest{
      {{"ratio", "Raw bytes over those of the files"},
       [](Objects all) { return shown(quotient(sum(all, "raw_bytes"), file_bytes(all)), 1); }},
      {{"changed %", "Share of values, texels in one direction, that are not decoded as they were"},
       [](Objects all) { return shown(changed_share(all), 1, 100); }},
      {{"mean error", "Over the changed values, of 255; of the scene: weighted by how many those are"},
       [](Objects all) { return shown(mean_changed_error(all), 2); }},
      {{"99 %", "The error that 99 % of all values do not exceed, of 255; of the scene: the worst object's"},
       [](Objects all) { return shown(largest(all, "error_99"), 2); }},
      {{"max", "The largest error of a value, the mean over its components, of 255"},
       [](Objects all) { return shown(largest(all, "max_error"), 2); }},
      {{"max of a component", "The largest error of a single component, of 255"},
       [](Objects all) { return shown(largest(all, "max_component_error"), 0); }},
      {{"colours", "Distinct ones before compression"},
       [](Objects all) { return all.size() == 1 ? shown(number(*all[0], "colors"), 0) : "-"; }},
  };
  columns.insert(columns.end(), rest.begin(), rest.end());
  return columns;
}

std::vector<std::string> cells_of(const std::vector<Column>& columns, Objects objects) {
  std::vector<std::string> cells;
  for (const Column& column : columns) cells.push_back(objects.empty() ? "-" : column.text(objects));
  return cells;
}

std::string problem_of(const ReportObject& object) {
  if (object.outcome == Outcome::ok) return "";
  const std::string what = object.outcome == Outcome::failed ? "failed" : "skipped";
  return object.error.empty() ? what : what + ": " + object.error;
}

/// The objects of one table, in their order.
using Group = std::vector<const ReportObject*>;

std::vector<Group> groups_of(const std::vector<ReportObject>& objects) {
  std::vector<Group> groups;
  std::map<std::pair<std::string, std::vector<std::string>>, std::size_t> index;
  for (const ReportObject& object : objects) {
    const auto [place, added] = index.try_emplace({object.scene, object.variants}, groups.size());
    if (added) groups.emplace_back();
    groups[place->second].push_back(&object);
  }
  return groups;
}

Group with_numbers(const Group& group) {
  Group found;
  std::ranges::copy_if(group, std::back_inserter(found),
                       [](const ReportObject* object) { return object->outcome == Outcome::ok; });
  return found;
}

std::string count_text(const Group& group, const Group& known) {
  const std::string all = counted(group.size(), "object");
  return known.size() == group.size() ? all : fmt::format("{} of {}", known.size(), all);
}

std::vector<ObjectTable> tables_of(const std::vector<ReportObject>& objects,
                                   std::vector<Column> (*columns_for)(Objects)) {
  std::vector<ObjectTable> tables;
  for (const Group& group : groups_of(objects)) {
    const Group known = with_numbers(group);
    const std::vector<Column> columns = columns_for(known);
    ObjectTable table{group[0]->scene, variants_text(*group[0]), {}, {}, {}};
    for (const Column& column : columns) table.columns.push_back(column.about);
    for (const ReportObject* object : group)
      table.rows.push_back({object->object, problem_of(*object), cells_of(columns, std::span(&object, 1))});
    table.whole = {"whole scene", "", cells_of(columns, known)};
    if (known.size() < group.size()) table.whole.object += fmt::format(" ({})", count_text(group, known));
    tables.push_back(std::move(table));
  }
  return tables;
}

/// "baked office (raw; piecewise): 4 objects"
std::string line_start(const char* what, const Group& group, const Group& known) {
  return fmt::format("{} {} ({}): {}", what, group[0]->scene, variants_text(*group[0]),
                     count_text(group, known));
}

}  // namespace

std::vector<ObjectTable> bake_tables(const RunReport& report) {
  return tables_of(report.bakes, bake_columns);
}

std::vector<ObjectTable> compression_tables(const RunReport& report) {
  return tables_of(report.compressions, compression_columns);
}

std::vector<std::string> object_lines(const RunReport& report) {
  std::vector<std::string> lines;
  for (const Group& group : groups_of(report.bakes)) {
    const Group known = with_numbers(group);
    lines.push_back(line_start("baked", group, known));
    if (!known.empty())
      lines.back() += fmt::format(", {} texels, {} million radiance samples, {} s of processor time",
                                  shown(sum(known, "texels"), 0), shown(radiance_samples(known), 1, 1e-6),
                                  shown(cpu_seconds(known), 1));
  }
  for (const Group& group : groups_of(report.compressions)) {
    const Group known = with_numbers(group);
    lines.push_back(line_start("compressed", group, known));
    if (!known.empty())
      lines.back() += fmt::format(", {} MB to {} MB ({} : 1), mean error {} where changed, at most {} of 255",
                                  shown(sum(known, "raw_bytes"), 1, 1 / kMegabyte),
                                  shown(file_bytes(known), 2, 1 / kMegabyte),
                                  shown(quotient(sum(known, "raw_bytes"), file_bytes(known)), 1),
                                  shown(mean_changed_error(known), 2), shown(largest(known, "max_error"), 2));
  }
  return lines;
}

}  // namespace lightbench
