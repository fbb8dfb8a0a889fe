#include "pipeline/job_schema.h"

#include <nlohmann/json.hpp>

#include "pipeline/references.h"
#include "pipeline/tables.h"
#include "renderer/technique.h"
#include "reports/metric.h"

namespace lightbench {
namespace {

using Json = nlohmann::ordered_json;

Json text_schema(const char* doc) {
  return {{"type", "string"}, {"minLength", 1}, {"description", doc}};
}

Json enum_schema(const std::vector<std::string>& names, const char* doc) {
  return {{"type", "string"}, {"enum", names}, {"description", doc}};
}

Json range_schema(const char* type, double min, double max, const char* doc) {
  return {{"type", type}, {"minimum", min}, {"maximum", max}, {"description", doc}};
}

Json vec3_schema(const char* doc) {
  return {{"type", "array"},
          {"items", {{"type", "number"}}},
          {"minItems", 3},
          {"maxItems", 3},
          {"description", doc}};
}

Json list_schema(Json items, const char* doc, std::size_t min_items = 0) {
  Json json = {{"type", "array"}, {"items", std::move(items)}};
  if (min_items) json["minItems"] = min_items;
  json["description"] = doc;
  return json;
}

Json object_schema(Json properties, const std::vector<std::string>& required = {}) {
  Json json = {{"type", "object"}, {"properties", std::move(properties)}};
  if (!required.empty()) json["required"] = required;
  json["additionalProperties"] = false;
  return json;
}

Json param_schema(const ParamSpec& spec) {
  Json json = Json::object();
  switch (spec.type) {
    case ParamType::boolean:
      json["type"] = "boolean";
      break;
    case ParamType::integer:
      json = {{"type", "integer"}, {"minimum", spec.min}, {"maximum", spec.max}};
      break;
    case ParamType::number:
      json = {{"type", "number"}, {"minimum", spec.min}, {"maximum", spec.max}};
      break;
    case ParamType::text:
      json["type"] = "string";
      break;
    case ParamType::choice:
      json = {{"type", "string"}, {"enum", spec.choices}};
      break;
  }
  json["description"] = spec.doc;
  json["default"] = std::visit([](const auto& value) { return Json(value); }, spec.default_value);
  return json;
}

Json params_schema(std::span<const ParamSpec> specs) {
  Json properties = Json::object();
  for (const auto& spec : specs) properties[spec.name] = param_schema(spec);
  return object_schema(std::move(properties));
}

Json sweep_schema(std::span<const ParamSpec> specs) {
  Json properties = Json::object();
  for (const auto& spec : specs)
    if (!is_path_param(spec))
      properties[spec.name] = list_schema(param_schema(spec), "one variant for each value", 1);
  return object_schema(std::move(properties));
}

Json time_schema(const char* doc) {
  return {{"type", "number"}, {"description", doc}};
}

Json camera_properties() {
  return {{"position", vec3_schema("of the camera, in the scene's units")},
          {"look_at", vec3_schema("point that the camera looks at")},
          {"up", vec3_schema("default [0, 1, 0]")},
          {"fov", {{"type", "number"}, {"description", "vertical, degrees"}}}};
}

/// The camera's position and look_at stand in the view, or in its keyframes.
Json view_schema() {
  Json properties = {{"name", text_schema("unique in its scene")}};
  properties.update(camera_properties());
  properties["time"] = time_schema("seconds; where moving entities stand; default 0");
  properties["frame"] = object_schema(
      {{"of", text_schema("name of a sequence")}, {"number", {{"type", "integer"}, {"minimum", 0}}}},
      {"of", "number"});
  Json key = {{"time", time_schema("seconds")}};
  key.update(camera_properties());
  properties["keyframes"] =
      list_schema(object_schema(std::move(key), {"time"}), "what the view does not say for all of them", 2);
  Json json = object_schema(std::move(properties), {"name"});
  json["anyOf"] = Json::array({Json{{"required", Json::array({"position", "look_at"})}},
                               Json{{"required", Json::array({"keyframes"})}}});
  return json;
}

Json sequence_schema() {
  return object_schema({{"start", time_schema("seconds; default 0")},
                        {"frames", range_schema("integer", 2, kMaxFrames, "how many")},
                        {"rate", range_schema("number", kMinFrameRate, kMaxFrameRate, "frames a second")}},
                       {"frames", "rate"});
}

/// The places that views may come from: a camera script with names of its views or without, views written
/// out, or drawn ones.
Json scene_schema() {
  const Json names = list_schema(text_schema("a view of the camera script"), "with 'cameras': only these", 1);
  Json json = object_schema(
      {{"name", text_schema("default: the scene file's stem")},
       {"scene", text_schema("scene file or OBJ, relative to the job file; ${LIGHTBENCH_...} is replaced")},
       {"cameras", text_schema("camera script")},
       {"views",
        {{"oneOf",
          Json::array({names, list_schema(view_schema(), "without 'cameras': views written out", 1)})}}},
       {"random", object_schema({{"count", range_schema("integer", 1, 10000, "how many views")},
                                 {"seed", {{"type", "integer"}, {"minimum", 0}, {"default", 1}}},
                                 {"fov", range_schema("number", 1, 170, "vertical, degrees; default 60")},
                                 {"version", range_schema("integer", 1, kNewestGenerator,
                                                          "which generator draws; default: the newest")}},
                                {"count"})},
       {"sequence", sequence_schema()}},
      {"scene"});
  const Json objects = {{"items", {{"type", "object"}}}};
  const Json texts = {{"items", {{"type", "string"}}}};
  const auto has = [](const char* key) { return Json{{"required", Json::array({key})}}; };
  const auto neither = [&](const char* a, const char* b) {
    return Json{{"anyOf", Json::array({has(a), has(b)})}};
  };
  Json script = has("cameras");
  script["properties"]["views"] = texts;
  script["not"] = has("random");
  Json inline_views = has("views");
  inline_views["properties"]["views"] = objects;
  inline_views["not"] = neither("cameras", "random");
  Json random = has("random");
  random["not"] = neither("cameras", "views");
  json["oneOf"] = Json::array({script, inline_views, random});
  return json;
}

Json variant_schema() {
  Json kinds = Json::array();
  for (const auto& technique : techniques()) {
    Json properties = {
        {"name", text_schema("default: the technique's name")},
        {"technique", {{"enum", Json::array({technique.name})}, {"description", technique.doc}}}};
    if (!technique.presets.empty())
      properties["preset"] = enum_schema(row_names(std::span(technique.presets)), "named set of parameters");
    properties["params"] = params_schema(technique.params);
    properties["sweep"] = sweep_schema(technique.params);
    kinds.push_back(object_schema(std::move(properties), {"technique"}));
  }
  return Json{{"oneOf", kinds}};
}

Json reference_schema() {
  Json kinds = Json::array();
  for (const auto& kind : reference_kinds()) {
    Json properties = {{"name", text_schema("default: the kind's name")},
                       {"kind", {{"enum", Json::array({kind.name})}, {"description", kind.doc}}}};
    if (!kind.presets.empty())
      properties["preset"] = enum_schema(row_names(kind.presets), "named set of parameters");
    properties["params"] = params_schema(kind.params);
    properties["timeout"] = range_schema("number", 0.1, 1e7, "seconds; default 7200");
    kinds.push_back(object_schema(std::move(properties), {"kind"}));
  }
  return Json{{"oneOf", kinds}};
}

Json gate_schema() {
  Json json = object_schema({{"metric", enum_schema(row_names(metrics()), "one of the job's metrics")},
                             {"variant", text_schema("name or pattern")},
                             {"reference", text_schema("default: the primary reference")},
                             {"scene", text_schema("name or pattern; default: all")},
                             {"view", text_schema("name or pattern; default: all")},
                             {"min", {{"type", "number"}}},
                             {"max", {{"type", "number"}}},
                             {"over", enum_schema(gate_over_names(), "default: each")}},
                            {"metric", "variant"});
  json["anyOf"] =
      Json::array({Json{{"required", Json::array({"min"})}}, Json{{"required", Json::array({"max"})}}});
  return json;
}

Json difference_schema() {
  return object_schema(
      {{"images", {{"type", "boolean"}, {"default", true}}},
       {"heat", {{"type", "boolean"}, {"default", true}}},
       {"baseline", {{"type", "boolean"}, {"default", true}}},
       {"heat_scale", range_schema("number", 1, 255, "error at the colour bar's end; default 64")}});
}

std::vector<std::string> all_buffers() {
  std::vector<JobVariant> one_of_each;
  for (const auto& technique : techniques()) one_of_each.emplace_back().technique = technique.name;
  return known_buffers(one_of_each);
}

}  // namespace

std::string job_schema_text() {
  const Json side = {{"type", "integer"}, {"minimum", 1}, {"maximum", 32768}};
  Json properties = {
      {"$schema", {{"type", "string"}}},
      {"name", text_schema("default: the file's stem")},
      {"size",
       {{"type", "array"},
        {"items", side},
        {"minItems", 2},
        {"maxItems", 2},
        {"default", Json::array({1024, 768})}}},
      {"samples", range_schema("integer", 1, 8, "supersampling per axis, on both sides; default 1")},
      {"scenes", list_schema(scene_schema(), "what is rendered", 1)},
      {"variants", list_schema(variant_schema(), "how it is lit", 1)},
      {"references", list_schema(reference_schema(), "what it is compared with")},
      {"baseline",
       text_schema("variant that gain is measured against; default: the only variant of technique direct")},
      {"primary_reference", text_schema("default: the first")},
      {"metrics",
       list_schema(enum_schema(row_names(metrics()), "a metric"),
                   "default: all but those of fitted ambient light; those that look at the frame before "
                   "only where a scene has a sequence")},
      {"gates", list_schema(gate_schema(), "rules that make the run pass or fail")},
      {"difference", difference_schema()},
      {"buffers", list_schema(enum_schema(all_buffers(), "a named buffer"), "written beside each snapshot")}};
  Json schema = {{"$schema", "http://json-schema.org/draft-07/schema#"}, {"title", "lightbench job"}};
  schema.update(object_schema(std::move(properties), {"scenes", "variants"}));
  return schema.dump(2) + "\n";
}

}  // namespace lightbench
