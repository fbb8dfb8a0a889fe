#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "reports/formats/html_page.h"
#include "reports/run_report.h"

/// The sections of index.html; private to the HTML format.
namespace lightbench {

extern const char kReportJs[];

/// The run by view, in the order of the job.
struct ViewRows {
  struct View {
    std::string scene;
    std::string name;
    std::map<std::string, const ReportImage*> images;                          ///< by source
    std::map<std::pair<std::string, std::string>, const ReportScore*> scores;  ///< by variant, reference

    std::string title() const { return scene + "/" + name; }
    const ReportImage* image(const std::string& source) const;
    const ReportScore* score(const std::string& variant, const std::string& reference) const;
  };
  std::vector<View> views;

  explicit ViewRows(const RunReport& report);
  const View* find(const std::string& scene, const std::string& name) const;  ///< null where there is none
};

/// Means per variant and reference, with the distribution of the leading metric over the views.
std::string html_summary(const RunReport& report, const ViewRows& rows);
/// The sequences: numbers of each variant, and a film to step through; empty where there are none.
std::string html_sequences(const RunReport& report, const ViewRows& rows);
std::string html_gates(const RunReport& report);
/// Failed tasks and warnings; empty where there are none.
std::string html_problems(const RunReport& report);
/// The pictures: a row for each view and reference, a column for each variant.
std::string html_pictures(const RunReport& report, const ViewRows& rows);
/// All numbers: a row for each view, variant and reference.
std::string html_scores(const RunReport& report, const ViewRows& rows);
/// What baked and compressed objects cost: a table for each scene and the variants that share them; empty
/// where there are none.
std::string html_objects(const RunReport& report);
/// Variants, references, scenes, credits, tools, and what the metrics mean.
std::string html_about(const RunReport& report);
/// What the script needs to know, as JSON for a <script> element.
std::string html_data(const RunReport& report, const ViewRows& rows);

/// A <td> with a number: the text, its tooltip, and the value that sorting uses. `ceiling` stands beside a
/// gain.
std::string number_cell(const std::string& metric, const MetricValue& value, const MetricValue& ceiling);

}  // namespace lightbench
