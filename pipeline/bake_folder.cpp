#include "pipeline/bake_folder.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/files.h"
#include "base/hash.h"
#include "base/json_bytes.h"
#include "base/json_reader.h"
#include "renderer/path_tracer.h"
#include "renderer/radiance/bake_settings.h"

namespace lightbench {
namespace {

constexpr int kFormat = 1;

std::filesystem::path file_in(const std::filesystem::path& folder) {
  return folder / "bake.json";
}

nlohmann::ordered_json to_json(const ParamValue& value) {
  return std::visit([](const auto& held) { return nlohmann::ordered_json(held); }, value);
}

}  // namespace

BakeFolder bake_folder(const Scene& scene, const ParamValues& params) {
  Hasher hasher;
  hasher.field("version", std::int64_t{kBakeVersion});
  hasher.field("embree", path_tracer_version());
  for (const auto& file : scene.files) hasher.field(file.path.filename().string(), file.hash);
  hasher.field("parameters", bake_params_text(params));
  BakeFolder bake{hasher.digest(), {}};
  for (const ParamSpec& row : bake_params()) bake.params[row.name] = params.all().at(row.name);
  return bake;
}

void write_bake_folder(const std::filesystem::path& folder, const BakeFolder& bake) {
  nlohmann::ordered_json json = {{"format", kFormat}, {"key", bake.key}};
  for (const auto& [name, value] : bake.params) json["params"][name] = to_json(value);
  write_file_atomic(file_in(folder), json_text(json, 1) + "\n");
}

BakeFolder read_bake_folder(const std::filesystem::path& folder) {
  const std::filesystem::path file = file_in(folder);
  if (!std::filesystem::exists(file))
    throw Error("is not a folder that 'lightbench bake' made: it has no bake.json", folder.string());
  JsonObject root = JsonValue::parse_file(file).object();
  if (root.at("format").integer() != kFormat)
    throw Error("is of another version of lightbench", file.string());
  BakeFolder bake;
  bake.key = root.at("key").text();
  JsonObject params = root.at("params").object();
  for (const ParamSpec& row : bake_params()) bake.params[row.name] = read_param(row, params.at(row.name));
  params.finish();
  root.finish();
  return bake;
}

}  // namespace lightbench
