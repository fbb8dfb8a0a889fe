#include <fmt/format.h>

#include "reports/formats/html_parts.h"
#include "reports/value_text.h"

namespace lightbench {
namespace {

std::string section(const char* title, const std::string& body) {
  return body.empty() ? "" : fmt::format("<h3>{}</h3>\n{}\n", title, body);
}

std::string sources(const std::vector<ReportImageSource>& all) {
  std::string rows;
  for (const ReportImageSource& source : all) {
    std::string params;
    for (const auto& [name, value] : source.params)
      params += fmt::format("<span class=\"param\"><i>{}</i> {}</span> ", h(name), h(value));
    rows += fmt::format(
        "<tr><th scope=\"row\">{}</th><td>{}</td><td class=\"number\">{}</td><td>{}</td><td>{}</td></tr>\n",
        h(source.name), h(source.kind), source.bounces, params, h(source.tool));
  }
  if (rows.empty()) return "";
  return "<div class=\"scroll\"><table class=\"sortless\"><thead><tr><th scope=\"col\">Name</th><th "
         "scope=\"col\">Kind</th><th scope=\"col\" class=\"number\">Bounces</th><th "
         "scope=\"col\">Parameters</th>"
         "<th scope=\"col\">Made by</th></tr></thead><tbody>\n" +
         rows + "</tbody></table></div>";
}

std::string scenes(const RunReport& report) {
  std::string rows;
  for (const ReportScene& scene : report.scenes)
    rows += fmt::format(
        "<tr><th scope=\"row\">{}</th><td><code>{}</code></td><td class=\"number\">{}</td></tr>\n",
        h(scene.name), h(scene.file), scene.triangles);
  if (rows.empty()) return "";
  return "<div class=\"scroll\"><table class=\"sortless\"><thead><tr><th scope=\"col\">Scene</th><th "
         "scope=\"col\">File</th><th scope=\"col\" class=\"number\">Triangles</th></tr></thead><tbody>\n" +
         rows + "</tbody></table></div>";
}

std::string credits(const RunReport& report) {
  std::string rows;
  for (const ReportScene& scene : report.scenes)
    for (const ReportCredit& credit : scene.credits)
      rows += fmt::format("<tr><td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>\n", h(scene.name),
                          h(credit.piece), h(credit.creator), h(credit.license));
  if (rows.empty()) return "";
  return "<div class=\"scroll\"><table class=\"sortless\"><thead><tr><th scope=\"col\">Scene</th><th "
         "scope=\"col\">Piece</th><th scope=\"col\">Creator</th><th "
         "scope=\"col\">Licence</th></tr></thead><tbody>\n" +
         rows + "</tbody></table></div>";
}

std::string tools(const RunReport& report) {
  std::string rows;
  for (const auto& [name, version] : report.tools)
    rows += fmt::format("<div><dt>{}</dt><dd>{}</dd></div>", h(name), h(version));
  return rows.empty() ? "" : "<dl class=\"facts\">" + rows + "</dl>";
}

std::string glossary(const RunReport& report) {
  std::string rows;
  for (const std::string& name : report.metric_names) {
    const Metric metric = metric_or_plain(name);
    const char* better = metric.better == Better::higher  ? "Higher is better."
                         : metric.better == Better::lower ? "Lower is better."
                                                          : "";
    rows += fmt::format("<div><dt>{}</dt><dd>{}{}{}{} {}</dd></div>", h(name), h(metric.doc),
                        metric.unit == "of 255" ? ", " : "", metric.unit == "of 255" ? h(metric.unit) : "",
                        metric.doc.empty() ? "" : ".", better);
  }
  return rows.empty() ? "" : "<dl class=\"glossary\">" + rows + "</dl>";
}

}  // namespace

std::string html_about(const RunReport& report) {
  return "<section id=\"about\"><h2>About this run</h2>\n" +
         section("What the numbers mean", glossary(report)) + section("Variants", sources(report.variants)) +
         section("References", sources(report.references)) + section("Scenes", scenes(report)) +
         section("Credits and licences", credits(report)) + section("Tools", tools(report)) +
         "<p class=\"note\">The same run for programs: <a href=\"run.json\">run.json</a>, "
         "<a href=\"junit.xml\">junit.xml</a>, <a href=\"summary.md\">summary.md</a>.</p></section>\n";
}

}  // namespace lightbench
