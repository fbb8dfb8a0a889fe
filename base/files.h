#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace lightbench {

/// The whole file as bytes. Throws Error with the path when it cannot be read.
std::string read_file(const std::filesystem::path& file);

/// Makes parent folders, writes beside the target, and renames over it: whole or not there.
void write_file_atomic(const std::filesystem::path& file, std::string_view bytes);

/// A place for a library that wants to write a file by name: it writes to `path()`, which has the target's
/// extension, and `commit` renames it over the target. Without a commit the temporary file is removed.
class AtomicFile {
 public:
  explicit AtomicFile(std::filesystem::path target);  ///< makes the parent folders
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;
  ~AtomicFile();

  const std::filesystem::path& path() const { return temporary_; }
  void commit();

 private:
  std::filesystem::path target_;
  std::filesystem::path temporary_;
};

/// A folder of its own below the system's place for temporary files, removed with everything in it.
class TemporaryFolder {
 public:
  explicit TemporaryFolder(std::string_view prefix = "lightbench");
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder();

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// A name from a job or scene file as one path component: letters, digits, and ._- stay (but for leading
/// dots), every other byte becomes %XX; never empty, at most 120 bytes (longer ones are cut and end in a
/// hash). Different names give different results.
std::string escape_file_name(std::string_view name);

/// Replaces ${NAME} by the environment variable NAME; only names that start with LIGHTBENCH_ are allowed.
/// A relative result is taken relative to `base`. Throws Error(…, where) for an unset or a foreign variable.
std::filesystem::path resolve_path(std::string_view text, const std::filesystem::path& base,
                                   const std::string& where);

/// The program's own file.
std::filesystem::path executable_path();

}  // namespace lightbench
