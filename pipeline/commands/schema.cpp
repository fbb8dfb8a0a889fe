#include <cstdio>

#include "pipeline/commands/commands.h"
#include "pipeline/job_schema.h"

namespace lightbench {
namespace {

struct SchemaParams {};

ExitCode run_schema(const SchemaParams&) {
  std::printf("%s", job_schema_text().c_str());
  return ExitCode::ok;
}

}  // namespace

void add_schema_command(CLI::App& app, Action& action) {
  CLI::App* command = nullptr;
  add_command<SchemaParams>(app, "schema", "Print the JSON schema of job files", action, run_schema, command);
  command->footer("Example:\n  lightbench schema > jobs/job.schema.json");
}

}  // namespace lightbench
