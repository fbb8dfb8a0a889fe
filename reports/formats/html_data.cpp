#include <nlohmann/json.hpp>

#include "reports/escape.h"
#include "reports/formats/html_parts.h"
#include "reports/sequences.h"
#include "reports/value_text.h"

namespace lightbench {
namespace {

using Json = nlohmann::ordered_json;

/// A picture that the viewer can show: `of` is the image source it is about, `against` what it is compared
/// with.
Json picture(const std::string& label, const char* kind, const std::string& file, const std::string& of,
             const std::string& against) {
  // Cleaned like the page's attributes, which the script compares with these.
  return {{"label", clean_utf8(label)},
          {"kind", kind},
          {"src", relative_url(file)},
          {"of", clean_utf8(of)},
          {"against", clean_utf8(against)}};
}

void add_sources(Json& pictures, const ViewRows::View& view, const std::vector<ReportImageSource>& sources,
                 const char* kind) {
  for (const ReportImageSource& source : sources) {
    const ReportImage* image = view.image(source.name);
    if (image && image->outcome == Outcome::ok && !image->png.empty())
      pictures.push_back(picture(source.name, kind, image->png, source.name, ""));
  }
}

void add_differences(Json& pictures, const ReportScore& score) {
  const std::string& variant = score.variant;
  const std::string pair = variant + " against " + score.reference;
  if (!score.difference_png.empty())
    pictures.push_back(
        picture("Difference: " + pair, "difference", score.difference_png, variant, score.reference));
  if (!score.heat_png.empty())
    pictures.push_back(picture("Heat map: " + pair, "heat", score.heat_png, variant, score.reference));
  if (!score.baseline_difference_png.empty())
    pictures.push_back(picture("Difference: " + variant + " against the baseline", "change",
                               score.baseline_difference_png, variant, ""));
}

/// [[heading, text], ...] of all metrics.
Json numbers(const RunReport& report, const ReportScore& score) {
  Json values = Json::array();
  for (const std::string& name : report.metric_names) {
    const Metric metric = metric_or_plain(name);
    values.push_back(
        Json::array({clean_utf8(metric_heading(metric)), value_text(metric, metric_of(score, name), "–")}));
  }
  return values;
}

Json view_data(const RunReport& report, const ViewRows::View& view) {
  Json pictures = Json::array(), scores = Json::object();
  add_sources(pictures, view, report.references, "reference");
  add_sources(pictures, view, report.variants, "variant");
  for (const ReportImageSource& variant : report.variants) {
    for (const ReportImageSource& reference : report.references) {
      const ReportScore* score = view.score(variant.name, reference.name);
      if (!score) continue;
      add_differences(pictures, *score);
      scores[clean_utf8(variant.name)][clean_utf8(reference.name)] = numbers(report, *score);
    }
  }
  return {{"name", clean_utf8(view.title())}, {"pictures", pictures}, {"scores", scores}};
}

/// The frames as indices of views, and how fast they follow one another.
Json sequence_data(const ReportSequence& sequence, const ViewRows& rows) {
  Json frames = Json::array();
  for (const ReportFrame& frame : sequence.frames)
    if (const ViewRows::View* view = rows.find(sequence.scene, frame.view))
      frames.push_back(view - rows.views.data());
  return {{"rate", frame_rate(sequence)}, {"frames", frames}};
}

}  // namespace

std::string html_data(const RunReport& report, const ViewRows& rows) {
  Json views = Json::array();
  for (const ViewRows::View& view : rows.views) views.push_back(view_data(report, view));
  Json data = {{"width", report.width},
               {"height", report.height},
               {"reference", clean_utf8(report.primary_reference)},
               {"views", views}};
  for (const ReportSequence& sequence : report.sequences)
    data["sequences"].push_back(sequence_data(sequence, rows));
  return escape_json_for_script(data.dump());
}

}  // namespace lightbench
