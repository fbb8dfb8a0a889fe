#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "reports/ceiling.h"
#include "reports/escape.h"
#include "reports/formats/html_parts.h"
#include "reports/value_text.h"

namespace lightbench {
namespace {

using View = ViewRows::View;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The numbers below a picture.
constexpr const char* kCaptionMetrics[] = {"mean_error", "gain", "pearson"};

std::string time_text(const ReportImage& image) {
  if (image.seconds == 0) return "";
  std::string text = duration_text(image.seconds);
  if (image.cached) return text + ", earlier run";
  if (image.contended) text = "≈ " + text;
  return text;
}

std::string time_title(const ReportImage& image) {
  if (image.seconds == 0) return "";
  std::string title = image.contended ? "Other tasks ran at the same time: not a measurement." : "";
  const auto add = [&](const std::string& line) { title += (title.empty() ? "" : "\n") + line; };
  for (const PassSeconds& pass : image.passes) add(pass.name + ": " + duration_text(pass.seconds));
  if (image.cpu_seconds > 0) add("processor time: " + duration_text(image.cpu_seconds));
  for (const auto& [name, rate] : image.ray_rates)
    add(fmt::format("{} rays: {:.1f} million a second", name, rate / 1e6));
  return title;
}

std::string file_links(const ReportImage& image) {
  std::string links;
  const auto add = [&](const std::string& file, const std::string& text) {
    if (!file.empty()) links += fmt::format(" <a href=\"{}\">{}</a>", h(relative_url(file)), h(text));
  };
  add(image.exr, "EXR");
  add(image.pov, "POV");
  for (const auto& [name, file] : image.buffers) add(file, name);
  return links.empty() ? "" : "<span class=\"files\">" + links + "</span>";
}

std::string attribute(const char* name, const std::string& file) {
  return file.empty() ? "" : fmt::format(" data-{}=\"{}\"", name, h(relative_url(file)));
}

/// A picture that opens the viewer; the link alone shows the file.
std::string picture(const RunReport& report, const View& view, const ReportImage& image,
                    const ReportScore* score) {
  const std::string url = h(relative_url(image.png));
  std::string data = attribute("image", image.png);
  if (score)
    data += attribute("difference", score->difference_png) + attribute("heat", score->heat_png) +
            attribute("change", score->baseline_difference_png);
  return fmt::format(
      "<a class=\"picture\" href=\"{0}\" data-source=\"{1}\"><img src=\"{0}\"{2} alt=\"{1}, {3}\" "
      "width=\"{4}\" "
      "height=\"{5}\" loading=\"lazy\" decoding=\"async\"></a>",
      url, h(image.source), data, h(view.title()), std::max(1, report.width), std::max(1, report.height));
}

std::string broken(const char* kind, const std::string& what, const std::string& error) {
  return fmt::format("<div class=\"broken {}\"><b>{}</b><span>{}</span></div>", kind, h(what),
                     h(shortened(clean_utf8(error), 400)));
}

std::string picture_or_error(const RunReport& report, const View& view, const std::string& source,
                             const ReportScore* score) {
  const ReportImage* image = view.image(source);
  if (!image) return broken("skipped", "not made", "");
  if (image->outcome == Outcome::failed) return broken("failed", "failed", image->error);
  if (image->outcome == Outcome::skipped) return broken("skipped", "skipped", image->error);
  if (image->png.empty()) return broken("skipped", "no picture", "");
  return picture(report, view, *image, score);
}

std::string time_caption(const View& view, const std::string& source) {
  const ReportImage* image = view.image(source);
  if (!image || image->outcome != Outcome::ok) return "";
  return fmt::format("<div class=\"made\"><span class=\"time\" title=\"{}\">{}</span>{}</div>",
                     h(time_title(*image)), h(time_text(*image)), file_links(*image));
}

bool has_metric(const RunReport& report, const std::string& name) {
  return std::ranges::find(report.metric_names, name) != report.metric_names.end();
}

std::string sign_class(const std::string& metric, const MetricValue& value) {
  if (metric != "gain" || !value.value) return "";
  return *value.value > 0 ? " good" : *value.value < 0 ? " bad" : "";
}

std::string score_caption(const RunReport& report, const ReportScore* score) {
  if (!score) return "";
  if (score->outcome == Outcome::failed)
    return fmt::format("<span class=\"bad\" title=\"{}\">score failed</span>", h(score->error));
  std::string text;
  for (const char* name : kCaptionMetrics) {
    if (!has_metric(report, name)) continue;
    const MetricValue value = metric_of(*score, name);
    const Metric metric = metric_or_plain(name);
    text += fmt::format("<span class=\"number{}\" title=\"{}\"><i>{}</i> {}</span>", sign_class(name, value),
                        h(value.value ? metric.doc : value.undefined_because), h(metric_heading(metric)),
                        h(metric.name == "gain" && value.value ? gain_text(value, ceiling_of(report, *score))
                                                               : value_text(metric, value, "–")));
  }
  for (const std::string& warning : score->warnings)
    text += fmt::format("<span class=\"warn\" title=\"{}\">warning</span>", h(warning));
  return text;
}

/// The variants with the smallest mean error of a row; none where it is not known of two at least.
std::vector<std::string> best_variants(const RunReport& report, const View& view,
                                       const std::string& reference) {
  std::vector<std::string> best;
  double smallest = kInfinity;
  std::size_t known = 0;
  for (const ReportImageSource& variant : report.variants) {
    if (variant.offline) continue;  // it is there to show what is left to win
    const ReportScore* score = view.score(variant.name, reference);
    const MetricValue error = score ? metric_of(*score, "mean_error") : MetricValue::undefined("");
    if (!error.value) continue;
    ++known;
    if (*error.value < smallest) best.clear();
    if (*error.value <= smallest) best.push_back(variant.name);
    smallest = std::min(smallest, *error.value);
  }
  return known > 1 ? best : std::vector<std::string>();
}

std::string variant_cell(const RunReport& report, const View& view, const std::string& variant,
                         const std::string& reference, bool best) {
  const ReportScore* score = reference.empty() ? nullptr : view.score(variant, reference);
  return fmt::format("<td{}>{}<div class=\"caption\">{}{}</div></td>", best ? " class=\"best\"" : "",
                     picture_or_error(report, view, variant, score), score_caption(report, score),
                     time_caption(view, variant));
}

/// Numbers that the row can be sorted by: the worst gain and the largest error of its variants.
std::string sort_keys(const RunReport& report, const View& view, const std::string& reference) {
  double gain = kInfinity, error = -kInfinity;
  for (const ReportImageSource& variant : report.variants) {
    const ReportScore* score = view.score(variant.name, reference);
    if (!score || variant.name == report.baseline) continue;
    if (const MetricValue value = metric_of(*score, "gain"); value.value) gain = std::min(gain, *value.value);
    if (const MetricValue value = metric_of(*score, "mean_error"); value.value)
      error = std::max(error, *value.value);
  }
  std::string keys;
  if (std::isfinite(gain)) keys += fmt::format(" data-gain=\"{:.6g}\"", gain);
  if (std::isfinite(error)) keys += fmt::format(" data-error=\"{:.6g}\"", error);
  return keys;
}

std::string noise_caption(const View& view, const std::string& reference) {
  const ReportImage* image = view.image(reference);
  if (!image || !image->noise) return "";
  return fmt::format(
      "<span class=\"number\" title=\"estimated mean error of this reference, of 255\"><i>noise</i> ±{:.3f}"
      "</span>",
      *image->noise);
}

std::string picture_row(const RunReport& report, const View& view, std::size_t index,
                        const std::string& reference, bool first_of_view) {
  std::string row = fmt::format(
      "<tr data-view=\"{}\" data-reference=\"{}\" data-name=\"{}\"{}{}><th scope=\"row\"><div class=\"view\">"
      "<a href=\"#v{}\"><small>{}</small>{}</a></div>",
      index, h(reference), h(view.title()), sort_keys(report, view, reference),
      first_of_view ? fmt::format(" id=\"v{}\"", index) : "", index, h(view.scene), h(view.name));
  if (!reference.empty())
    row += picture_or_error(report, view, reference, nullptr) +
           "<div class=\"caption\"><span class=\"number\"><i>" + h(reference) + "</i></span>" +
           noise_caption(view, reference) + time_caption(view, reference) + "</div>";
  row += "</th>";
  const std::vector<std::string> best = best_variants(report, view, reference);
  for (const ReportImageSource& variant : report.variants)
    row += variant_cell(report, view, variant.name, reference,
                        std::ranges::find(best, variant.name) != best.end());
  return row + "</tr>\n";
}

std::string toolbar(const RunReport& report) {
  const bool changes = std::ranges::any_of(
      report.scores, [](const ReportScore& score) { return !score.baseline_difference_png.empty(); });
  return fmt::format(
      "<form class=\"toolbar\" id=\"picture-tools\" hidden>"
      "<label>Filter <input type=\"search\" id=\"picture-filter\" placeholder=\"scene or view\"></label>"
      "<fieldset class=\"choice\" aria-label=\"Show\">"
      "<label><input type=\"radio\" name=\"show\" value=\"image\" checked>Pictures</label>"
      "<label><input type=\"radio\" name=\"show\" value=\"difference\">Difference</label>"
      "<label><input type=\"radio\" name=\"show\" value=\"heat\">Heat map</label>{}</fieldset>"
      "<label>Sort <select id=\"picture-sort\"><option value=\"\">as in the job</option>"
      "<option value=\"name\">by name</option><option value=\"gain\">lowest gain first</option>"
      "<option value=\"error\">largest error first</option></select></label>"
      "<label>Size <input type=\"range\" id=\"picture-size\" min=\"140\" max=\"640\" step=\"1\"></label>"
      "<output id=\"picture-count\"></output></form>\n",
      changes ? "<label><input type=\"radio\" name=\"show\" value=\"change\">Against baseline</label>" : "");
}

std::vector<std::string> reference_names(const RunReport& report) {
  std::vector<std::string> names;
  for (const ReportImageSource& reference : report.references) names.push_back(reference.name);
  std::stable_partition(names.begin(), names.end(),
                        [&](const std::string& name) { return name == report.primary_reference; });
  if (names.empty()) names.emplace_back();
  return names;
}

}  // namespace

std::string html_pictures(const RunReport& report, const ViewRows& rows) {
  std::string heading;
  for (const ReportImageSource& variant : report.variants)
    heading += fmt::format("<th scope=\"col\">{}<small>{}</small></th>", h(variant.name),
                           h(variant.name == report.baseline ? variant.kind + ", baseline" : variant.kind));
  std::string html = "<section id=\"pictures\"><h2>Pictures</h2>\n" + toolbar(report);
  html += fmt::format(
      "<div class=\"scroll\"><table class=\"pictures\" id=\"picture-table\" "
      "style=\"--columns:{}\"><thead><tr>"
      "<th scope=\"col\">View and reference</th>{}</tr></thead>\n<tbody>\n",
      report.variants.size() + 1, heading);
  for (std::size_t i = 0; i < rows.views.size(); ++i) {
    bool first = true;
    for (const std::string& reference : reference_names(report)) {
      html += picture_row(report, rows.views[i], i, reference, first);
      first = false;
    }
  }
  html +=
      "</tbody></table></div>\n<p class=\"note\">≈ marks times met while other tasks ran at the same time; "
      "<code>lightbench bench</code> measures. A picture opens the viewer: slide, flip, zoom.</p>\n";
  return html + "</section>\n";
}

}  // namespace lightbench
