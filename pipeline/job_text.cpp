#include <nlohmann/json.hpp>

#include "base/files.h"
#include "base/json_bytes.h"
#include "pipeline/job_file.h"
#include "pipeline/references.h"
#include "pipeline/tables.h"
#include "renderer/technique.h"
#include "scene/camera_script.h"

namespace lightbench {
namespace {

using Json = nlohmann::ordered_json;

Json value_json(const ParamValue& value) {
  return std::visit([](const auto& v) { return Json(v); }, value);
}

Json params_json(const GivenParams& params) {
  Json json = Json::object();
  for (const auto& [name, value] : params) json[name] = value_json(value);
  return json;
}

std::string path_text(const std::filesystem::path& path) {
  return unresolved(std::filesystem::absolute(path).string());
}

/// A technique's parameters, whose paths must come out as they are when they are read again.
Json params_json(const GivenParams& params, std::span<const ParamSpec> specs) {
  Json json = params_json(params);
  for (const auto& spec : specs)
    if (is_path_param(spec) && params.contains(spec.name))
      json[spec.name] = unresolved(std::get<std::string>(params.at(spec.name)));
  return json;
}

Json scene_json(const JobScene& scene) {
  Json json = {{"name", scene.name}, {"scene", path_text(scene.file)}};
  if (const auto* script = std::get_if<CameraScript>(&scene.views)) {
    json["cameras"] = path_text(script->file);
    if (!script->names.empty()) json["views"] = script->names;
  }
  if (const auto* views = std::get_if<std::vector<View>>(&scene.views))
    json["views"] = parse_json_text(camera_script_text(*views)).at("views");
  if (const auto* random = std::get_if<RandomViewsRequest>(&scene.views))
    json["random"] = {
        {"count", random->count}, {"seed", random->seed}, {"fov", random->fov}, {"version", random->version}};
  if (const auto& sequence = scene.sequence)
    json["sequence"] = {{"start", sequence->start}, {"frames", sequence->frames}, {"rate", sequence->rate}};
  return json;
}

Json variant_json(const JobVariant& variant) {
  Json json = {{"name", variant.name}, {"technique", variant.technique}};
  if (!variant.preset.empty()) json["preset"] = variant.preset;
  if (!variant.params.empty())
    json["params"] = params_json(variant.params, find_technique(variant.technique, "").params);
  for (const auto& [name, values] : variant.sweep)
    for (const auto& value : values) json["sweep"][name].push_back(value_json(value));
  return json;
}

Json reference_json(const JobReference& reference) {
  Json json = {{"name", reference.name}, {"kind", reference.kind}};
  if (!reference.preset.empty()) json["preset"] = reference.preset;
  if (!reference.params.empty())
    json["params"] = params_json(reference.params, find_reference_kind(reference.kind, "").params);
  json["timeout"] = double(reference.timeout.count()) / 1000;
  return json;
}

Json gate_json(const Gate& gate) {
  Json json = {{"metric", gate.metric}, {"variant", gate.variant}};
  if (!gate.reference.empty()) json["reference"] = gate.reference;
  if (!gate.scene.empty()) json["scene"] = gate.scene;
  if (!gate.view.empty()) json["view"] = gate.view;
  if (gate.min) json["min"] = *gate.min;
  if (gate.max) json["max"] = *gate.max;
  json["over"] = to_text(gate.over);
  return json;
}

}  // namespace

std::string job_text(const Job& job) {
  Json json = {{"name", job.name}, {"size", {job.width, job.height}}, {"samples", job.samples}};
  for (const auto& scene : job.scenes) json["scenes"].push_back(scene_json(scene));
  for (const auto& variant : job.variants) json["variants"].push_back(variant_json(variant));
  for (const auto& reference : job.references) json["references"].push_back(reference_json(reference));
  if (!job.baseline.empty()) json["baseline"] = job.baseline;
  if (!job.primary_reference.empty()) json["primary_reference"] = job.primary_reference;
  json["metrics"] = job.metrics;
  for (const auto& gate : job.gates) json["gates"].push_back(gate_json(gate));
  json["difference"] = {{"images", job.difference.images},
                        {"heat", job.difference.heat},
                        {"baseline", job.difference.baseline},
                        {"heat_scale", job.difference.heat_scale}};
  json["buffers"] = job.buffers;
  return json_text(json, 2) + "\n";
}

}  // namespace lightbench
