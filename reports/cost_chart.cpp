#include "reports/cost_chart.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "reports/escape.h"
#include "reports/value_text.h"

namespace lightbench {
namespace {

constexpr std::size_t kFewest = 3;
constexpr std::size_t kMostNames = 20;  // more would leave the picture
constexpr double kWidth = 880, kHeight = 420;
constexpr double kLeft = 56, kRight = 170, kTop = 30, kBottom = 44;
constexpr double kLabelHeight = 15, kCharacter = 7;
// What is worse than that stands at the lower edge. No gain is above 100 %, but a file may say so.
constexpr double kLowestGain = -100, kHighestGain = 100;

/// Where values lie in the picture.
struct Axes {
  double low_log, high_log;  // of the time, base 10
  double low_gain, high_gain;

  double x(double seconds) const {
    return kLeft + (std::log10(seconds) - low_log) / (high_log - low_log) * (kWidth - kLeft - kRight);
  }
  double y(double gain) const {
    const double share = (std::clamp(gain, low_gain, high_gain) - low_gain) / (high_gain - low_gain);
    return kHeight - kBottom - share * (kHeight - kTop - kBottom);
  }
};

Axes axes_of(const std::vector<CostPoint>& points) {
  const auto [low, high] = std::minmax_element(points.begin(), points.end(),
                                               [](const auto& a, const auto& b) { return a.gain < b.gain; });
  Axes axes{std::log10(points.front().seconds) - 0.1, std::log10(points.back().seconds) + 0.1, 0, 0};
  const double most = std::clamp(high->gain, 0.0, kHighestGain);
  axes.low_gain = std::floor(std::clamp(low->gain, kLowestGain, 0.0) / 10) * 10;
  axes.high_gain = std::max(std::ceil(most / 10) * 10, axes.low_gain + 10);
  return axes;
}

std::string line(double x1, double y1, double x2, double y2, const char* kind) {
  return fmt::format(R"(<line class="{}" x1="{:.1f}" y1="{:.1f}" x2="{:.1f}" y2="{:.1f}"/>)", kind, x1, y1,
                     x2, y2);
}

std::string text(double x, double y, const char* anchor, const std::string& what) {
  return fmt::format(R"(<text x="{:.1f}" y="{:.1f}" text-anchor="{}">{}</text>)", x, y, anchor,
                     escape_markup(what));
}

std::string grid(const Axes& axes) {
  std::string svg;
  const int step = axes.high_gain - axes.low_gain > 100 ? 20 : 10;
  for (int gain = int(axes.low_gain); gain <= int(axes.high_gain); gain += step)
    svg += line(kLeft, axes.y(gain), kWidth - kRight, axes.y(gain), gain == 0 ? "zero" : "grid") +
           text(kLeft - 8, axes.y(gain) + 4, "end", std::to_string(gain));
  for (int power = int(std::floor(axes.low_log)); power <= int(axes.high_log); ++power)
    for (const double digit : {1, 2, 5}) {
      const double seconds = digit * std::pow(10, power);
      if (std::log10(seconds) < axes.low_log || std::log10(seconds) > axes.high_log) continue;
      svg += line(axes.x(seconds), kTop, axes.x(seconds), kHeight - kBottom, "grid") +
             text(axes.x(seconds), kHeight - kBottom + 16, "middle", duration_text(seconds));
    }
  return svg +
         text((kLeft + kWidth - kRight) / 2, kHeight - 8, "middle", "mean processor time of a picture") +
         text(kLeft, kTop - 14, "end", "gain %");
}

/// A label's place: from `left` to `right`, on the baseline `y`.
struct Label {
  double left, right, y;

  bool meets(const Label& other) const {
    return left < other.right && other.left < right && std::abs(y - other.y) < kLabelHeight - 0.5;
  }
};

/// Moved down until it leaves the others alone; each move is by more than what still meets.
Label settled(Label label, const std::vector<Label>& others) {
  for (std::size_t i = 0; i < others.size(); ++i)
    if (label.meets(others[i])) label.y = others[i].y + kLabelHeight, i = std::size_t(-1);
  return label;
}

/// A point, and its name where it is on the front or there is no front.
std::string marks(const std::vector<CostPoint>& points, const Axes& axes) {
  const bool has_front = std::ranges::any_of(points, &CostPoint::front);
  const bool all_named = !has_front && points.size() <= kMostNames;
  std::string svg;
  std::vector<Label> labels;
  for (auto point = points.rbegin(); point != points.rend(); ++point) {
    const double x = axes.x(point->seconds), y = axes.y(point->gain);
    svg += fmt::format(
        R"(<circle class="{}" cx="{:.1f}" cy="{:.1f}" r="{}"><title>{}: {:.1f} %, {}</title></circle>)",
        point->front ? "front" : "other", x, y, point->front ? 5 : 3.5, escape_markup(point->variant),
        point->gain, duration_text(point->seconds));
    if (!point->front && !all_named) continue;
    const std::string name = shortened(clean_utf8(point->variant), 28);
    const double left = x + 9;
    labels.push_back(settled({left, left + kCharacter * double(display_width(name)), y + 4}, labels));
    svg += text(left, labels.back().y, "start", name);
  }
  return svg;
}

constexpr const char* kStyle =
    "<style>.cost text{font:12px system-ui,sans-serif;fill:#667080}.cost .grid{stroke:#8884;stroke-width:1}"
    ".cost .zero{stroke:#888;stroke-width:1.5}.cost .front{fill:#2457c5}.cost .other{fill:#8887}</style>";

}  // namespace

double mean_cpu_seconds(const RunReport& report, const std::string& variant) {
  double sum = 0;
  int count = 0;
  for (const ReportImage& image : report.images)
    if (!image.is_reference && image.source == variant && image.cpu_seconds > 0)
      sum += image.cpu_seconds, ++count;
  return count == 0 ? 0 : sum / count;
}

bool has_contended_costs(const RunReport& report) {
  return std::ranges::any_of(report.images, [&](const ReportImage& image) {
    return !image.is_reference && image.source != report.baseline && image.cpu_seconds > 0 && image.contended;
  });
}

std::vector<CostPoint> cost_points(const RunReport& report) {
  std::vector<CostPoint> points;
  for (const ReportImageSource& variant : report.variants) {
    if (variant.name == report.baseline) continue;
    const double seconds = mean_cpu_seconds(report, variant.name);
    const MeanValue gain = mean_metric(report, "gain", variant.name, report.primary_reference);
    if (seconds > 0 && std::isfinite(seconds) && gain.mean.value && std::isfinite(*gain.mean.value))
      points.push_back({variant.name, seconds, *gain.mean.value});
  }
  std::stable_sort(points.begin(), points.end(),
                   [](const auto& a, const auto& b) { return a.seconds < b.seconds; });
  if (has_contended_costs(report)) return points;
  double best = -HUGE_VAL;
  for (CostPoint& point : points) {
    point.front = point.gain > best;
    best = std::max(best, point.gain);
  }
  return points;
}

std::string cost_chart(const RunReport& report) {
  const std::vector<CostPoint> points = cost_points(report);
  if (points.size() < kFewest) return "";
  const Axes axes = axes_of(points);
  return fmt::format(R"(<svg class="cost" xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {} {}" role="img" )"
                     R"(aria-label="Mean gain over processor time">)",
                     kWidth, kHeight) +
         kStyle + grid(axes) + marks(points, axes) + "</svg>\n";
}

}  // namespace lightbench
