#include "reports/slicing_report.h"

#include <algorithm>
#include <map>
#include <optional>

#include <fmt/format.h>

#include "reports/escape.h"
#include "reports/formats/html_page.h"
#include "reports/line_chart.h"

namespace lightbench {
namespace {

constexpr std::size_t kFewestInChart = 3;

/// Rows of text, as Markdown and as HTML.
struct Table {
  std::size_t names = 0;  ///< columns at the left that are not numbers
  std::vector<std::string> head;
  std::vector<std::vector<std::string>> rows;
};

std::string markdown(const Table& table) {
  const auto line = [&](const std::vector<std::string>& cells) {
    std::string text = "|";
    for (std::size_t i = 0; i < cells.size(); ++i)
      text += " " + (i < table.names ? escape_markdown(cells[i]) : cells[i]) + " |";
    return text + "\n";
  };
  std::string text = line(table.head) + "|";
  for (std::size_t i = 0; i < table.head.size(); ++i) text += i < table.names ? " :-- |" : " --: |";
  text += "\n";
  for (const auto& row : table.rows) text += line(row);
  return text;
}

std::string html(const Table& table) {
  const auto line = [&](const std::vector<std::string>& cells, const char* tag) {
    std::string text = "<tr>";
    for (std::size_t i = 0; i < cells.size(); ++i)
      text += fmt::format("<{0}{1}>{2}</{0}>", tag, i < table.names ? "" : " class=\"number\"", h(cells[i]));
    return text + "</tr>\n";
  };
  std::string text =
      "<div class=\"scroll\"><table>\n<thead>" + line(table.head, "th") + "</thead>\n<tbody>\n";
  for (const auto& row : table.rows) text += line(row, "td");
  return text + "</tbody></table></div>\n";
}

std::optional<double> median_of(const SlicingTimes& times, const std::string& method) {
  for (const MethodTime& time : times.methods)
    if (time.method == method) return time.median;
  return std::nullopt;
}

std::optional<double> ratio_of(const SlicingTimes& times, const MethodRatio& ratio) {
  const auto over = median_of(times, ratio.over), under = median_of(times, ratio.under);
  if (!over || !under || *under <= 0) return std::nullopt;
  return *over / *under;
}

std::string milliseconds(double value) {
  return value < 10 ? fmt::format("{:.1f}", value) : fmt::format("{:.0f}", value);
}

/// Those of which both methods were timed.
std::vector<MethodRatio> ratios_of(const SlicingReport& report) {
  const SlicingTimes& times = report.receivers.front().times.front();
  std::vector<MethodRatio> ratios;
  for (const MethodRatio& ratio : slicing_ratios())
    if (ratio_of(times, ratio)) ratios.push_back(ratio);
  return ratios;
}

std::vector<std::string> heading(const SlicingReport& report) {
  std::vector<std::string> head{"planes", "used"};
  for (const MethodTime& time : report.receivers.front().times.front().methods) head.push_back(time.method);
  for (const MethodRatio& ratio : ratios_of(report)) head.emplace_back(ratio.name);
  head.emplace_back("texels that differ");
  return head;
}

std::vector<std::string> numbers(const SlicingReport& report, const SlicingTimes& times) {
  std::vector<std::string> cells{std::to_string(times.planes), std::to_string(times.used)};
  for (const MethodTime& time : times.methods) cells.push_back(milliseconds(time.median));
  for (const MethodRatio& ratio : ratios_of(report)) {
    const auto value = ratio_of(times, ratio);
    cells.push_back(value ? fmt::format("{:.2f}", *value) : "-");
  }
  cells.push_back(std::to_string(times.differing));
  return cells;
}

Table by_receiver(const SlicingReport& report) {
  Table table{3, {"scene", "receiver", "light"}, {}};
  for (std::string& cell : heading(report)) table.head.push_back(std::move(cell));
  for (const SlicedReceiver& receiver : report.receivers)
    for (const SlicingTimes& times : receiver.times) {
      std::vector<std::string> row{receiver.scene, receiver.receiver, receiver.light};
      for (std::string& cell : numbers(report, times)) row.push_back(std::move(cell));
      table.rows.push_back(std::move(row));
    }
  return table;
}

/// A mean and its extremes.
struct Spread {
  double sum = 0, least = 0, most = 0;
  int count = 0;

  void add(double value) {
    least = count == 0 ? value : std::min(least, value);
    most = count == 0 ? value : std::max(most, value);
    sum += value;
    ++count;
  }
  std::string text(const char* format) const {
    if (count == 0) return "-";
    const auto one = [&](double value) { return fmt::format(fmt::runtime(format), value); };
    return fmt::format("{} ({} to {})", one(sum / count), one(least), one(most));
  }
};

/// Over all receivers, by the number of planes.
Table means(const SlicingReport& report) {
  std::map<int, std::vector<const SlicingTimes*>> groups;
  for (const SlicedReceiver& receiver : report.receivers)
    for (const SlicingTimes& times : receiver.times) groups[times.planes].push_back(&times);
  Table table{0, heading(report), {}};
  for (const auto& [planes, group] : groups) {
    std::vector<std::string> row{std::to_string(planes)};
    Spread used;
    for (const SlicingTimes* times : group) used.add(times->used);
    row.push_back(used.text("{:.0f}"));
    for (const MethodTime& method : group.front()->methods) {
      Spread spread;
      for (const SlicingTimes* times : group)
        if (const auto median = median_of(*times, method.method)) spread.add(*median);
      row.push_back(spread.text("{:.1f}"));
    }
    for (const MethodRatio& ratio : ratios_of(report)) {
      Spread spread;
      for (const SlicingTimes* times : group)
        if (const auto value = ratio_of(*times, ratio)) spread.add(*value);
      row.push_back(spread.text("{:.2f}"));
    }
    std::size_t differing = 0;
    for (const SlicingTimes* times : group) differing = std::max(differing, times->differing);
    row.push_back(std::to_string(differing));
    table.rows.push_back(std::move(row));
  }
  return table;
}

/// How far the quartiles lie from the medians, as a share of them.
std::string spread_text(const SlicingReport& report) {
  std::vector<double> shares;
  for (const SlicedReceiver& receiver : report.receivers)
    for (const SlicingTimes& times : receiver.times)
      for (const MethodTime& time : times.methods)
        if (time.median > 0)
          shares.push_back(std::max(time.median - time.lower, time.upper - time.median) / time.median);
  if (shares.empty()) return "";
  std::sort(shares.begin(), shares.end());
  const auto at = [&](double part) { return 100 * shares[std::size_t(part * double(shares.size() - 1))]; };
  return fmt::format(
      "Half of the quartiles are within {:.0f} % of their median, nine of ten within {:.0f} %, all within "
      "{:.0f} %.",
      at(0.5), at(0.9), at(1));
}

std::string about(const SlicingReport& report) {
  const std::string rounds = report.rounds > 1
                                 ? fmt::format("Medians of {} rounds in which the methods take turns, {}. {}",
                                               report.rounds, report.renderer, spread_text(report))
                                 : fmt::format("One round, after one to warm up, {}.", report.renderer);
  return fmt::format(
             "Milliseconds for one receiver's maps: the position map, of {}, and the map of caustics. ",
             report.layers > 1 ? "two layers" : "one layer") +
         rounds;
}

std::string chart_of(const SlicedReceiver& receiver, const std::string& title,
                     const std::vector<std::string>& methods) {
  std::vector<ChartLine> lines;
  for (const std::string& method : methods) {
    ChartLine line{method, {}};
    for (const SlicingTimes& times : receiver.times)
      if (const auto median = median_of(times, method)) line.points.emplace_back(times.planes, *median);
    if (!line.points.empty()) lines.push_back(std::move(line));
  }
  return line_chart({title, "planes", "ms"}, lines);
}

std::string charts(const SlicedReceiver& receiver) {
  const std::string name = fmt::format("{}: {}, {}", receiver.scene, receiver.receiver, receiver.light);
  std::vector<double> texels(receiver.texels_by_plane.begin(), receiver.texels_by_plane.end());
  return "<h3>" + h(name) + "</h3>\n<div class=\"charts\">\n" +
         chart_of(receiver, name + ": methods",
                  {"volumetric", "volumetric, clusters", "level map, discard", "level map, all planes",
                   "level map", "hit"}) +
         chart_of(receiver, name + ": slicing",
                  {"level map, all planes", "level map, read back", "level map, smart", "level map", "hit"}) +
         bar_chart({name + ": depths", "plane", "texels"}, texels) + "</div>\n";
}

std::string page(const SlicingReport& report) {
  std::string text = html_page_start("Planes of caustics") +
                     "<header class=\"top\"><div class=\"brand\">lightbench</div><h1>Planes of "
                     "caustics</h1></header>\n<main>\n";
  text += "<section><h2>Means</h2>\n<p>" + h(about(report)) + "</p>\n" + html(means(report)) + "</section>\n";
  std::string pictures;
  for (const SlicedReceiver& receiver : report.receivers)
    if (receiver.times.size() >= kFewestInChart) pictures += charts(receiver);
  if (!pictures.empty()) text += "<section><h2>Receivers</h2>\n" + pictures + "</section>\n";
  return text + "<section><h2>All numbers</h2>\n" + html(by_receiver(report)) +
         "</section>\n</main>\n</body>\n</html>\n";
}

}  // namespace

const std::vector<MethodRatio>& slicing_ratios() {
  static const std::vector<MethodRatio> ratios{
      {"volumetric : all planes", "volumetric", "level map, all planes"},
      {"clusters : all planes", "volumetric, clusters", "level map, all planes"},
      {"volumetric : discard", "volumetric", "level map, discard"},
      {"all planes : smart", "level map, all planes", "level map, smart"},
      {"all planes : level map", "level map, all planes", "level map"},
      {"all planes : hit", "level map, all planes", "hit"},
      {"all planes : hit, no split", "level map, all planes", "hit, no split"},
  };
  return ratios;
}

std::vector<ReportFile> slicing_files(const SlicingReport& report) {
  if (report.receivers.empty()) return {};
  const std::string text = "# Planes of caustics\n\n" + about(report) +
                           "\n\nMeans over the receivers, and the least and the most:\n\n" +
                           markdown(means(report)) + "\nOf each receiver:\n\n" +
                           markdown(by_receiver(report));
  return {{"slicing.md", text}, {"index.html", page(report)}};
}

}  // namespace lightbench
