#pragma once

#include <string>
#include <string_view>

#include <nlohmann/json_fwd.hpp>

/// Names of files may hold bytes that are not UTF-8 (`Fenêtre.png` in Latin-1), which JSON cannot. The one
/// rule for all JSON files that we write and read back: in a string, each such byte 80..FF stands as the
/// private code point U+10FF80..U+10FFFF. Names with those code points in UTF-8 are taken for such bytes,
/// too, so that every name survives. Keys of objects are never names of files: there such bytes become
/// U+FFFD.
namespace lightbench {

/// UTF-8 for any bytes, and back. Text that is UTF-8 without those code points stays as it is.
std::string utf8_of_bytes(std::string_view bytes);
std::string bytes_of_utf8(std::string_view text);

/// JSON text of values whose strings may hold any bytes. `indent` is as for nlohmann's `dump`.
std::string json_text(const nlohmann::ordered_json& json, int indent = -1);
/// Reads what `json_text` wrote. Throws nlohmann's parse error.
nlohmann::ordered_json parse_json_text(std::string_view text);

}  // namespace lightbench
