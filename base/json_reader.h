#pragma once

#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <glm/vec3.hpp>
#include <nlohmann/json_fwd.hpp>

#include "base/input_file.h"

namespace lightbench {

/// How much JSON is read at most, so that it takes no more than some times the memory of its text: a value
/// takes 16 bytes and more, though it may be written in two.
struct JsonLimits {
  std::uint64_t bytes;       ///< of a file
  std::size_t values;        ///< in all: objects, lists, texts, numbers
  std::size_t keys = 10000;  ///< of one object; looking one up takes time by their number
  int depth = 100;           ///< of lists and objects in one another
};
/// What people and scripts write: a script of 100 thousand cameras has 1.6 million values.
inline constexpr JsonLimits kWrittenJson{kLargestTextFile, 2'000'000};
/// What lightbench writes and reads again, of runs with a million tasks.
inline constexpr JsonLimits kOwnJson{kLargestOwnFile, 50'000'000};

class JsonObject;

/// A JSON value that knows its place. Every getter throws Error(what, "file: $.path") on a wrong type or
/// range.
class JsonValue {
 public:
  /// Parses text with // and /* */ comments. Errors say `file:line`; a key that stands twice is an error, and
  /// so is a text beyond the limits.
  static JsonValue parse(const std::string& text, const std::string& file,
                         const JsonLimits& limits = kWrittenJson);
  static JsonValue parse_file(const std::filesystem::path& file, const JsonLimits& limits = kWrittenJson);

  std::string where() const;  ///< "file: $.path"
  const std::string& path() const { return path_; }
  const std::string& file() const;
  [[noreturn]] void fail(const std::string& what) const;

  bool is_object() const;
  bool is_array() const;
  bool is_string() const;
  bool is_number() const;
  bool is_boolean() const;
  bool is_null() const;

  double number(double min = -std::numeric_limits<double>::infinity(),
                double max = std::numeric_limits<double>::infinity()) const;  ///< finite, min <= x <= max
  long long integer(long long min = std::numeric_limits<long long>::min(),
                    long long max = std::numeric_limits<long long>::max()) const;
  bool boolean() const;
  std::string text() const;  ///< any bytes where it is the name of a file (base/json_bytes.h)
  /// One of `choices`; otherwise an Error that names the nearest one.
  std::string choice(const std::vector<std::string>& choices) const;
  glm::dvec3 vec3() const;  ///< an array of three finite numbers
  std::vector<double> numbers(std::size_t count) const;
  std::vector<JsonValue> items() const;  ///< of an array
  JsonObject object() const;

  const nlohmann::ordered_json& raw() const { return *value_; }

 private:
  friend class JsonObject;
  struct Document;
  JsonValue(std::shared_ptr<const Document> document, const nlohmann::ordered_json* value, std::string path);

  std::shared_ptr<const Document> document_;
  const nlohmann::ordered_json* value_;
  std::string path_;
};

/// The keys of a JSON object, read one by one; `finish` rejects those that nobody asked for.
class JsonObject {
 public:
  explicit JsonObject(JsonValue value);

  JsonValue at(const std::string& key);  ///< Error if missing
  std::optional<JsonValue> find(const std::string& key);
  bool has(const std::string& key) const;
  std::vector<std::string> keys() const;  ///< as written, in order
  const JsonValue& value() const { return value_; }
  [[noreturn]] void fail(const std::string& what) const { value_.fail(what); }

  /// The keys that were never asked for, in order.
  std::vector<std::string> unknown() const;
  /// "unknown key 'a'", with the nearest one that was asked for.
  std::string unknown_key_text(const std::string& key) const;
  /// Throws Error for the first unknown key.
  void finish() const;

 private:
  JsonValue value_;
  std::set<std::string> known_;
};

}  // namespace lightbench
