#include <algorithm>

#include <fmt/format.h>

#include "reports/escape.h"
#include "reports/formats/html_parts.h"
#include "reports/sequences.h"
#include "reports/value_text.h"

namespace lightbench {
namespace {

constexpr double kBarHeight = 24;
constexpr double kBarStep = 9;

/// A bar for the flicker of each frame; the highest one is `largest`.
std::string bars(const SequenceFacts& facts, double largest) {
  const double width = kBarStep * double(facts.by_frame.size());
  std::string svg = fmt::format(
      "<svg class=\"bars\" width=\"{0:.0f}\" height=\"{1:.0f}\" viewBox=\"0 0 {0:.0f} {1:.0f}\" role=\"img\" "
      "aria-label=\"flicker by frame\">",
      width, kBarHeight);
  for (std::size_t i = 0; i < facts.by_frame.size(); ++i) {
    const MetricValue& value = facts.by_frame[i];
    if (!value.value) continue;
    const double height = largest > 0 ? kBarHeight * *value.value / largest : 0;
    svg += fmt::format(
        "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\"><title>{}: {}</title></rect>",
        kBarStep * double(i) + 1, kBarHeight - height, kBarStep - 2, height,
        h(facts.sequence->frames[i].view), value_text(metric_or_plain("flicker"), value));
  }
  return svg + "</svg>";
}

double largest_flicker(const std::vector<SequenceFacts>& all, const ReportSequence* sequence) {
  double largest = 0;
  for (const SequenceFacts& facts : all)
    if (facts.sequence == sequence) largest = std::max(largest, facts.worst_flicker.value.value_or(0));
  return largest;
}

std::string table(const RunReport& report, const std::vector<SequenceFacts>& all) {
  std::string html =
      "<div class=\"scroll\"><table class=\"sortless\" id=\"sequence-table\"><thead><tr><th "
      "scope=\"col\">Sequence</th><th scope=\"col\">Variant</th>";
  if (report.references.size() > 1) html += "<th scope=\"col\">Against</th>";
  html += fmt::format(
      "<th scope=\"col\" class=\"number\">Frames</th><th scope=\"col\" class=\"number\">mean "
      "error<i>&nbsp;↓</i></th><th scope=\"col\" class=\"number\" title=\"{}\">flicker<i>&nbsp;↓</i></th>"
      "<th scope=\"col\" class=\"number\">worst</th><th scope=\"col\">flicker by frame</th></tr></thead>\n"
      "<tbody>\n",
      h(metric_or_plain("flicker").doc));
  for (const SequenceFacts& facts : all) {
    html += fmt::format("<tr><th scope=\"row\">{}<small>{}</small></th><td>{}</td>", h(facts.sequence->name),
                        h(facts.sequence->scene), h(facts.variant));
    if (report.references.size() > 1) html += "<td>" + h(facts.reference) + "</td>";
    html += fmt::format("<td class=\"number\">{}</td>", facts.sequence->frames.size()) +
            number_cell("mean_error", facts.mean_error, {}) + number_cell("flicker", facts.flicker, {}) +
            number_cell("flicker", facts.worst_flicker, {}) + "<td>" +
            bars(facts, largest_flicker(all, facts.sequence)) + "</td></tr>\n";
  }
  return html + "</tbody></table></div>\n";
}

/// The picture of a source in the first frame; the script shows the others.
std::string frame_picture(const RunReport& report, const ViewRows::View& view, const std::string& source) {
  const ReportImage* image = view.image(source);
  const std::string file =
      image && !image->png.empty() ? fmt::format(" src=\"{}\"", h(relative_url(image->png))) : "";
  return fmt::format(
      "<figure><img{} data-source=\"{}\" alt=\"{}\" width=\"{}\" height=\"{}\" "
      "loading=\"lazy\"><figcaption>{}</figcaption></figure>",
      file, h(source), h(source), std::max(1, report.width), std::max(1, report.height), h(source));
}

std::string film(const RunReport& report, const ViewRows& rows, const ReportSequence& sequence,
                 std::size_t index) {
  if (sequence.frames.empty()) return "";
  const ViewRows::View* first = rows.find(sequence.scene, sequence.frames.front().view);
  if (!first) return "";
  std::string html = fmt::format(
      "<div class=\"film\" data-sequence=\"{}\"><h3>{}</h3>\n<form class=\"toolbar\" hidden><button "
      "type=\"button\">Play</button><input type=\"range\" min=\"0\" max=\"{}\" value=\"0\" "
      "aria-label=\"Frame\">"
      "<label><input type=\"checkbox\">Heat maps</label><output></output></form>\n<div class=\"frames\">",
      index, h(sequence.scene + "/" + sequence.name), sequence.frames.size() - 1);
  if (!report.primary_reference.empty()) html += frame_picture(report, *first, report.primary_reference);
  for (const ReportImageSource& variant : report.variants)
    html += frame_picture(report, *first, variant.name);
  return html + "</div></div>\n";
}

}  // namespace

std::string html_sequences(const RunReport& report, const ViewRows& rows) {
  if (report.sequences.empty()) return "";
  std::string html = "<section id=\"sequences\"><h2>Sequences</h2>\n";
  const std::vector<SequenceFacts> all = sequence_facts(report);
  if (!all.empty())
    html += table(report, all) +
            "<p class=\"note\">Flicker is how much the error changes from the frame before, so the first "
            "frame has none.</p>\n";
  for (std::size_t i = 0; i < report.sequences.size(); ++i)
    html += film(report, rows, report.sequences[i], i);
  return html + "</section>\n";
}

}  // namespace lightbench
