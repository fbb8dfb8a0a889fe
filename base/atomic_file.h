#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string_view>

namespace lightbench {

/// What a writer asks of the operating system. Each call gives what the system call gives: a negative number
/// and `errno` where it failed. Tests put a file system in its place that fails.
class FileSystem {
 public:
  virtual ~FileSystem() = default;
  virtual int create(const std::filesystem::path& file);  ///< opens a file that must not be there yet
  virtual std::ptrdiff_t write(int descriptor, std::string_view bytes);
  virtual int sync(int descriptor);
  virtual std::int64_t size(int descriptor);
  virtual int close(int descriptor);
  virtual int rename(const std::filesystem::path& from, const std::filesystem::path& to);
};
/// The machine's own, which keeps nothing between calls.
FileSystem& machine_files();

/// A file that is whole or not there. Its bytes go beside the target and are on the disk, all of them, before
/// the file takes the target's name. Until then the target keeps its old content, and without a `commit` the
/// bytes are removed. Every call throws Error with the target's path where the disk is full or anything else
/// fails.
class AtomicFile {
 public:
  /// Makes the parent folders. A target that is there must be a regular file.
  explicit AtomicFile(std::filesystem::path target, FileSystem& files = machine_files());
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;
  ~AtomicFile();

  void write(std::string_view bytes);
  /// Ends the writing: what was written is whole and on the disk. Several files can be finished before the
  /// first of them takes its name.
  void finish();
  /// Finishes the file unless that was done, and gives it the target's name.
  void commit();

 private:
  void create();
  void sync_folder();
  [[noreturn]] void fail() const;  ///< by errno

  std::filesystem::path target_;
  std::filesystem::path temporary_;  ///< empty where no file of that name is to be removed
  FileSystem& files_;
  int descriptor_ = -1;
  std::uint64_t written_ = 0;
};

}  // namespace lightbench
