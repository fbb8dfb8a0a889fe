#include "pipeline/scene_facts_file.h"

#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/json_bytes.h"

namespace lightbench {
namespace {

using Json = nlohmann::ordered_json;

// Two-column rows, such as the parts of a key, are lists of pairs.
Json pairs_json(const KeyParts& parts) {
  Json json = Json::array();
  for (const auto& [name, value] : parts) json.push_back({name, value});
  return json;
}

KeyParts pairs_of(const Json& json) {
  KeyParts parts;
  for (const Json& pair : json)
    parts.emplace_back(pair.at(0).get<std::string>(), pair.at(1).get<std::string>());
  return parts;
}

Json objects_json(const std::vector<ObjectFacts>& objects) {
  Json json = Json::array();
  for (const ObjectFacts& object : objects) json.push_back({object.entity, object.name, object.file_stem});
  return json;
}

Json sizes_json(const std::vector<std::vector<ObjectSize>>& variants) {
  Json json = Json::array();
  for (const auto& sizes : variants) {
    json.push_back(Json::array());
    for (const ObjectSize& size : sizes) json.back().push_back({size.texels, size.directions});
  }
  return json;
}

Json exports_json(const std::vector<std::vector<KeyParts>>& references) {
  Json json = Json::array();
  for (const auto& views : references) {
    json.push_back(Json::array());
    for (const KeyParts& parts : views) json.back().push_back(pairs_json(parts));
  }
  return json;
}

SceneFacts facts_of(const Json& json) {
  SceneFacts facts;
  facts.error = json.at("error").get<std::string>();
  facts.triangles = json.at("triangles").get<std::size_t>();
  facts.texture_bytes = json.at("texture_bytes").get<std::size_t>();
  facts.light_points = json.at("light_points").get<std::size_t>();
  facts.moves = json.at("moves").get<bool>();
  facts.warnings = json.at("warnings").get<std::vector<std::string>>();
  for (const Json& credit : json.at("credits"))
    facts.credits.push_back(
        {credit.at(0).get<std::string>(), credit.at(1).get<std::string>(), credit.at(2).get<std::string>()});
  facts.files = pairs_of(json.at("files"));
  facts.paths = json.at("paths").get<std::vector<std::string>>();
  facts.unsupported = json.at("unsupported").get<std::vector<std::vector<std::string>>>();
  for (const Json& object : json.at("objects"))
    facts.objects.push_back(
        {object.at(0).get<int>(), object.at(1).get<std::string>(), object.at(2).get<std::string>()});
  for (const Json& sizes : json.at("sizes")) {
    auto& row = facts.sizes.emplace_back();
    for (const Json& size : sizes) row.push_back({size.at(0).get<double>(), size.at(1).get<int>()});
  }
  for (const Json& views : json.at("exports")) {
    auto& row = facts.exports.emplace_back();
    for (const Json& parts : views) row.push_back(pairs_of(parts));
  }
  facts.kind_warnings = json.at("kind_warnings").get<std::map<std::string, std::vector<std::string>>>();
  return facts;
}

}  // namespace

std::string scene_facts_to_json(const SceneFacts& facts) {
  Json json = {{"error", facts.error},
               {"triangles", facts.triangles},
               {"texture_bytes", facts.texture_bytes},
               {"light_points", facts.light_points},
               {"moves", facts.moves},
               {"warnings", facts.warnings},
               {"credits", Json::array()},
               {"files", pairs_json(facts.files)},
               {"paths", facts.paths}};
  for (const Credit& credit : facts.credits)
    json["credits"].push_back({credit.piece, credit.creator, credit.license});
  json["unsupported"] = facts.unsupported;
  json["objects"] = objects_json(facts.objects);
  json["sizes"] = sizes_json(facts.sizes);
  json["exports"] = exports_json(facts.exports);
  json["kind_warnings"] = facts.kind_warnings;
  return json_text(json);
}

SceneFacts scene_facts_from_json(const std::string& text, const std::string& file) try {
  return facts_of(parse_json_text(text));
} catch (const nlohmann::json::exception& error) {
  throw Error(std::string("does not hold the facts of a scene: ") + error.what(), file);
}

}  // namespace lightbench
