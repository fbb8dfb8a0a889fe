#include "reports/line_chart.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "reports/escape.h"

namespace lightbench {
namespace {

constexpr double kWidth = 640, kHeight = 300;
constexpr double kLeft = 60, kRight = 190, kTop = 30, kBottom = 44;
constexpr double kLabelHeight = 15;
constexpr int kMostTicks = 8;

/// Okabe and Ito's colours, which the colour-blind tell apart, but for black and yellow.
constexpr std::array kColors{"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9"};

/// An axis from 0 to `most`.
struct Axis {
  double most;
  double from, to;  // in the picture

  double at(double value) const { return from + value / most * (to - from); }
};

/// 1, 2 or 5 times a power of ten.
double tick_step(double most) {
  const double least = most / kMostTicks, power = std::pow(10, std::floor(std::log10(least)));
  for (const double digit : {1, 2, 5})
    if (digit * power >= least) return digit * power;
  return 10 * power;
}

/// From 0 to the end of the axis.
std::vector<double> ticks(const Axis& axis) {
  const double step = tick_step(axis.most);
  std::vector<double> values;
  for (int i = 0; i * step <= 1.0001 * axis.most; ++i) values.push_back(i * step);
  return values;
}

std::string text(double x, double y, const char* anchor, const std::string& what) {
  return fmt::format(R"(<text x="{:.1f}" y="{:.1f}" text-anchor="{}">{}</text>)", x, y, anchor,
                     escape_markup(what));
}

std::string frame(const ChartTexts& texts, const Axis& x, const Axis& y) {
  std::string svg;
  for (const double value : ticks(y))
    svg += fmt::format(R"(<line class="grid" x1="{:.1f}" y1="{:.1f}" x2="{:.1f}" y2="{:.1f}"/>)", x.from,
                       y.at(value), x.to, y.at(value)) +
           text(x.from - 8, y.at(value) + 4, "end", fmt::format("{:g}", value));
  for (const double value : ticks(x))
    svg += text(x.at(value), y.from + 16, "middle", fmt::format("{:g}", value));
  return svg + text((x.from + x.to) / 2, kHeight - 8, "middle", texts.x_axis) +
         text(8, kTop - 14, "start", texts.y_axis);
}

std::string picture(const ChartTexts& texts, const std::string& inside) {
  return fmt::format(
             R"(<svg class="lines" xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {} {}" role="img" )"
             R"(aria-label="{}"><style>.lines text{{font:12px system-ui,sans-serif;fill:#667080}})"
             R"(.lines .grid{{stroke:#8884}}.lines polyline{{fill:none;stroke-width:2}}.lines rect{{fill:#0072b2}}</style>)",
             kWidth, kHeight, escape_markup(texts.title)) +
         inside + "</svg>\n";
}

/// Baselines of labels that want to stand at `wanted`, each below the one before it.
std::vector<double> settled(const std::vector<double>& wanted) {
  std::vector<std::size_t> order(wanted.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return wanted[a] < wanted[b]; });
  // From the bottom up, since lines that lie close together mostly lie low.
  std::vector<double> places(wanted.size());
  double below = kHeight - kBottom + 2 * kLabelHeight;
  for (auto i = order.rbegin(); i != order.rend(); ++i)
    below = places[*i] = std::min(wanted[*i], below - kLabelHeight);
  return places;
}

}  // namespace

std::string line_chart(const ChartTexts& texts, const std::vector<ChartLine>& lines) {
  Axis x{0, kLeft, kWidth - kRight}, y{0, kHeight - kBottom, kTop};
  std::vector<double> ends;
  for (const ChartLine& line : lines)
    for (const auto& [at, value] : line.points)
      x.most = std::max(x.most, at), y.most = std::max(y.most, value);
  if (!(x.most > 0) || !(y.most > 0)) return "";
  for (const ChartLine& line : lines)
    ends.push_back(line.points.empty() ? kTop : y.at(line.points.back().second) + 4);
  const std::vector<double> labels = settled(ends);
  std::string svg = frame(texts, x, y);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (lines[i].points.empty()) continue;
    const char* color = kColors[i % kColors.size()];
    svg += fmt::format(R"(<polyline stroke="{}" points=")", color);
    for (const auto& [at, value] : lines[i].points)
      svg += fmt::format("{:.1f},{:.1f} ", x.at(at), y.at(value));
    svg +=
        fmt::format(R"("/><text x="{:.1f}" y="{:.1f}" style="fill:{}">{}</text>)",
                    x.at(lines[i].points.back().first) + 8, labels[i], color, escape_markup(lines[i].name));
  }
  return picture(texts, svg);
}

std::string bar_chart(const ChartTexts& texts, const std::vector<double>& values) {
  const double most = values.empty() ? 0 : *std::max_element(values.begin(), values.end());
  if (!(most > 0)) return "";
  const Axis x{double(values.size()), kLeft, kWidth - kRight}, y{most, kHeight - kBottom, kTop};
  std::string svg = frame(texts, x, y);
  for (std::size_t i = 0; i < values.size(); ++i)
    if (values[i] > 0)
      svg += fmt::format(R"(<rect x="{:.2f}" y="{:.2f}" width="{:.2f}" height="{:.2f}"/>)", x.at(double(i)),
                         y.at(values[i]), 0.9 * (x.at(1) - x.at(0)), y.from - y.at(values[i]));
  return picture(texts, svg);
}

}  // namespace lightbench
