#include "base/temporary_folder.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <string>

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/error.h"

namespace lightbench {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view kRandomPart = "XXXXXX";

/// The same for all processes of a machine until it is started anew; empty where the system does not tell.
const std::string& boot_token() {
  static const std::string token = [] {
    std::string text;
    std::ifstream("/proc/sys/kernel/random/boot_id") >> text;
    return text.substr(0, 8);
  }();
  return token;
}

bool is_own_folder(const fs::path& path) {
  struct stat status {};
  return ::lstat(path.c_str(), &status) == 0 && S_ISDIR(status.st_mode) && status.st_uid == ::geteuid();
}

/// Removes the folders whose names begin like this and that nobody uses any more.
void remove_stale(const fs::path& place, const std::string& start) {
  std::error_code error;
  for (fs::directory_iterator entry(place, error), end; !error && entry != end; entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    if (!name.starts_with(start) || name.size() != start.size() + kRandomPart.size()) continue;
    if (!is_own_folder(entry->path())) continue;
    const FolderLock lock(entry->path());
    std::error_code ignored;
    if (lock.state() == Locked::yes) fs::remove_all(entry->path(), ignored);
  }
}

}  // namespace

TemporaryFolder::TemporaryFolder(std::string_view prefix) {
  std::error_code error;
  const fs::path place = fs::temp_directory_path(error);
  if (error) throw Error("cannot make a temporary folder: " + error.message(), place.string());
  const std::string start = fmt::format("{}-{}-", prefix, boot_token());
  if (!boot_token().empty()) remove_stale(place, start);
  // One that another process took for stale before it was locked is gone, or will be: then a new one is made.
  do {
    std::string pattern = (place / (start + std::string(kRandomPart))).string();
    if (!::mkdtemp(pattern.data()))
      throw Error(fmt::format("cannot make a temporary folder: {}", std::strerror(errno)), pattern);
    path_ = pattern;
    lock_ = FolderLock(path_);
  } while (lock_.state() == Locked::by_another || !fs::exists(path_, error));
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

}  // namespace lightbench
