#include "base/descriptors.h"

#include <cerrno>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/mman.h>
#include <unistd.h>

namespace lightbench {

Descriptor& Descriptor::operator=(Descriptor&& other) noexcept {
  std::swap(number_, other.number_);
  return *this;
}

Descriptor::~Descriptor() {
  if (number_ >= 0) ::close(number_);
}

void open_standard_descriptors() {
  // Each open takes the smallest number that is free.
  for (int number = 0; number <= STDERR_FILENO;)
    if (::fcntl(number, F_GETFD) >= 0)
      ++number;
    else if (::open("/dev/null", O_RDWR) < 0)
      return;
}

bool write_all(const Descriptor& descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = ::write(descriptor.number(), bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return false;
    bytes.remove_prefix(std::size_t(count));
  }
  return true;
}

Descriptor file_in_memory(std::string_view bytes) {
  Descriptor file(::memfd_create("lightbench", MFD_CLOEXEC));
  if (!file || !write_all(file, bytes) || ::lseek(file.number(), 0, SEEK_SET) != 0) return Descriptor();
  return file;
}

FolderLock::FolderLock(const std::filesystem::path& folder)
    : descriptor_(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC)) {
  if (!descriptor_) return;
  if (::flock(descriptor_.number(), LOCK_EX | LOCK_NB) == 0)
    state_ = Locked::yes;
  else if (errno == EWOULDBLOCK)
    state_ = Locked::by_another;
}

}  // namespace lightbench
