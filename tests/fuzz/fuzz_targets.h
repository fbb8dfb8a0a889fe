#pragma once

#include <span>
#include <string>
#include <string_view>

/// The readers that are fuzzed. Whatever bytes a reader is given, it reads them or throws Error; any other
/// exception, a crash, a sanitizer's report, more than 10 seconds or 2 GB are faults (docs/fuzzing.md).
namespace lightbench::fuzz {

/// One reader: a file NAME_fuzz.cpp here, a row in fuzz_targets.cpp, and a folder NAME in corpus/.
struct FuzzTarget {
  const char* name;
  /// Reads the bytes as a file of its kind and looks at what came of it. Throws Error where they are refused.
  void (*read)(std::string_view bytes);
  const char* dictionary;  ///< words of its format: a file in dictionaries/ without .dict, or -
};

std::span<const FuzzTarget> fuzz_targets();
/// Throws Error where no target has that name.
const FuzzTarget& find_fuzz_target(const std::string& name);

/// Whether the reader took the bytes, false where it refused them. Whatever else the reader throws goes
/// through.
bool is_read(const FuzzTarget& target, std::string_view bytes);

}  // namespace lightbench::fuzz
