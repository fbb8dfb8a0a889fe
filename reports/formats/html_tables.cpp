#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "reports/ceiling.h"
#include "reports/cost_chart.h"
#include "reports/escape.h"
#include "reports/formats/html_parts.h"
#include "reports/reference_facts.h"
#include "reports/shared_warnings.h"
#include "reports/value_text.h"

namespace lightbench {
namespace {

/// The common scale of the dots of all rows.
struct Scale {
  double low = 0, high = 0;  ///< always contains 0
  static constexpr double kWidth = 200, kMargin = 8;

  double x(double value) const {
    const double part = high > low ? (value - low) / (high - low) : 0.5;
    return kMargin + part * (kWidth - 2 * kMargin);
  }
};

Scale scale_of(const RunReport& report, const std::string& metric) {
  Scale scale;
  for (const ReportScore& score : report.scores) {
    const MetricValue value = metric_of(score, metric);
    if (!value.value || !std::isfinite(*value.value)) continue;
    scale.low = std::min(scale.low, *value.value);
    scale.high = std::max(scale.high, *value.value);
  }
  return scale;
}

/// A dot for each view, a line at 0 and a thick one at the mean.
std::string dots(const RunReport& report, const Scale& scale, const Metric& metric,
                 const std::string& variant, const std::string& reference) {
  std::string svg = fmt::format(
      "<svg class=\"dots\" width=\"{0:.0f}\" height=\"26\" viewBox=\"0 0 {0:.0f} 26\" role=\"img\" "
      "aria-label=\"{1} by view\"><line class=\"zero\" x1=\"{2:.1f}\" x2=\"{2:.1f}\" y1=\"2\" y2=\"24\"/>",
      Scale::kWidth, h(metric.name), scale.x(0));
  for (const ReportScore* score : worst_first(report, metric.name, variant, reference)) {
    const MetricValue value = metric_of(*score, metric.name);
    if (!value.value) continue;
    svg += fmt::format("<circle cx=\"{:.1f}\" cy=\"13\" r=\"4\"><title>{}: {}</title></circle>",
                       scale.x(*value.value), h(score->scene + "/" + score->view), value_text(metric, value));
  }
  const MeanValue mean = mean_metric(report, metric.name, variant, reference);
  if (mean.mean.value)
    svg += fmt::format(
        "<line class=\"mean\" x1=\"{0:.1f}\" x2=\"{0:.1f}\" y1=\"4\" y2=\"22\"><title>mean "
        "{1}</title></line>",
        scale.x(*mean.mean.value), value_text(metric, mean.mean));
  return svg + "</svg>";
}

std::string metric_head(const Metric& metric, bool sortable) {
  const char* arrow = metric.better == Better::higher  ? "&nbsp;↑"
                      : metric.better == Better::lower ? "&nbsp;↓"
                                                       : "";
  const std::string meaning = metric.doc + (metric.better == Better::higher  ? " (higher is better)"
                                            : metric.better == Better::lower ? " (lower is better)"
                                                                             : "");
  std::string heading = metric_heading(metric);
  std::ranges::replace(heading, '_', ' ');  // so that it can be broken in two lines
  const std::string text = h(heading) + fmt::format("<i>{}</i>", arrow);
  return fmt::format("<th scope=\"col\" class=\"number\" title=\"{}\">{}</th>", h(meaning),
                     sortable ? "<button type=\"button\">" + text + "</button>" : text);
}

std::string means_row(const RunReport& report, const Scale& scale, const std::string& leading,
                      const ReportImageSource& variant, const ReportImageSource& reference) {
  const auto scores = worst_first(report, leading, variant.name, reference.name);
  const auto failed = std::ranges::count(scores, Outcome::failed, &ReportScore::outcome);
  std::string row = fmt::format("<tr><th scope=\"row\">{}{}<small>{}</small></th>", h(variant.name),
                                variant.name == report.baseline ? " <span class=\"tag\">baseline</span>" : "",
                                h(variant.kind));
  if (report.references.size() > 1) row += "<td>" + h(reference.name) + "</td>";
  row += fmt::format("<td class=\"number\">{}{}</td>", measured_text(scores),
                     failed > 0 ? fmt::format(" <span class=\"bad\">{} failed</span>", failed) : "");
  if (!leading.empty())
    row += "<td>" + dots(report, scale, metric_or_plain(leading), variant.name, reference.name) + "</td>";
  for (const std::string& name : report.metric_names) {
    const MeanValue mean = mean_metric(report, name, variant.name, reference.name);
    std::string note;
    if (mean.undefined > 0 && mean.count > 0)
      note = fmt::format("<small title=\"{} without a value\">of {}</small>", counted(mean.undefined, "view"),
                         mean.count);
    std::string cell = number_cell(name, mean.mean, mean_ceiling(report, reference.name));
    row += note.empty() ? cell : cell.insert(cell.size() - 5, note);
  }
  return row + "</tr>\n";
}

std::string score_row(const RunReport& report, const ViewRows::View& view, std::size_t index,
                      const ReportScore& score) {
  std::string row = fmt::format(
      "<tr data-view=\"{}\" data-source=\"{}\" data-reference=\"{}\"><th scope=\"row\" data-v=\"{}\">"
      "<a href=\"#v{}\">{}</a></th><td data-v=\"{}\">{}</td><td data-v=\"{}\">{}</td>",
      index, h(score.variant), h(score.reference), h(view.title()), index, h(view.title()), h(score.variant),
      h(score.variant), h(score.reference), h(score.reference));
  if (score.outcome != Outcome::ok) {
    row += fmt::format("<td colspan=\"{}\" class=\"{}\">{}</td>", report.metric_names.size() + 1,
                       score.outcome == Outcome::failed ? "bad" : "dim",
                       h((score.outcome == Outcome::failed ? "failed: " : "skipped: ") +
                         shortened(clean_utf8(score.error), 200)));
    return row + "</tr>\n";
  }
  const MetricValue ceiling = ceiling_of(report, score);
  for (const std::string& name : report.metric_names)
    row += number_cell(name, metric_of(score, name), ceiling);
  const ReportImage* image = view.image(score.variant);
  row += image && image->outcome == Outcome::ok && image->seconds > 0
             ? fmt::format("<td class=\"number\" data-v=\"{:.6g}\">{}{}</td>", image->seconds,
                           image->contended ? "≈ " : "", duration_text(image->seconds))
             : "<td class=\"number dim\">–</td>";
  return row + "</tr>\n";
}

struct GateLook {
  const char* css;
  const char* text;
};
/// In the order of GateState.
constexpr GateLook kGateLooks[] = {
    {"good", "✓ met"}, {"bad", "✗ not met"}, {"warn", "≈ within noise"}, {"warn", "? not judged"}};

std::string optional_number(const std::optional<double>& value, double factor, int decimals) {
  return value ? fmt::format("<td class=\"number\">{:.{}f}</td>", factor * *value, decimals)
               : "<td class=\"number dim\">–</td>";
}

/// How exact each reference is; only where something is known of it.
std::string reference_table(const RunReport& report) {
  const std::vector<ReferenceFacts> all = reference_facts(report);
  std::string notes;
  for (const std::string& line : bounces_lines(report)) notes += "<p class=\"note\">" + h(line) + "</p>\n";
  if (std::ranges::none_of(all, [](const ReferenceFacts& f) { return f.noise || f.light_share; }))
    return notes;
  std::string html =
      "<h3>How exact the references are</h3>\n<div class=\"scroll\"><table class=\"sortless\" "
      "id=\"exactness\"><thead><tr><th scope=\"col\">Reference</th><th scope=\"col\" "
      "class=\"number\">Bounces</th><th scope=\"col\" class=\"number\" title=\"Estimated mean error of the "
      "image, of 255, mean over the views\">Noise</th><th scope=\"col\" class=\"number\">Worst</th>"
      "<th scope=\"col\" class=\"number\" title=\"Luminance as a share of the reference with the most "
      "bounces\">Light %</th><th scope=\"col\" class=\"number\">Time a view</th></tr></thead>\n<tbody>\n";
  for (const ReferenceFacts& facts : all)
    html += fmt::format(
        "<tr><th scope=\"row\">{}<small>{}</small></th><td class=\"number\">{}</td>{}{}{}<td "
        "class=\"number\">{}</td></tr>\n",
        h(facts.name), h(facts.kind), facts.bounces, optional_number(facts.noise, 1, 3),
        optional_number(facts.worst_noise, 1, 3), optional_number(facts.light_share, 100, 1),
        facts.views > 0 ? duration_text(facts.seconds) : "–");
  return html + "</tbody></table></div>\n" + notes;
}

std::string list_of(const std::vector<std::string>& items, const char* classes) {
  std::string html = fmt::format("<ul class=\"{}\">", classes);
  for (const std::string& item : items) html += "<li>" + item + "</li>";
  return html + "</ul>\n";
}

}  // namespace

const ReportImage* ViewRows::View::image(const std::string& source) const {
  const auto found = images.find(source);
  return found == images.end() ? nullptr : found->second;
}

const ReportScore* ViewRows::View::score(const std::string& variant, const std::string& reference) const {
  const auto found = scores.find({variant, reference});
  return found == scores.end() ? nullptr : found->second;
}

ViewRows::ViewRows(const RunReport& report) {
  std::map<std::pair<std::string, std::string>, std::size_t> index;
  const auto view_of = [&](const std::string& scene, const std::string& view) -> View& {
    const auto [position, added] = index.try_emplace({scene, view}, views.size());
    if (added) views.push_back({.scene = scene, .name = view, .images = {}, .scores = {}});
    return views[position->second];
  };
  for (const ReportImage& image : report.images)
    view_of(image.scene, image.view).images[image.source] = &image;
  for (const ReportScore& score : report.scores)
    view_of(score.scene, score.view).scores[{score.variant, score.reference}] = &score;
}

const ViewRows::View* ViewRows::find(const std::string& scene, const std::string& name) const {
  const auto found =
      std::ranges::find_if(views, [&](const View& view) { return view.scene == scene && view.name == name; });
  return found == views.end() ? nullptr : &*found;
}

std::string number_cell(const std::string& metric, const MetricValue& value, const MetricValue& ceiling) {
  if (!value.value)
    return fmt::format("<td class=\"number dim\" title=\"{}\">–</td>", h(value.undefined_because));
  const bool is_gain = metric == "gain";
  const char* sign = !is_gain ? "" : *value.value > 0 ? " good" : *value.value < 0 ? " bad" : "";
  return fmt::format("<td class=\"number{}\" data-v=\"{:.9g}\">{}</td>", sign, *value.value,
                     is_gain ? gain_text(value, ceiling) : value_text(metric_or_plain(metric), value));
}

namespace {

std::string cost_figure(const RunReport& report) {
  const std::string chart = cost_chart(report);
  if (chart.empty()) return "";
  return "<figure class=\"chart\">" + chart + "<figcaption class=\"note\">Gain and cost of the variants. " +
         (has_contended_costs(report)
              ? "Other tasks ran at the same time, so these times do not tell which variant is the better "
                "bargain; <code>lightbench run JOB --jobs 1</code> into a new folder measures each picture "
                "alone."
              : "Those with a name gain more than all that take less processor time.") +
         "</figcaption></figure>\n";
}

}  // namespace

std::string html_summary(const RunReport& report, const ViewRows&) {
  if (report.scores.empty())
    return "<section id=\"summary\"><h2>Summary</h2><p>This run has no scores.</p></section>\n";
  const std::string leading = leading_metric(report);
  const Scale scale = scale_of(report, leading);
  std::string html =
      "<section id=\"summary\"><h2>Summary</h2>\n<div class=\"scroll\"><table class=\"sortless\"><thead><tr>"
      "<th scope=\"col\">Variant</th>";
  if (report.references.size() > 1) html += "<th scope=\"col\">Against</th>";
  html += "<th scope=\"col\" class=\"number\">Views</th>";
  if (!leading.empty())
    html += fmt::format(
        "<th scope=\"col\" title=\"One dot for each view; the thick line is the mean\">{} by view"
        "<small class=\"range\"><span>{}</span><span>{}</span></small></th>",
        h(leading), value_text(metric_or_plain(leading), MetricValue::of(scale.low)),
        value_text(metric_or_plain(leading), MetricValue::of(scale.high)));
  for (const std::string& name : report.metric_names) html += metric_head(metric_or_plain(name), false);
  html += "</tr></thead>\n<tbody>\n";
  for (const ReportImageSource& variant : report.variants)
    for (const ReportImageSource& reference : report.references)
      html += means_row(report, scale, leading, variant, reference);
  html +=
      "</tbody></table></div>\n<p class=\"note\">Means over the views. ↓ lower is better, ↑ higher is "
      "better.";
  if (std::ranges::any_of(report.references, [&](const auto& r) { return ceiling_variant(report, r.name); }))
    html += " Beside a gain stands its ceiling: what a path-traced image with the reference's bounces gains.";
  return html + "</p>\n" + cost_figure(report) + reference_table(report) + "</section>\n";
}

std::string html_gates(const RunReport& report) {
  if (report.gates.empty()) return "";
  std::string html =
      "<section id=\"gates\"><h2>Gates</h2>\n<div class=\"scroll\"><table "
      "class=\"sortless\"><thead><tr><th></th>"
      "<th scope=\"col\">Rule</th><th scope=\"col\">Found</th></tr></thead>\n<tbody>\n";
  for (const ReportGate& gate : report.gates)
    html += fmt::format("<tr><td class=\"state {}\">{}</td><td><code>{}</code></td><td>{}</td></tr>\n",
                        kGateLooks[std::size_t(gate.state)].css, kGateLooks[std::size_t(gate.state)].text,
                        h(gate.text), h(gate.detail));
  return html + "</tbody></table></div></section>\n";
}

std::string html_problems(const RunReport& report) {
  std::vector<std::string> failed, warnings;
  const auto add = [](std::vector<std::string>& list, const std::string& who, const std::string& what) {
    list.push_back(fmt::format("<b>{}</b> {}", h(who), h(what)));
  };
  for (const FailedTask& task : failed_tasks(report)) add(failed, task.where + " " + task.what, task.error);
  for (const SharedWarning& warning : shared_warnings(report))
    add(warnings, about_text(warning), warning.text);
  if (failed.empty() && warnings.empty()) return "";
  std::string html = "<section id=\"problems\"><h2>Problems</h2>\n";
  if (!failed.empty())
    html += fmt::format("<h3 class=\"bad\">{} failed</h3>\n", counted(failed.size(), "task")) +
            list_of(failed, "failed");
  if (!warnings.empty())
    html += fmt::format("<details{}><summary>{}</summary>\n", warnings.size() <= 5 ? " open" : "",
                        counted(warnings.size(), "warning")) +
            list_of(warnings, "warnings") + "</details>\n";
  return html + "</section>\n";
}

std::string html_scores(const RunReport& report, const ViewRows& rows) {
  if (report.scores.empty()) return "";
  std::string html =
      "<section id=\"scores\"><h2>Scores</h2>\n<form class=\"toolbar\" id=\"score-tools\" "
      "hidden><label>Filter "
      "<input type=\"search\" id=\"score-filter\" placeholder=\"view, variant or reference\"></label>"
      "<output id=\"score-count\"></output></form>\n<div class=\"scroll\"><table id=\"score-table\" "
      "class=\"scores\"><thead><tr><th scope=\"col\"><button type=\"button\">View</button></th><th "
      "scope=\"col\">"
      "<button type=\"button\">Variant</button></th><th scope=\"col\"><button "
      "type=\"button\">Against</button></th>";
  for (const std::string& name : report.metric_names) html += metric_head(metric_or_plain(name), true);
  html +=
      "<th scope=\"col\" class=\"number\"><button type=\"button\">time</button></th></tr></thead>\n<tbody>\n";
  for (std::size_t i = 0; i < rows.views.size(); ++i)
    for (const ReportImageSource& variant : report.variants)
      for (const ReportImageSource& reference : report.references)
        if (const ReportScore* score = rows.views[i].score(variant.name, reference.name))
          html += score_row(report, rows.views[i], i, *score);
  return html + "</tbody></table></div></section>\n";
}

}  // namespace lightbench
