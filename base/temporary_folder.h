#pragma once

#include <filesystem>
#include <string_view>

#include "base/descriptors.h"

namespace lightbench {

/// A folder of its own below the system's place for temporary files, removed with everything in it.
/// The next one that is made removes those that killed processes left: of this user, since this machine was
/// started. Machines may share the place: the name says which one made it, and a lock that it is in use.
class TemporaryFolder {
 public:
  explicit TemporaryFolder(std::string_view prefix = "lightbench");
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder();

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  FolderLock lock_;
};

}  // namespace lightbench
