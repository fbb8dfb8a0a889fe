#include "pipeline/work.h"

#include <algorithm>
#include <string_view>
#include <unordered_map>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/color.h"
#include "base/error.h"
#include "base/files.h"
#include "base/hash.h"
#include "base/image_io.h"
#include "base/json_bytes.h"
#include "base/process.h"
#include "base/stopwatch.h"
#include "pipeline/concrete.h"
#include "pipeline/input_hashes.h"
#include "pipeline/inspect.h"
#include "pipeline/plan_file.h"
#include "pipeline/run_folder.h"
#include "pipeline/score.h"
#include "pipeline/snapshot.h"
#include "renderer/radiance/object_bake.h"
#include "renderer/radiance/radiance_codecs.h"
#include "renderer/radiance/radiance_file.h"
#include "scene/motion.h"
#include "scene/scene_file.h"

namespace lightbench {
namespace {

/// The parts of a task's key that its export should give again.
void check_same_export(const Task& task, const KeyParts& made) {
  for (const auto& part : task.key_parts)
    if (std::find(made.begin(), made.end(), part) == made.end())
      throw Error("the scene's files changed while the run went on (" + part.first + ")");
}

/// The scene that was planned must be the one that was loaded; else the pictures would stand under its key.
void check_same_scene(const Plan& plan, const Task& task, const Scene& scene) {
  const KeyParts loaded = file_parts(scene);
  if (key_of(loaded) == plan.scene_hashes[std::size_t(task.scene)]) return;
  std::string what;
  for (const auto& [name, hash] : loaded) {
    const KeyParts::value_type part{"file " + name, hash};
    const auto of_name = std::ranges::find(task.key_parts, part.first, &KeyParts::value_type::first);
    if (of_name != task.key_parts.end() && std::ranges::find(task.key_parts, part) == task.key_parts.end())
      what = " (" + name + ")";
  }
  throw Error("the scene's files changed while the run went on" + what);
}

/// The picture of another engine must be the one that was planned, too.
void check_same_picture(const Task& task, const FrameResult& frame) {
  const auto planned = std::ranges::find(task.key_parts, "picture", &KeyParts::value_type::first);
  if (planned != task.key_parts.end() && planned->second != frame.picture_hash)
    throw Error("the picture was changed while the run went on");
}

void append(std::vector<std::string>& warnings, const std::vector<std::string>& more) {
  warnings.insert(warnings.end(), more.begin(), more.end());
}

/// A plan does not know how many entities a scene has.
void check_object(const Task& task, const Scene& scene) {
  if (std::size_t(task.object) >= scene.entities.size())
    throw Error(
        fmt::format("object {} is none of the scene's {} entities", task.object, scene.entities.size()));
}

}  // namespace

struct TaskWorker::Impl {
  explicit Impl(const Plan& p) : plan(p) {}

  const Plan& plan;
  std::unique_ptr<Renderer> renderer;
  int loaded = kNone;  ///< index of the scene that is loaded
  Scene scene;
  std::unique_ptr<ObjectBaker> baker;                           ///< of that scene
  std::map<std::string, std::unique_ptr<SceneExport>> exports;  ///< of that scene, by reference kind
  InputHashes input_hashes;

  const Job& job() const { return plan.job; }
  const JobScene& job_scene(const Task& task) const { return job().scenes[std::size_t(task.scene)]; }
  const View& view(const Task& task) const {
    return views_of(job_scene(task))[std::size_t(std::max(task.view, 0))];
  }
  std::filesystem::path file(const std::string& relative) const { return plan.out / relative; }

  /// The task's scene, at the time of its view.
  void load(const Task& task) {
    if (loaded != task.scene) {
      exports.clear();
      baker.reset();
      renderer.reset();
      loaded = kNone;
      scene = load_scene(job_scene(task).file);
      check_same_scene(plan, task, scene);
      scene.name = job_scene(task).name;  // what a folder of pictures is searched by
      loaded = task.scene;
    }
    set_time(scene, view(task).time);
  }

  SceneExport& scene_export(const std::string& kind) {
    auto& made = exports[kind];
    if (!made) made = find_reference_kind(kind, "").make_export(scene);
    return *made;
  }

  ReferenceRequest reference_request(const Task& task) const {
    const JobReference& reference = job().references[std::size_t(task.reference)];
    return {view(task),       job().width, job().height, job().samples, reference_params(reference),
            reference.timeout};
  }

  /// What a reference image is, for whoever finds it alone.
  ImageMetadata fingerprint(const ReferenceKind& kind, const ReferenceRequest& request,
                            const ReferenceImage& made, const Task& task) const;

  /// The outputs of a task that was done. A plan does not name those of an export that all views share.
  std::vector<std::string> files_of(const Task& task) const;

  TaskResult bake(const Task& task);
  TaskResult compress(const Task& task);
  TaskResult snapshot(const Task& task);
  TaskResult export_scene(const Task& task);
  TaskResult reference(const Task& task);
  TaskResult score(const Task& task);
};

ImageMetadata TaskWorker::Impl::fingerprint(const ReferenceKind& kind, const ReferenceRequest& request,
                                            const ReferenceImage& made, const Task& task) const {
  ImageMetadata metadata = {{"lightbench:reference", kind.name},
                            {"lightbench:tool", kind.tool_version()},
                            {"lightbench:settings", to_text(request.params)},
                            {"lightbench:bounces", std::to_string(kind.bounces(request.params))},
                            {"lightbench:scene", plan.scene_hashes[std::size_t(task.scene)]},
                            {"lightbench:key", task.key}};
  if (made.noise) metadata["lightbench:noise"] = fmt::format("{:.6g} of 255", *made.noise);
  return metadata;
}

std::vector<std::string> TaskWorker::Impl::files_of(const Task& task) const {
  std::vector<std::string> files = task.outputs;
  if (task.kind != TaskKind::export_ || task.view != kNone) return files;
  const std::string folder =
      shared_export_folder(job(), task.scene, job().references[std::size_t(task.reference)].kind);
  for (const auto& entry : std::filesystem::directory_iterator(file(folder)))
    if (entry.is_regular_file()) files.push_back(folder + "/" + entry.path().filename().string());
  return files;
}

TaskResult TaskWorker::Impl::bake(const Task& task) {
  load(task);
  check_object(task, scene);
  if (!baker) baker = std::make_unique<ObjectBaker>(scene);
  const JobVariant& variant = job().variants[std::size_t(task.variant)];
  const Stopwatch watch;
  const double cpu_start = own_cpu_seconds();
  const ObjectBake baked = baker->bake(std::size_t(task.object), bake_settings(variant_params(variant)));
  TaskResult result;
  result.seconds = watch.seconds();
  result.cpu_seconds = own_cpu_seconds() - cpu_start;
  result.noise = baked.news.noise;
  for (const RayRate& rate : baked.news.rays)
    if (rate.seconds > 0) result.ray_rates[rate.name] = double(rate.rays) / rate.seconds;
  result.metrics = {{"width", MetricValue::of(baked.stack.width)},
                    {"height", MetricValue::of(baked.stack.height)},
                    {"texels", MetricValue::of(double(baked.texels))},
                    {"directions", MetricValue::of(baked.stack.grid.layers())}};
  write_radiance(file(task.outputs.front()), baked.stack);
  return result;
}

TaskResult TaskWorker::Impl::compress(const Task& task) {
  load(task);
  check_object(task, scene);
  const JobVariant& variant = job().variants[std::size_t(task.variant)];
  const ParamValues params = variant_params(variant);
  const Stopwatch watch;
  const double cpu_start = own_cpu_seconds();
  const std::string stem = object_file_stem(scene, std::size_t(task.object));
  const HalfStack stack =
      read_half_radiance(file(baked_folder(job(), task.scene, variant)) / (stem + ".mtex"));
  const auto counts =
      counting_places(object_atlas(scene, std::size_t(task.object), bake_settings(params)), stack.height);
  const CodecReport report = radiance_codec(params).compress(
      stack, counts, params, file(compressed_folder(job(), task.scene, variant)) / stem);
  TaskResult result;
  result.seconds = watch.seconds();
  result.cpu_seconds = own_cpu_seconds() - cpu_start;
  for (const auto& [name, value] : codec_numbers(report)) result.metrics[name] = MetricValue::of(value);
  return result;
}

TaskResult TaskWorker::Impl::snapshot(const Task& task) {
  load(task);
  if (!renderer) renderer = std::make_unique<Renderer>(parse_gl(plan.gl, ""));
  const JobVariant& variant = job().variants[std::size_t(task.variant)];
  FrameRequest request{scene, view(task), job().width, job().height, job().samples, {}};
  if (find_technique(variant.technique, "").needs_bake)
    request.baked = file(compressed_folder(job(), task.scene, variant));
  const auto buffers = variant_buffers(job(), variant);
  request.buffers.insert(buffers.begin(), buffers.end());
  const Stopwatch watch;
  const double cpu_start = own_cpu_seconds();
  FrameResult frame =
      renderer->render(find_technique(variant.technique, ""), variant_params(variant), request);
  check_same_picture(task, frame);
  TaskResult result;
  result.seconds = watch.seconds();
  result.cpu_seconds = own_cpu_seconds() - cpu_start;
  for (const auto& pass : frame.passes) result.passes.push_back({pass.name, pass.seconds});
  result.warnings = frame.warnings;
  const std::string stem = image_stem(job(), task.scene, task.view, variant.name);
  append(result.warnings,
         write_image_pair(file(stem + ".exr"), file(stem + ".png"), frame.image,
                          {{"lightbench:technique", variant.technique}, {"lightbench:key", task.key}}));
  for (const auto& name : buffers) {
    const std::string buffer = buffer_stem(job(), task.scene, task.view, variant.name, name);
    const auto found = frame.buffers.find(name);
    if (found == frame.buffers.end()) throw Error("the technique did not give its buffer '" + name + "'");
    write_buffer_pair(file(buffer + ".exr"), file(buffer + ".png"), found->second);
  }
  return result;
}

TaskResult TaskWorker::Impl::export_scene(const Task& task) {
  load(task);
  const JobReference& reference = job().references[std::size_t(task.reference)];
  SceneExport& exported = scene_export(reference.kind);
  const ReferenceRequest request = reference_request(task);
  check_same_export(task, exported.key_parts(request));
  TaskResult result;
  if (task.view != kNone) {
    exported.write_view(request, file(image_stem(job(), task.scene, task.view, reference.name)));
    return result;
  }
  const std::string folder = shared_export_folder(job(), task.scene, reference.kind);
  exported.write_shared(file(folder));
  for (const auto& name : exported.shared_files()) result.outputs[folder + "/" + name];
  return result;
}

TaskResult TaskWorker::Impl::reference(const Task& task) {
  const JobReference& reference = job().references[std::size_t(task.reference)];
  const ReferenceKind& kind = find_reference_kind(reference.kind, "");
  const std::string stem = image_stem(job(), task.scene, task.view, reference.name);
  const ReferenceRequest request = reference_request(task);
  ReferenceImage made;
  if (kind.exports()) {
    made = kind.run_export(request, {file(stem), file(shared_export_folder(job(), task.scene, kind.name))});
  } else {
    load(task);
    made = kind.run_scene(request, scene);
  }
  TaskResult result;
  result.seconds = made.seconds;
  result.cpu_seconds = made.cpu_seconds;
  result.noise = made.noise;
  result.mean_luminance = mean_luminance(made.image);
  result.ray_rates = made.ray_rates;
  result.warnings = made.warnings;
  append(result.warnings, write_image_pair(file(stem + ".exr"), file(stem + ".png"), made.image,
                                           fingerprint(kind, request, made, task)));
  return result;
}

TaskResult TaskWorker::Impl::score(const Task& task) {
  const std::string& variant = job().variants[std::size_t(task.variant)].name;
  const std::string& reference = job().references[std::size_t(task.reference)].name;
  const auto exr = [&](const std::string& source) {
    return file(image_stem(job(), task.scene, task.view, source) + ".exr");
  };
  ScoreRequest request;
  request.image = exr(variant);
  request.reference = exr(reference);
  if (!job().baseline.empty()) request.baseline = exr(job().baseline);
  if (!baseline_albedo(job()).empty())
    request.baseline_albedo =
        file(buffer_stem(job(), task.scene, task.view, job().baseline, baseline_albedo(job())) + ".exr");
  const auto& views = views_of(job_scene(task));
  if (const auto before = previous_frame(views, std::size_t(task.view));
      before && needs_previous(job().metrics)) {
    request.previous_image = file(image_stem(job(), task.scene, int(*before), variant) + ".exr");
    request.previous_reference = file(image_stem(job(), task.scene, int(*before), reference) + ".exr");
  }
  request.metrics = job().metrics;
  const Stopwatch watch;
  const Score score = compute_score(request);
  const std::string stem = score_stem(job(), task.scene, task.view, variant, reference);
  TaskResult result;
  result.metrics = score.metrics;
  if (score.identical)
    result.warnings.push_back(
        fmt::format("the pictures of {} and {} are identical; this tells how near they are only if they were "
                    "made independently",
                    variant, reference));
  write_file_atomic(file(stem + ".score.json"), score_json(score));
  for (const auto& output : task.outputs) {
    if (output.ends_with(".heat.png"))
      write_png(file(output), heat_map(score.reference, score.image, job().difference.heat_scale));
    else if (output == stem + ".diff.png")
      write_png(file(output), difference_image(score.reference, score.image));
    else if (output.ends_with(".diff.png"))
      write_png(file(output), difference_image(score.baseline, score.image));
  }
  result.seconds = watch.seconds();
  return result;
}

TaskWorker::TaskWorker(const Plan& plan) : impl_(std::make_unique<Impl>(plan)) {}
TaskWorker::~TaskWorker() = default;

TaskResult TaskWorker::work(const Task& task) {
  const Stopwatch watch;
  TaskResult result;
  switch (task.kind) {
    case TaskKind::bake:
      result = impl_->bake(task);
      break;
    case TaskKind::compress:
      result = impl_->compress(task);
      break;
    case TaskKind::snapshot:
      result = impl_->snapshot(task);
      break;
    case TaskKind::export_:
      result = impl_->export_scene(task);
      break;
    case TaskKind::reference:
      result = impl_->reference(task);
      break;
    case TaskKind::score:
      result = impl_->score(task);
      break;
  }
  if (result.seconds == 0) result.seconds = watch.seconds();
  for (const std::size_t dep : task.deps)
    for (const auto& file : impl_->files_of(impl_->plan.tasks[dep]))
      result.inputs[file] = impl_->input_hashes.hash(impl_->file(file));
  for (const auto& output : task.outputs) result.outputs[output];
  for (auto& [file, hash] : result.outputs) hash = hash_file(impl_->file(file));
  return result;
}

void work_tasks(const std::string& plan_file, const std::vector<std::string>& ids,
                const std::function<void(const std::string& line)>& say) {
  const Plan plan = read_plan(plan_file);
  std::unordered_map<std::string_view, const Task*> by_id;
  for (const Task& task : plan.tasks) by_id[task.id] = &task;
  std::vector<const Task*> tasks;
  for (const auto& id : ids) {
    const auto found = by_id.find(id);
    if (found == by_id.end()) throw Error("has no task '" + id + "'", plan_file);
    tasks.push_back(found->second);
  }
  TaskWorker worker(plan);
  for (const Task* task : tasks) {
    say("start " + task->id);
    try {
      check_output_folders(plan, *task);
      say("done " + task->id + " " + json_text(to_json(worker.work(*task))));
    } catch (const Error& error) {
      say("fail " + task->id + " " + json_text(error.what()));
    }
  }
}

}  // namespace lightbench
