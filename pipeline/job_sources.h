#pragma once

#include <filesystem>
#include <set>
#include <string>

#include "base/json_reader.h"
#include "pipeline/job.h"

/// The parts of a job file that say what is rendered: scenes, variants, references. `base` is the folder that
/// relative paths are taken from.
namespace lightbench {

/// Throws where a name stands twice.
class UniqueNames {
 public:
  explicit UniqueNames(std::string what) : what_(std::move(what)) {}
  void add(const std::string& name, const JsonValue& place) {
    if (!seen_.insert(name).second) place.fail(what_ + " '" + name + "' stands twice");
  }

 private:
  std::string what_;
  std::set<std::string> seen_;
};

/// A name that a person reads in tables: not empty, one line, no control bytes.
std::string read_name(const JsonValue& value);

JobScene read_scene(const JsonValue& value, const std::filesystem::path& base);
JobVariant read_variant(const JsonValue& value, const std::filesystem::path& base);
JobReference read_reference(const JsonValue& value, const std::filesystem::path& base);

}  // namespace lightbench
