#include "base/atomic_file.h"

#include <atomic>
#include <cassert>
#include <cerrno>
#include <cstdio>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/error.h"

namespace lightbench {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t kMaxStemBytes = 100;  // of a temporary name, for which file systems allow 255

void make_parent_folders(const fs::path& file) {
  if (file.parent_path().empty()) return;
  std::error_code error;
  fs::create_directories(file.parent_path(), error);
  if (error) throw Error("cannot make the folder: " + error.message(), file.parent_path().string());
}

/// A rename would put a file in the place of a device or a pipe.
void check_target(const fs::path& file) {
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (fs::is_directory(status)) throw Error("is a folder, cannot write a file there", file.string());
  if (fs::exists(status) && !fs::is_regular_file(status))
    throw Error("is not a regular file, cannot write a file there", file.string());
}

/// Some file systems have no such thing for folders, and some folders may be written in but not opened.
bool folders_are_not_synced(int error) {
  return error == EINVAL || error == ENOTSUP || error == EACCES;
}

}  // namespace

int FileSystem::create(const fs::path& file) {
  return ::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
}

std::ptrdiff_t FileSystem::write(int descriptor, std::string_view bytes) {
  return ::write(descriptor, bytes.data(), bytes.size());
}

int FileSystem::sync(int descriptor) {
  return ::fsync(descriptor);
}

std::int64_t FileSystem::size(int descriptor) {
  struct stat status {};
  return ::fstat(descriptor, &status) == 0 ? status.st_size : -1;
}

int FileSystem::close(int descriptor) {
  return ::close(descriptor);
}

int FileSystem::rename(const fs::path& from, const fs::path& to) {
  return std::rename(from.c_str(), to.c_str());
}

FileSystem& machine_files() {
  static FileSystem files;
  return files;
}

AtomicFile::AtomicFile(fs::path target, FileSystem& files) : target_(std::move(target)), files_(files) {
  make_parent_folders(target_);
  check_target(target_);
  create();
}

AtomicFile::~AtomicFile() {
  if (descriptor_ >= 0) files_.close(descriptor_);
  std::error_code ignored;
  if (!temporary_.empty()) fs::remove(temporary_, ignored);
}

/// A name may be taken: by what a killed process left, or by another machine's process of the same number.
void AtomicFile::create() {
  static std::atomic<unsigned> counter{0};
  const std::string stem = target_.filename().string().substr(0, kMaxStemBytes);
  do {
    temporary_ = target_.parent_path() / fmt::format(".{}.tmp-{}-{}", stem, ::getpid(), counter++);
    descriptor_ = files_.create(temporary_);
  } while (descriptor_ < 0 && (errno == EEXIST || errno == EINTR));
  if (descriptor_ >= 0) return;
  temporary_.clear();
  fail();
}

void AtomicFile::write(std::string_view bytes) {
  assert(descriptor_ >= 0);
  while (!bytes.empty()) {
    errno = ENOSPC;  // what a write of nothing means
    const std::ptrdiff_t count = files_.write(descriptor_, bytes);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) fail();
    written_ += std::uint64_t(count);
    bytes.remove_prefix(std::size_t(count));
  }
}

void AtomicFile::finish() {
  if (descriptor_ < 0) return;
  if (files_.sync(descriptor_) != 0) fail();
  const std::int64_t size = files_.size(descriptor_);
  if (size < 0) fail();
  if (std::uint64_t(size) != written_)
    throw Error(fmt::format("cannot write: {} of {} bytes are on the disk", size, written_),
                target_.string());
  const int descriptor = std::exchange(descriptor_, -1);  // closed, whatever close says
  if (files_.close(descriptor) != 0 && errno != EINTR) fail();
}

void AtomicFile::commit() {
  finish();
  if (files_.rename(temporary_, target_) != 0) fail();
  temporary_.clear();
  sync_folder();
}

/// Else a power cut may take the new name away.
void AtomicFile::sync_folder() {
  const fs::path folder = target_.parent_path().empty() ? fs::path(".") : target_.parent_path();
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) {
    if (!folders_are_not_synced(errno)) fail();
    return;
  }
  const int error = files_.sync(descriptor) == 0 ? 0 : errno;
  ::close(descriptor);  // nothing was written through it
  errno = error;
  if (error != 0 && !folders_are_not_synced(error)) fail();
}

void AtomicFile::fail() const {
  throw Error("cannot write: " + std::generic_category().message(errno), target_.string());
}

}  // namespace lightbench
