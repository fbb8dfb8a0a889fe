#include "pipeline/concrete.h"

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "base/error.h"
#include "base/files.h"
#include "base/text.h"
#include "pipeline/job_gates.h"
#include "pipeline/job_problems.h"
#include "pipeline/run_folder.h"
#include "pipeline/tables.h"
#include "scene/camera_script.h"
#include "scene/motion.h"

namespace lightbench {
namespace {

constexpr std::size_t kMaxSweptVariants = 4096;

std::vector<JobVariant> expand_sweep(const JobVariant& variant) {
  if (variant.sweep.empty()) return {variant};
  const std::size_t count = swept_count(variant);
  JobVariant plain = variant;
  plain.sweep.clear();
  plain.swept_from = variant.name;
  std::vector<JobVariant> result;
  for (std::size_t i = 0; i < count; ++i) {
    JobVariant& one = result.emplace_back(plain);
    std::vector<std::string> labels(variant.sweep.size());
    std::size_t rest = i;
    for (std::size_t p = variant.sweep.size(); p-- > 0;) {
      const auto& [name, values] = variant.sweep[p];
      const ParamValue& value = values[rest % values.size()];
      rest /= values.size();
      one.params[name] = value;
      labels[p] = fmt::format("{}={}", name, to_text(value));
    }
    one.name = fmt::format("{}[{}]", variant.name, join(labels, ","));
  }
  return result;
}

/// A gate that names a swept variant holds for each variant that the sweep made.
std::vector<Gate> expand_gates(const std::vector<Gate>& gates, const std::vector<JobVariant>& variants) {
  std::vector<Gate> result;
  for (const auto& gate : gates) {
    const auto before = result.size();
    for (const auto& variant : variants) {
      if (variant.swept_from != gate.variant) continue;
      result.push_back(gate);
      result.back().variant = variant.name;
      result.back().as_written += " (" + variant.name + ")";
    }
    if (result.size() == before) result.push_back(gate);
    if (result.size() > kMaxGates)
      throw Error(fmt::format("the gates on swept variants make more than {} gates", kMaxGates));
  }
  return result;
}

std::vector<View> chosen_views(const CameraScript& script) {
  const auto views = read_camera_script(script.file);
  if (script.names.empty()) return views;
  std::map<std::string_view, const View*> by_name;
  for (const auto& view : views) by_name[view.name] = &view;
  std::vector<View> chosen;
  for (const auto& name : script.names) {
    const auto found = by_name.find(name);
    if (found == by_name.end())
      throw Error("has no view '" + name + "'" + did_you_mean(name, row_names(views)), script.file.string());
    chosen.push_back(*found->second);
  }
  return chosen;
}

/// The frames of each view, one view after the other.
std::vector<View> frames_of(const std::vector<View>& views, const JobSequence& sequence) {
  std::vector<View> frames;
  for (const auto& view : views) {
    if (view.frame) throw Error("a view that is a frame already cannot be made a sequence", view.where);
    for (int i = 0; i < sequence.frames; ++i) {
      View frame = view_at(view, sequence.start + i / sequence.rate);
      frame.name = fmt::format("{}.{:03}", view.name, i);
      frame.frame = SequenceFrame{view.name, i};
      frames.push_back(std::move(frame));
    }
  }
  return frames;
}

}  // namespace

std::size_t swept_count(const JobVariant& variant) {
  double count = 1;
  for (const auto& [name, values] : variant.sweep) count *= double(values.size());
  if (count > double(kMaxSweptVariants))
    throw Error(fmt::format("the sweep of '{}' makes {:.0f} variants; at most {} are possible", variant.name,
                            count, kMaxSweptVariants));
  return std::size_t(count);
}

std::vector<JobVariant> expand_sweeps(const std::vector<JobVariant>& variants) {
  std::vector<JobVariant> result;
  for (const auto& variant : variants)
    for (auto& one : expand_sweep(variant)) result.push_back(std::move(one));
  return result;
}

const std::vector<View>& views_of(const JobScene& scene) {
  return std::get<std::vector<View>>(scene.views);
}

std::optional<std::size_t> previous_frame(const std::vector<View>& views, std::size_t view) {
  const auto& frame = views[view].frame;
  if (!frame || frame->number == 0) return std::nullopt;
  for (std::size_t i = view; i-- > 0;)
    if (const auto& other = views[i].frame;
        other && other->sequence == frame->sequence && other->number + 1 == frame->number)
      return i;
  return std::nullopt;
}

std::filesystem::path stored_cameras(const JobScene& scene) {
  return std::filesystem::path("cameras") / (escape_file_name(scene.name) + ".json");
}

namespace {

/// Makes the views of a scene still ones, and of those of a sequence its frames.
void make_still(JobScene& scene) {
  auto views = views_of(scene);
  if (scene.sequence) views = frames_of(views, *scene.sequence);
  for (auto& view : views) view.keyframes.clear();
  scene.sequence.reset();
  scene.views = std::move(views);
}

/// Settles the views that are written down: nothing has to be drawn for them.
void settle_written_views(JobScene& scene) {
  if (const auto* script = std::get_if<CameraScript>(&scene.views)) {
    auto views = chosen_views(*script);  // the script is a part of what it is replaced with
    scene.views = std::move(views);
  }
  make_still(scene);
}

}  // namespace

Job make_concrete(const Job& job, const std::filesystem::path& out, const DrawViews& draw_views) {
  Job result = job;
  result.variants = expand_sweeps(job.variants);
  result.gates = expand_gates(job.gates, result.variants);
  ProblemList problems;
  for (auto& scene : result.scenes)
    if (!std::holds_alternative<RandomViewsRequest>(scene.views))
      collect(problems, [&] { settle_written_views(scene); });
  check_gate_views(job.gates, result.scenes, problems);
  throw_problems(problems, job.file.string());

  for (auto& scene : result.scenes) {
    const auto* request = std::get_if<RandomViewsRequest>(&scene.views);
    if (!request) continue;
    check_inside(out, stored_cameras(scene).parent_path());
    const auto file = out / stored_cameras(scene);
    const auto views = draw_views(scene, *request, double(job.width) / job.height);
    write_file_atomic(file, camera_script_text(views, DrawnBy{request->seed, request->version}));
    scene.views = read_camera_script(file);
    make_still(scene);
  }
  check_gate_views(job.gates, result.scenes, problems);
  throw_problems(problems, job.file.string());
  return result;
}

}  // namespace lightbench
