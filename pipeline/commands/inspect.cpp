#include "pipeline/inspect.h"

#include <CLI/CLI.hpp>

#include "base/error.h"
#include "base/files.h"
#include "pipeline/commands/commands.h"
#include "pipeline/job_file.h"
#include "pipeline/scene_facts_file.h"

namespace lightbench {
namespace {

struct InspectParams {
  std::string job;
  std::size_t scene = 0;
  std::string output;
};

ExitCode run_inspect(const InspectParams& params) {
  const Job job = parse_job(read_file(params.job), params.job, JobText::concrete);
  if (params.scene >= job.scenes.size()) throw Error("the job has no scene of this number", params.job);
  write_file_atomic(params.output, scene_facts_to_json(inspect_scene(job, job.scenes[params.scene])));
  return ExitCode::ok;
}

}  // namespace

void add_inspect_command(CLI::App& app, Action& action) {
  CLI::App* command = nullptr;
  auto params = add_command<InspectParams>(app, "inspect", "Read a scene of a job (started by run and plan)",
                                           action, run_inspect, command);
  command->group("");
  command->add_option("job", params->job, "Job file whose views are all written out")->required();
  command->add_option("scene", params->scene, "Number of the scene, from 0 on")->required();
  command->add_option("output", params->output, "File to write the scene's facts to")->required();
}

}  // namespace lightbench
