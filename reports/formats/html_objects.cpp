#include <fmt/format.h>

#include "reports/escape.h"
#include "reports/formats/html_parts.h"
#include "reports/object_tables.h"

namespace lightbench {
namespace {

std::string row(const ObjectTable& table, const ObjectRow& object) {
  std::string html = fmt::format("<tr><th scope=\"row\">{}</th>", h(object.object));
  if (!object.problem.empty())
    return html + fmt::format("<td colspan=\"{}\" class=\"bad\">{}</td></tr>\n", table.columns.size(),
                              h(shortened(clean_utf8(object.problem), 200)));
  for (const std::string& cell : object.cells)
    html += fmt::format("<td class=\"number\">{}</td>", cell == "-" ? "–" : h(cell));
  return html + "</tr>\n";
}

std::string table_of(const ObjectTable& table) {
  std::string html = fmt::format(
      "<h4>{} <small>{}</small></h4>\n<div class=\"scroll\"><table class=\"sortless\"><thead><tr>"
      "<th scope=\"col\">Object</th>",
      h(table.variants), h(table.scene));
  for (const ObjectColumn& column : table.columns)
    html += fmt::format("<th scope=\"col\" class=\"number\" title=\"{}\">{}</th>", h(column.doc),
                        h(column.heading));
  html += "</tr></thead>\n<tbody>\n";
  for (const ObjectRow& object : table.rows) html += row(table, object);
  return html + "</tbody>\n<tfoot>" + row(table, table.whole) + "</tfoot></table></div>\n";
}

std::string part(const char* title, const std::vector<ObjectTable>& tables, const char* note) {
  if (tables.empty()) return "";
  std::string html = fmt::format("<h3>{}</h3>\n", title);
  for (const ObjectTable& table : tables) html += table_of(table);
  return html + fmt::format("<p class=\"note\">{}</p>\n", note);
}

}  // namespace

std::string html_objects(const RunReport& report) {
  if (report.bakes.empty() && report.compressions.empty()) return "";
  return "<section id=\"objects\"><h2>Baked objects</h2>\n" + part("Bakes", bake_tables(report), kBakeNote) +
         part("Compression", compression_tables(report), kCompressionNote) + "</section>\n";
}

}  // namespace lightbench
