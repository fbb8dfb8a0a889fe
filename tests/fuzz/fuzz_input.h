#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/files.h"
#include "scene/problem_list.h"

/// What the targets have in common.
namespace lightbench::fuzz {

/// Throws an exception that is no Error, and so a fault, where something does not hold of what a reader
/// returned.
void require(bool holds, const std::string& what);

/// A folder for readers that take a path. It lies in the system's place for temporary files, so a fuzzer is
/// fastest with TMPDIR in memory.
class InputFolder {
 public:
  std::filesystem::path write(const std::string& name, std::string_view bytes) const;
  const std::filesystem::path& path() const { return folder_.path(); }

 private:
  TemporaryFolder folder_{"lightbench-fuzz"};
};

/// Throws Error for the first problem that is an error; each problem must say what is wrong, and where.
void refuse(const std::vector<Problem>& problems);

/// Whether all that a renderer indexes with is in range, and all numbers are finite.
void require_sound(const Mesh& mesh, std::size_t materials);

}  // namespace lightbench::fuzz
