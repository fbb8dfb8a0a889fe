#include "base/files.h"

#include <cstdlib>
#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "base/error.h"

namespace lightbench {
namespace {

namespace fs = std::filesystem;

TEST(Files, AtomicWriteMakesFoldersAndReplaces) {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "a" / "b.txt";
  write_file_atomic(file, "one");
  write_file_atomic(file, "two");
  EXPECT_EQ(read_file(file), "two");
  EXPECT_EQ(std::distance(fs::directory_iterator(file.parent_path()), {}), 1);
}

TEST(Files, AFileInThePlaceOfAFolderIsAnError) {
  const TemporaryFolder folder;
  write_file_atomic(folder.path() / "file", "");
  EXPECT_THROW(write_file_atomic(folder.path() / "file" / "below", ""), Error);
}

TEST(Files, NamesCannotLeaveTheirFolder) {
  EXPECT_EQ(escape_file_name("../../etc/passwd"), "%2E.%2F..%2Fetc%2Fpasswd");
  EXPECT_EQ(escape_file_name("a b"), "a%20b");
  EXPECT_EQ(escape_file_name(""), "%");
  EXPECT_EQ(escape_file_name("isr-48[radius=0.5]"), "isr-48[radius=0.5]");
}

RC_GTEST_PROP(Files, EscapedNamesAreSafeAndDistinct, (const std::string& a, const std::string& b)) {
  const std::string escaped = escape_file_name(a);
  RC_ASSERT(!escaped.empty() && escaped.size() <= 120);
  RC_ASSERT(escaped.find('/') == std::string::npos && escaped.front() != '.');
  RC_ASSERT((a == b) == (escaped == escape_file_name(b)));
}

TEST(Files, LongNamesKeepApart) {
  const std::string longer(300, 'x');
  EXPECT_LE(escape_file_name(longer).size(), 120u);
  EXPECT_NE(escape_file_name(longer), escape_file_name(longer + "y"));
}

TEST(Files, ReservedBytesAreEscapedBeforeANameIsCut) {
  EXPECT_EQ(escape_file_name("a~b", "~"), "a%7Eb");
  EXPECT_EQ(escape_file_name("a~b"), "a~b");
  EXPECT_LE(escape_file_name(std::string(85, '~'), "~").size(), 120u);
}

TEST(Files, OnlyOurOwnVariablesStandInPaths) {
  ::setenv("LIGHTBENCH_TEST_PLACE", "/place", 1);
  EXPECT_EQ(resolve_path("${LIGHTBENCH_TEST_PLACE}/a.obj", "/base", "here"), "/place/a.obj");
  EXPECT_EQ(resolve_path("b/../a.obj", "/base", "here"), "/base/a.obj");
  EXPECT_THROW(resolve_path("${HOME}/a", "/base", "here"), Error);
  EXPECT_THROW(resolve_path("${LIGHTBENCH_NOT_SET_AT_ALL}/a", "/base", "here"), Error);
  EXPECT_THROW(resolve_path("${LIGHTBENCH_TEST_PLACE", "/base", "here"), Error);
}

TEST(Files, AFolderMayBeNamedLikeAVariable) {
  EXPECT_EQ(resolve_path("a.obj", "/jobs/${HOME}", "here"), "/jobs/${HOME}/a.obj");
  EXPECT_EQ(resolve_path("$${HOME}/a.obj", "/jobs", "here"), "/jobs/${HOME}/a.obj");
}

RC_GTEST_PROP(Files, UnresolvedPathsResolveToThemselves, ()) {
  const auto part = rc::gen::element<std::string>("$", "{", "}", "x", "HOME", "LIGHTBENCH_X");
  const auto parts = *rc::gen::container<std::vector<std::string>>(part);
  std::string path = "/";
  for (const std::string& piece : parts) path += piece;
  RC_ASSERT(resolve_path(unresolved(path), "/base", "here") == path);
  RC_ASSERT(resolve_pattern(unresolved(path), "/base", "here") == path);
}

TEST(Files, BracesOfAFolderAreDoubledInAPattern) {
  ::setenv("LIGHTBENCH_TEST_PLACE", "/a{b", 1);
  EXPECT_EQ(resolve_pattern("{view}.png", "/jobs/{old}", "here"), "/jobs/{{old}/{view}.png");
  EXPECT_EQ(resolve_pattern("${LIGHTBENCH_TEST_PLACE}/{view}.png", "/jobs", "here"), "/a{{b/{view}.png");
  EXPECT_EQ(resolve_pattern("x/../{view}.png", "/jobs", "here"), "/jobs/{view}.png");
}

}  // namespace
}  // namespace lightbench
