#include <algorithm>

#include <fmt/format.h>

#include "base/files.h"
#include "base/hash.h"
#include "pipeline/concrete.h"
#include "pipeline/plan.h"
#include "renderer/radiance/bake_settings.h"
#include "renderer/radiance/radiance_codecs.h"
#include "renderer/technique.h"
#include "reports/metric.h"

namespace lightbench {
namespace {

/// A name within a file name whose parts are kept apart by '~'. With it two of them, the longest suffix and
/// what a temporary file puts before them have less than the 255 bytes of a file's name.
std::string file_name_part(const std::string& name) {
  return escape_file_name(name, "~");
}

}  // namespace

std::string view_folder(const Job& job, int scene, int view) {
  const auto& job_scene = job.scenes[std::size_t(scene)];
  return fmt::format("views/{}/{}", escape_file_name(job_scene.name),
                     escape_file_name(views_of(job_scene)[std::size_t(view)].name));
}

std::string image_stem(const Job& job, int scene, int view, const std::string& source) {
  return view_folder(job, scene, view) + "/" + file_name_part(source);
}

std::string score_stem(const Job& job, int scene, int view, const std::string& variant,
                       const std::string& other) {
  return image_stem(job, scene, view, variant) + "~" + file_name_part(other);
}

std::string buffer_stem(const Job& job, int scene, int view, const std::string& variant,
                        const std::string& buffer) {
  return image_stem(job, scene, view, variant) + "~~" + file_name_part(buffer);
}

std::string shared_export_folder(const Job& job, int scene, const std::string& kind) {
  return escape_file_name(kind) + "/" + escape_file_name(job.scenes[std::size_t(scene)].name);
}

std::string baked_folder(const Job& job, int scene, const JobVariant& variant) {
  Hasher hasher;
  hasher.field("bake", bake_params_text(variant_params(variant)));
  return fmt::format("baked/{}/{}", escape_file_name(job.scenes[std::size_t(scene)].name), hasher.digest());
}

std::string compressed_folder(const Job& job, int scene, const JobVariant& variant) {
  const ParamValues params = variant_params(variant);
  const std::string folder = baked_folder(job, scene, variant);
  if (!radiance_codec(params).compress) return folder;
  Hasher hasher;
  hasher.field("codec", codec_params_text(params));
  return folder + "/" + hasher.digest();
}

std::string baseline_albedo(const Job& job) {
  const auto baseline = std::find_if(job.variants.begin(), job.variants.end(),
                                     [&](const JobVariant& variant) { return variant.name == job.baseline; });
  if (baseline == job.variants.end() || !needs_ambient_fit(job.metrics)) return "";
  for (const auto& buffer : find_technique(baseline->technique, "").buffers)
    if (buffer.name == "albedo") return buffer.name;
  return "";
}

std::vector<std::string> variant_buffers(const Job& job, const JobVariant& variant) {
  std::vector<std::string> result;
  const std::string albedo = variant.name == job.baseline ? baseline_albedo(job) : "";
  for (const auto& buffer : find_technique(variant.technique, "").buffers)
    if (std::find(job.buffers.begin(), job.buffers.end(), buffer.name) != job.buffers.end() ||
        buffer.name == albedo)
      result.push_back(buffer.name);
  return result;
}

}  // namespace lightbench
