#pragma once

#include <filesystem>
#include <set>
#include <string>

#include "base/json_reader.h"
#include "pipeline/job.h"
#include "scene/problem_list.h"

/// The parts of a job file that say what is rendered: scenes, variants, references.
namespace lightbench {

/// How a job is read.
struct JobReading {
  std::filesystem::path base;  ///< the folder that relative paths are taken from
  std::size_t longest_name;    ///< bytes
  ProblemList& problems;       ///< what is wrong; the rest is read all the same
};

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

/// The name of what is named after its file where it has none of its own. Throws Error where that is no name.
std::string name_of_file(const std::filesystem::path& file, const std::string& where);

/// What has a problem is not to be used. They throw Error where the value is no object.
JobScene read_scene(const JsonValue& value, const JobReading& reading);
JobVariant read_variant(const JsonValue& value, const JobReading& reading);
JobReference read_reference(const JsonValue& value, const JobReading& reading);

}  // namespace lightbench
