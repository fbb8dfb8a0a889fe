#pragma once

#include <algorithm>
#include <cerrno>
#include <limits>

#include <sys/stat.h>

#include "base/atomic_file.h"

namespace lightbench::test {

/// Files on a disk that fails as it is told to: with the error numbers given, where they are not 0.
class FailingFiles : public FileSystem {
 public:
  std::size_t room = std::numeric_limits<std::size_t>::max();  ///< bytes that fit, of one file
  std::size_t most_at_a_time = std::numeric_limits<std::size_t>::max();
  int interrupts = 0;   ///< writes that a signal breaks off before they begin
  int taken_names = 0;  ///< files that are there already
  std::int64_t lost_bytes = 0;
  int failing_create = 0, failing_sync = 0, failing_folder_sync = 0, failing_size = 0, failing_close = 0,
      failing_rename = 0;

  int create(const std::filesystem::path& file) override {
    written_ = 0;
    if (taken_names > 0) return --taken_names, fail(EEXIST);
    return failing_create != 0 ? fail(failing_create) : FileSystem::create(file);
  }

  std::ptrdiff_t write(int descriptor, std::string_view bytes) override {
    if (interrupts > 0) return --interrupts, fail(EINTR);
    const std::size_t count = std::min({bytes.size(), most_at_a_time, room - written_});
    if (count == 0) return fail(ENOSPC);
    written_ += count;
    return FileSystem::write(descriptor, bytes.substr(0, count));
  }

  int sync(int descriptor) override {
    struct stat status {};
    ::fstat(descriptor, &status);
    const int error = S_ISDIR(status.st_mode) ? failing_folder_sync : failing_sync;
    return error != 0 ? fail(error) : FileSystem::sync(descriptor);
  }

  std::int64_t size(int descriptor) override {
    return failing_size != 0 ? fail(failing_size) : FileSystem::size(descriptor) - lost_bytes;
  }

  int close(int descriptor) override {
    FileSystem::close(descriptor);
    return failing_close != 0 ? fail(failing_close) : 0;
  }

  int rename(const std::filesystem::path& from, const std::filesystem::path& to) override {
    return failing_rename != 0 ? fail(failing_rename) : FileSystem::rename(from, to);
  }

 private:
  static int fail(int error) {
    errno = error;
    return -1;
  }

  std::size_t written_ = 0;
};

}  // namespace lightbench::test
