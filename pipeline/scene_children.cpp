#include "pipeline/scene_children.h"

#include <functional>

#include <fmt/format.h>

#include "base/error.h"
#include "base/files.h"
#include "base/process.h"
#include "base/text.h"
#include "pipeline/job_file.h"
#include "pipeline/scene_facts_file.h"
#include "scene/camera_script.h"

namespace lightbench {
namespace {

constexpr auto kTimeout = std::chrono::minutes(30);
/// A slow network may let a child rest for a while; what uses no processor time for so long waits for
/// something that does not come.
constexpr auto kIdleTimeout = std::chrono::minutes(5);

ProcessOptions child_options(std::vector<std::string> argv) {
  ProcessOptions options;
  options.argv = std::move(argv);
  options.timeout = kTimeout;
  options.idle_timeout = kIdleTimeout;
  return options;
}

/// How a child ended that did not do what it was to do.
std::string end_of(const ProcessResult& result) {
  const std::string words = join(last_lines(result.err, 3), " | ");
  return fmt::format("the process that read it ended: {}{}", result.describe(),
                     words.empty() ? "" : "; it said last: " + words);
}

SceneFacts facts_in(const std::filesystem::path& file, const ProcessResult& result) {
  SceneFacts lost;
  lost.error = end_of(result);
  if (!result.ok()) return lost;
  try {
    return scene_facts_from_json(read_file(file), file.string());
  } catch (const Error& error) {
    lost.error = error.what();
    return lost;
  }
}

/// Runs one child for each scene and returns whether a signal asked for the end.
bool inspect_into(std::vector<SceneFacts>& facts, const std::filesystem::path& program,
                  const std::filesystem::path& folder, int places) {
  ProcessLoop loop;
  std::size_t next = 0;
  const std::function<void()> start_next = [&] {
    if (next == facts.size() || loop.interrupted()) return;
    const std::size_t scene = next++;
    const auto file = folder / fmt::format("{}.json", scene);
    const std::vector<std::string> argv = {program.string(), "inspect", (folder / "job.json").string(),
                                           std::to_string(scene), file.string()};
    loop.start(child_options(argv), nullptr, [&facts, &start_next, scene, file](const ProcessResult& result) {
      facts[scene] = facts_in(file, result);
      start_next();
    });
  };
  for (int i = 0; i < places; ++i) start_next();
  loop.run();
  return loop.interrupted();
}

ProcessResult run_child(const ProcessOptions& options) {
  ProcessResult result;
  ProcessLoop loop;
  loop.start(options, nullptr, [&](const ProcessResult& ended) { result = ended; });
  loop.run();
  if (loop.interrupted()) throw Interrupted();
  return result;
}

/// The message of a child that could not draw views, without what every message of a command begins with.
std::string message_of(const ProcessResult& result) {
  constexpr std::string_view kPrefix = "lightbench: error: ";
  const std::string words = join(last_lines(result.err, 3), " | ");
  return words.starts_with(kPrefix) && result.signal == 0 ? words.substr(kPrefix.size()) : end_of(result);
}

}  // namespace

std::vector<SceneFacts> SceneChildren::inspect(const Job& job) const {
  std::vector<SceneFacts> facts(job.scenes.size());
  const TemporaryFolder folder("lightbench-plan");
  write_file_atomic(folder.path() / "job.json", job_text(job));
  if (inspect_into(facts, program_, folder.path(), places_)) throw Interrupted();
  return facts;
}

std::vector<View> SceneChildren::draw_views(const Job& job, const JobScene& scene,
                                            const RandomViewsRequest& request) const {
  const TemporaryFolder folder("lightbench-plan");
  const auto file = folder.path() / "views.json";
  const double time = scene.sequence ? scene.sequence->start : 0;
  const ProcessResult result = run_child(
      child_options({program_.string(), "cameras", std::filesystem::absolute(scene.file).string(),
                     fmt::format("--random={}", request.count), fmt::format("--seed={}", request.seed),
                     fmt::format("--fov={}", request.fov), fmt::format("--generator={}", request.version),
                     fmt::format("--size={}x{}", job.width, job.height), fmt::format("--time={}", time),
                     "--output=" + file.string()}));
  if (!result.ok()) throw Error(message_of(result));
  return read_camera_script(file);
}

}  // namespace lightbench
