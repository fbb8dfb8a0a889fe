#include "base/json_reader.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/files.h"
#include "base/json_bytes.h"
#include "base/text.h"

namespace lightbench {
namespace {

using Json = nlohmann::ordered_json;

const char* type_name(const Json& value) {
  if (value.is_null()) return "nothing (null)";
  if (value.is_boolean()) return "true or false";
  if (value.is_number()) return "a number";
  if (value.is_string()) return "a text";
  return value.is_array() ? "a list" : "an object";
}

std::size_t line_of(const std::string& text, std::size_t byte) {
  return 1 + std::size_t(
                 std::count(text.begin(), text.begin() + std::ptrdiff_t(std::min(byte, text.size())), '\n'));
}

/// "[json.exception.parse_error.101] parse error at line 1, column 2: ..." without what the library puts
/// before the message.
std::string plain_parse_message(const std::string& message) {
  const std::size_t bracket = message.find("] ");
  const std::string plain = bracket == std::string::npos ? message : message.substr(bracket + 2);
  const std::size_t colon = plain.find(": ");
  return !plain.starts_with("parse error") || colon == std::string::npos ? plain : plain.substr(colon + 2);
}

/// Sees each value while it is parsed, and stops where limits are passed; and each object, since the parsed
/// value keeps only the last of equal keys.
class ParseGuard {
 public:
  explicit ParseGuard(const JsonLimits& limits) : limits_(limits) {}

  bool operator()(int depth, Json::parse_event_t event, Json& value) {
    using Event = Json::parse_event_t;
    if (event == Event::object_start) objects_.emplace_back();
    if (event == Event::object_end) objects_.pop_back();
    if (event == Event::key) add_key(value.get<std::string>());
    const bool starts = event == Event::object_start || event == Event::array_start;
    if (starts && depth >= limits_.depth)
      throw Error(fmt::format("lists and objects stand in one another more than {} deep", limits_.depth));
    if ((starts || event == Event::value) && ++values_ > limits_.values)
      throw Error(fmt::format("there are more than {} values", limits_.values));
    return true;
  }

 private:
  void add_key(const std::string& key) {
    std::set<std::string>& keys = objects_.back();
    if (!keys.insert(key).second) throw Error(fmt::format("the key '{}' stands twice in one object", key));
    if (keys.size() > limits_.keys) throw Error(fmt::format("an object has more than {} keys", limits_.keys));
  }

  JsonLimits limits_;
  std::size_t values_ = 0;
  std::vector<std::set<std::string>> objects_;
};

bool is_plain_key(const std::string& key) {
  return !key.empty() && std::all_of(key.begin(), key.end(),
                                     [](unsigned char c) { return std::isalnum(c) || c == '_' || c == '-'; });
}

}  // namespace

struct JsonValue::Document {
  std::string file;
  Json root;
};

JsonValue::JsonValue(std::shared_ptr<const Document> document, const Json* value, std::string path)
    : document_(std::move(document)), value_(value), path_(std::move(path)) {}

JsonValue JsonValue::parse(const std::string& text, const std::string& file, const JsonLimits& limits) {
  auto document = std::make_shared<Document>();
  document->file = file;
  try {
    document->root = Json::parse(text, ParseGuard(limits), true, true);
  } catch (const nlohmann::json::parse_error& error) {
    throw Error(plain_parse_message(error.what()), fmt::format("{}:{}", file, line_of(text, error.byte)));
  } catch (const nlohmann::json::exception& error) {
    throw Error(plain_parse_message(error.what()), file);
  } catch (const Error& error) {
    throw Error(error.message(), file);
  }
  const Json* root = &document->root;
  return JsonValue(std::move(document), root, "$");
}

JsonValue JsonValue::parse_file(const std::filesystem::path& file, const JsonLimits& limits) {
  return parse(read_file(file, limits.bytes), file.string(), limits);
}

std::string JsonValue::where() const {
  return fmt::format("{}: {}", document_->file, path_);
}
const std::string& JsonValue::file() const {
  return document_->file;
}
void JsonValue::fail(const std::string& what) const {
  throw Error(what, where());
}

bool JsonValue::is_object() const {
  return value_->is_object();
}
bool JsonValue::is_array() const {
  return value_->is_array();
}
bool JsonValue::is_string() const {
  return value_->is_string();
}
bool JsonValue::is_number() const {
  return value_->is_number();
}
bool JsonValue::is_boolean() const {
  return value_->is_boolean();
}
bool JsonValue::is_null() const {
  return value_->is_null();
}

double JsonValue::number(double min, double max) const {
  if (!value_->is_number()) fail(fmt::format("must be a number, not {}", type_name(*value_)));
  const double number = value_->get<double>();
  if (!std::isfinite(number)) fail("must be a finite number");
  if (number < min && max == std::numeric_limits<double>::infinity())
    fail(fmt::format("must be at least {}, not {}", min, number));
  if (number < min || number > max) fail(fmt::format("must be between {} and {}, not {}", min, max, number));
  return number;
}

long long JsonValue::integer(long long min, long long max) const {
  if (!value_->is_number()) fail(fmt::format("must be a whole number, not {}", type_name(*value_)));
  const double value = number();
  if (value != std::floor(value) || std::abs(value) > 9007199254740992.0)
    fail(fmt::format("must be a whole number, not {}", value));
  const auto whole = static_cast<long long>(value);
  if (whole < min || whole > max) fail(fmt::format("must be between {} and {}, not {}", min, max, whole));
  return whole;
}

bool JsonValue::boolean() const {
  if (!value_->is_boolean()) fail(fmt::format("must be true or false, not {}", type_name(*value_)));
  return value_->get<bool>();
}

std::string JsonValue::text() const {
  if (!value_->is_string()) fail(fmt::format("must be a text, not {}", type_name(*value_)));
  return bytes_of_utf8(value_->get_ref<const std::string&>());
}

std::string JsonValue::choice(const std::vector<std::string>& choices) const {
  std::string value = text();
  if (std::find(choices.begin(), choices.end(), value) == choices.end())
    fail(fmt::format("must be one of {}, not '{}'{}", join(choices, ", "), value,
                     did_you_mean(value, choices)));
  return value;
}

glm::dvec3 JsonValue::vec3() const {
  const auto values = numbers(3);
  return {values[0], values[1], values[2]};
}

std::vector<double> JsonValue::numbers(std::size_t count) const {
  if (!value_->is_array() || value_->size() != count)
    fail(fmt::format("must be a list of {} numbers", count));
  std::vector<double> result;
  for (const auto& item : items()) result.push_back(item.number());
  return result;
}

std::vector<JsonValue> JsonValue::items() const {
  if (!value_->is_array()) fail(fmt::format("must be a list, not {}", type_name(*value_)));
  std::vector<JsonValue> result;
  for (std::size_t i = 0; i < value_->size(); ++i)
    result.push_back(JsonValue(document_, &(*value_)[i], fmt::format("{}[{}]", path_, i)));
  return result;
}

JsonObject JsonValue::object() const {
  return JsonObject(*this);
}

JsonObject::JsonObject(JsonValue value) : value_(std::move(value)) {
  if (!value_.is_object()) value_.fail(fmt::format("must be an object, not {}", type_name(*value_.value_)));
}

JsonValue JsonObject::at(const std::string& key) {
  auto found = find(key);
  if (!found) value_.fail(fmt::format("the key '{}' is missing", key));
  return *found;
}

std::optional<JsonValue> JsonObject::find(const std::string& key) {
  known_.insert(key);
  const auto found = value_.value_->find(key);
  if (found == value_.value_->end()) return std::nullopt;
  const std::string step = is_plain_key(key) ? "." + key : fmt::format("[{}]", Json(key).dump());
  return JsonValue(value_.document_, &*found, value_.path_ + step);
}

bool JsonObject::has(const std::string& key) const {
  return value_.value_->contains(key);
}

std::vector<std::string> JsonObject::keys() const {
  std::vector<std::string> result;
  for (const auto& [key, unused] : value_.value_->items()) result.push_back(key);
  return result;
}

std::vector<std::string> JsonObject::unknown() const {
  std::vector<std::string> result;
  for (const auto& [key, unused] : value_.value_->items())
    if (!known_.contains(key)) result.push_back(key);
  return result;
}

std::string JsonObject::unknown_key_text(const std::string& key) const {
  return fmt::format("unknown key '{}'{}", key, did_you_mean(key, {known_.begin(), known_.end()}));
}

void JsonObject::finish() const {
  for (const auto& [key, unused] : value_.value_->items())
    if (!known_.contains(key)) value_.fail(unknown_key_text(key));
}

}  // namespace lightbench
