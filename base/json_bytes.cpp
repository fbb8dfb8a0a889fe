#include "base/json_bytes.h"

#include <nlohmann/json.hpp>

#include "base/utf8.h"

namespace lightbench {
namespace {

using Json = nlohmann::ordered_json;

/// U+10FF80 to U+10FFBF have the third byte BE, U+10FFC0 to U+10FFFF have BF.
constexpr std::string_view kLower = "\xF4\x8F\xBE", kUpper = "\xF4\x8F\xBF";

bool stands_for_byte(std::string_view sequence) {
  return sequence.size() == 4 && (sequence.starts_with(kLower) || sequence.starts_with(kUpper));
}

void append_byte(std::string& text, char c) {
  const auto byte = static_cast<unsigned char>(c);
  text += byte < 0xC0 ? kLower : kUpper;
  text += static_cast<char>(0x80 | (byte & 0x3F));
}

char byte_of(std::string_view sequence) {
  const int upper = sequence.starts_with(kUpper) ? 0x40 : 0;
  return static_cast<char>(0x80 | upper | (sequence[3] & 0x3F));
}

Json with_utf8(const Json& json) {
  if (json.is_string()) return utf8_of_bytes(json.get_ref<const std::string&>());
  if (json.is_array()) {
    Json result = Json::array();
    for (const Json& value : json) result.push_back(with_utf8(value));
    return result;
  }
  if (!json.is_object()) return json;
  Json result = Json::object();
  for (const auto& [key, value] : json.items()) result[key] = with_utf8(value);
  return result;
}

}  // namespace

std::string utf8_of_bytes(std::string_view bytes) {
  std::string text;
  text.reserve(bytes.size());
  for (std::size_t i = 0; i < bytes.size();) {
    const std::size_t length = utf8_sequence_length(bytes.substr(i));
    if (length == 0 || stands_for_byte(bytes.substr(i, length))) {
      append_byte(text, bytes[i++]);
    } else {
      text += bytes.substr(i, length);
      i += length;
    }
  }
  return text;
}

std::string bytes_of_utf8(std::string_view text) {
  std::string bytes;
  bytes.reserve(text.size());
  for (std::size_t i = 0; i < text.size();) {
    if (stands_for_byte(text.substr(i, 4))) {
      bytes += byte_of(text.substr(i, 4));
      i += 4;
    } else {
      bytes += text[i++];
    }
  }
  return bytes;
}

std::string json_text(const Json& json, int indent) {
  return with_utf8(json).dump(indent, ' ', false, Json::error_handler_t::replace);
}

Json parse_json_text(std::string_view text) {
  const auto restore = [](int, Json::parse_event_t event, Json& value) {
    if (event == Json::parse_event_t::value && value.is_string())
      value = bytes_of_utf8(value.get_ref<const std::string&>());
    return true;
  };
  return Json::parse(text, restore);
}

}  // namespace lightbench
