#include "pipeline/plan_bakes.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/text.h"
#include "pipeline/concrete.h"
#include "renderer/path_tracer.h"
#include "renderer/radiance/bake_settings.h"
#include "renderer/radiance/radiance_codecs.h"

namespace lightbench {
namespace {

/// Raised when a task's outputs, or the numbers it tells, change though nothing else in its key does.
constexpr int kBakeTaskVersion = 3;
constexpr int kCompressVersion = 2;

/// Guesses; what was measured in earlier runs replaces the times.
constexpr double kTexelSeconds = 2e-5;  // with 72 light points
constexpr double kPathOfTexelSeconds = 1e-6;
constexpr double kCompressSeconds = 5e-8;  // of a texel in a direction
constexpr double kBytesOfRadiance = 14;    // of a texel in a direction: as it is read, and on the GPU
constexpr double kBytesOfBake = 24;        // of the same: both sides, while one is put below the other

/// Of so many megabytes, whatever a job asks for.
int memory_mb(double megabytes) {
  return int(std::min(megabytes, 1e9));
}

}  // namespace

void BakePlanner::need_objects(Task& snapshot) {
  const SceneFacts& facts = draft_.facts(snapshot.scene);
  if (!facts.error.empty()) return;
  snapshot.deps = object_files(snapshot.scene, snapshot.variant);
  std::vector<std::string> keys;
  for (const std::size_t dep : snapshot.deps) keys.push_back(draft_.tasks()[dep].key);
  snapshot.key_parts.emplace_back("baked", join(keys, " "));
  double values = 0;
  for (const ObjectSize& size : facts.sizes[std::size_t(snapshot.variant)])
    values += size.texels * size.directions;
  snapshot.resources.memory_mb += memory_mb(values * kBytesOfRadiance / 1e6);
}

const std::vector<std::size_t>& BakePlanner::object_files(int scene, int variant) {
  const std::string baked = baked_folder(draft_.job(), scene, draft_.variant(variant));
  const std::string compressed = compressed_folder(draft_.job(), scene, draft_.variant(variant));
  const std::size_t objects = draft_.facts(scene).objects.size();
  std::vector<std::size_t>& bakes = object_files_[baked];
  if (bakes.empty())
    for (std::size_t i = 0; i < objects; ++i) bakes.push_back(add_bake(scene, variant, i, baked));
  // The very same folder, and so the same tasks, where the codec draws what was baked as it is.
  std::vector<std::size_t>& files = object_files_[compressed];
  if (files.empty())
    for (std::size_t i = 0; i < objects; ++i)
      files.push_back(add_compression(scene, variant, i, compressed, bakes[i]));
  return files;
}

std::size_t BakePlanner::add_bake(int scene, int variant, std::size_t object, const std::string& folder) {
  const SceneFacts& facts = draft_.facts(scene);
  const ObjectFacts& baked = facts.objects[object];
  const ParamValues params = variant_params(draft_.variant(variant));
  Task task = draft_.start(TaskKind::bake, scene, kNone, {draft_.variant(variant).name, baked.file_stem});
  task.variant = variant;
  task.object = baked.entity;
  task.key_parts = {{"version", fmt::format("{} {}", kBakeTaskVersion, kBakeVersion)},
                    {"embree", path_tracer_version()}};
  add_files(task.key_parts, facts);
  task.key_parts.emplace_back("object", std::to_string(baked.entity));
  task.key_parts.emplace_back("parameters", bake_params_text(params));
  task.outputs = {folder + "/" + baked.file_stem + ".mtex"};
  task.group = "scene " + std::to_string(scene);
  const auto [texels, directions] = facts.sizes[std::size_t(variant)][object];
  const BakeOptions trace = bake_settings(params).trace;
  const double paths = trace.bounces > 0 ? trace.bounce_samples : 0;
  task.expected_seconds = texels * (kTexelSeconds + paths * trace.bounces * kPathOfTexelSeconds);
  task.timeout_seconds = std::max(task.timeout_seconds, 20 * task.expected_seconds);
  task.resources.memory_mb = memory_mb(200 + texels * directions * kBytesOfBake / 1e6 +
                                       double(facts.triangles) / 1000 + double(facts.texture_bytes) / 1e6);
  return draft_.add(std::move(task));
}

std::size_t BakePlanner::add_compression(int scene, int variant, std::size_t object,
                                         const std::string& folder, std::size_t bake) {
  const SceneFacts& facts = draft_.facts(scene);
  const ObjectFacts& compressed = facts.objects[object];
  const ParamValues params = variant_params(draft_.variant(variant));
  Task task =
      draft_.start(TaskKind::compress, scene, kNone, {draft_.variant(variant).name, compressed.file_stem});
  task.variant = variant;
  task.object = compressed.entity;
  task.deps = {bake};
  task.key_parts = {{"version", std::to_string(kCompressVersion)},
                    {"bake", draft_.tasks()[bake].key},
                    {"parameters", codec_params_text(params)}};
  for (const char* extension : radiance_codec(params).extensions)
    task.outputs.push_back(folder + "/" + compressed.file_stem + extension);
  task.group = "compress " + std::to_string(scene);
  const auto [texels, directions] = facts.sizes[std::size_t(variant)][object];
  const double values = texels * directions;
  task.expected_seconds = 0.1 + values * kCompressSeconds;
  task.resources.memory_mb = memory_mb(200 + values * kBytesOfRadiance / 1e6);
  return draft_.add(std::move(task));
}

}  // namespace lightbench
