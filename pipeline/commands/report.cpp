#include <filesystem>

#include <CLI/CLI.hpp>

#include "base/files.h"
#include "base/text.h"
#include "pipeline/commands/commands.h"
#include "pipeline/commands/usage_errors.h"
#include "pipeline/console.h"
#include "pipeline/gather.h"
#include "pipeline/tables.h"
#include "reports/report_formats.h"

namespace lightbench {
namespace {

struct ReportParams {
  std::string folder;
  std::vector<std::string> formats;
};

ExitCode run_report(const ReportParams& params) {
  const std::filesystem::path folder = params.folder;
  const auto file = folder / "run.json";
  const RunReport report = run_report_from_json(read_file(file), file.string());
  write_reports(report, folder, params.formats);
  say(terminal_summary(report) + "\n" + (folder / "index.html").string());
  return exit_code_of(report);
}

}  // namespace

void add_report_command(CLI::App& app, Action& action) {
  CLI::App* command = nullptr;
  auto params = add_command<ReportParams>(
      app, "report", "Write the reports of a run again, from its run.json", action, run_report, command);
  const auto names = row_names(report_formats());
  command->add_option("folder", params->folder, "Folder of a run")->required();
  command->add_option("--format", params->formats, "Only these: " + join(names, ", "))
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(one_of(names));
  command->footer(
      "Exit codes are those of a run whose tasks are all asked for.\n\nExample:\n  lightbench report "
      "out/cornell --format html,junit");
}

}  // namespace lightbench
