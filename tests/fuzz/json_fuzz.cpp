#include "base/error.h"
#include "base/json_reader.h"
#include "fuzz_input.h"

namespace lightbench::fuzz {
namespace {

template <typename Getter>
void try_to(const Getter& get) {
  try {
    get();
  } catch (const Error& error) {
    require(error.where().starts_with("file.json: $"),
            "an error without its place: " + std::string(error.what()));
  }
}

/// Asks for everything, which is refused for most values.
void visit(const JsonValue& value) {
  try_to([&] { value.number(0, 1); });
  try_to([&] { value.integer(-5, 5); });
  try_to([&] { value.boolean(); });
  try_to([&] { value.choice({"one", "other"}); });
  try_to([&] { value.vec3(); });
  if (value.is_array())
    for (const JsonValue& item : value.items()) visit(item);
  if (!value.is_object()) return;
  JsonObject object = value.object();
  try_to([&] { object.at("name"); });
  try_to([&] { object.finish(); });
  for (const std::string& key : object.keys()) visit(object.at(key));
  object.finish();
}

}  // namespace

void fuzz_json(std::string_view bytes) {
  visit(JsonValue::parse(std::string(bytes), "file.json"));
}

}  // namespace lightbench::fuzz
