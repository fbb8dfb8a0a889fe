#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace lightbench {

/// The hashes of files that many tasks read, such as baked objects. A file is hashed again when its size, its
/// inode or its times have changed.
class InputHashes {
 public:
  /// Returns what `hash_file` does. Throws Error where the file cannot be read.
  std::string hash(const std::filesystem::path& file);

 private:
  struct Known {
    std::string stamp;  ///< what the file system says of it
    std::string hash;
  };
  std::map<std::filesystem::path, Known> known_;
};

}  // namespace lightbench
