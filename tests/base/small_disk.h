#pragma once

#include <cerrno>
#include <filesystem>
#include <functional>
#include <string>
#include <system_error>
#include <thread>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sched.h>
#include <sys/mount.h>
#include <unistd.h>

#include "base/error.h"
#include "base/files.h"

namespace lightbench::test {

/// A disk in memory of as many pages as a test wants.
class SmallDisk {
 public:
  explicit SmallDisk(std::filesystem::path folder) : folder_(std::move(folder)) { mount(1, 0); }
  ~SmallDisk() { ::umount2(folder_.c_str(), MNT_DETACH); }
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;

  const std::filesystem::path& path() const { return folder_; }
  static std::size_t pages_of(std::size_t bytes) { return (bytes + page() - 1) / page(); }
  void resize(std::size_t pages) const { mount(pages, MS_REMOUNT); }

 private:
  static std::size_t page() { return std::size_t(::sysconf(_SC_PAGESIZE)); }
  void mount(std::size_t pages, unsigned long flags) const {
    const std::string options = fmt::format("size={}", pages * page());
    if (::mount("small_disk", folder_.c_str(), "tmpfs", flags, options.c_str()) != 0)
      throw std::system_error(errno, std::generic_category(), "mount");
  }

  std::filesystem::path folder_;
};

/// Calls `body` with a small disk that nobody else sees: in a thread with mounts of its own, which the
/// processes that it starts share. False: this user has no right to mount anything.
inline bool with_small_disk(const std::function<void(const SmallDisk&)>& body) {
  bool allowed = false;
  std::thread([&] {
    if (::unshare(CLONE_NEWNS) != 0) return;
    if (::mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) != 0) return;
    const TemporaryFolder folder;
    try {
      const SmallDisk disk(folder.path());
      allowed = true;
      body(disk);
    } catch (const std::exception& error) {
      if (allowed) ADD_FAILURE() << error.what();
    }
  }).join();
  return allowed;
}

/// The message with which tests are skipped where nothing can be mounted.
inline constexpr const char* kNoMounts = "only root may mount a small disk here";

/// `write(file)` on disks that have room for no page, one page, ... beside the old file: it must throw an
/// Error that names the file and leave the old file and nothing else, until all of the new file fits.
inline void expect_whole_or_old(const SmallDisk& disk, const std::string& name,
                                const std::function<void(const std::filesystem::path&)>& write) {
  const TemporaryFolder roomy;
  write(roomy.path() / name);
  const std::string whole = read_file(roomy.path() / name);
  const std::size_t pages = SmallDisk::pages_of(whole.size());
  ASSERT_GE(pages, 3u) << "a file that says little";
  const auto file = disk.path() / name;
  disk.resize(1);
  write_file_atomic(file, "old");
  for (std::size_t room = 0; room < pages; ++room) {
    disk.resize(1 + room);
    try {
      write(file);
      ADD_FAILURE() << name << " is written with " << room << " of " << pages << " pages";
    } catch (const Error& error) {
      EXPECT_THAT(error.what(), ::testing::HasSubstr(file.string()));
      EXPECT_THAT(error.what(), ::testing::HasSubstr("No space left"));
    }
    ASSERT_EQ(read_file(file), "old") << room;
    ASSERT_EQ(std::distance(std::filesystem::directory_iterator(disk.path()), {}), 1) << room;
  }
  disk.resize(1 + pages);
  write(file);
  EXPECT_TRUE(read_file(file) == whole);
  std::filesystem::remove(file);
}

}  // namespace lightbench::test
