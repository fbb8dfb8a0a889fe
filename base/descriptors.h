#pragma once

#include <filesystem>
#include <string_view>

namespace lightbench {

/// A file descriptor that is closed at its end.
class Descriptor {
 public:
  explicit Descriptor(int number = -1) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept : number_(other.number_) { other.number_ = -1; }
  Descriptor& operator=(Descriptor&& other) noexcept;
  ~Descriptor();

  int number() const { return number_; }  ///< -1: none
  explicit operator bool() const { return number_ >= 0; }

 private:
  int number_;
};

/// Opens those of the descriptors 0, 1 and 2 that are closed, to /dev/null: else the next file that is opened
/// takes their place and what is printed goes into it. To be called before any file is opened.
void open_standard_descriptors();

/// A file that is only in memory, to be read from its start; none where the system cannot make it (errno).
Descriptor file_in_memory(std::string_view bytes);

/// Writes all of it; else errno says why not.
bool write_all(const Descriptor& descriptor, std::string_view bytes);

enum class Locked {
  yes,
  by_another,  ///< a process that lives has the lock
  unknown,     ///< there is no such folder, or its file system has no locks
};

/// A lock on a folder that ends with the process, however that ends. Nothing is written into the folder.
class FolderLock {
 public:
  FolderLock() = default;
  /// Does not wait, and does not follow a link.
  explicit FolderLock(const std::filesystem::path& folder);

  Locked state() const { return state_; }

 private:
  Descriptor descriptor_;
  Locked state_ = Locked::unknown;
};

}  // namespace lightbench
