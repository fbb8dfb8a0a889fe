#include "pipeline/progress.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace lightbench {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// What a run of two tasks, one of which fails, writes.
std::string text_of(Progress::Style style, const std::string& failure = "no light") {
  char* data = nullptr;
  std::size_t size = 0;
  std::FILE* stream = open_memstream(&data, &size);
  std::vector<Task> tasks(2);
  tasks[0].id = "snapshot:a/b/c";
  tasks[1].id = "snapshot:a/b/d";
  Schedule schedule(tasks, {1, 1});
  Progress progress(stream, style, 1);
  progress.begin(schedule);
  schedule.next_batch(1, 0, false);
  schedule.next_batch(1, 0, false);
  progress.started(tasks[0]);
  schedule.done(0);
  progress.ended(tasks[0], {TaskState::done, "", 1, LedgerEntry{}});
  schedule.fail(1, failure);
  progress.ended(tasks[1], {TaskState::failed, failure, 1, std::nullopt});
  progress.finish();
  std::fclose(stream);
  const std::string text(data, size);
  free(data);
  return text;
}

TEST(ProgressLine, PlainLinesHaveNoControlCharacters) {
  const std::string text = text_of(Progress::Style::lines);
  EXPECT_THAT(text, HasSubstr("snapshot:a/b/c done"));
  EXPECT_THAT(text, HasSubstr("[1/2"));
  EXPECT_THAT(text, Not(HasSubstr("\x1b")));
  EXPECT_THAT(text, Not(HasSubstr("\r")));
}

TEST(ProgressLine, ATerminalSeesOneLineAndEveryFailure) {
  const std::string text = text_of(Progress::Style::terminal);
  EXPECT_THAT(text, HasSubstr("\r\x1b[K [1/2"));
  EXPECT_THAT(text, Not(HasSubstr("snapshot:a/b/c done")));
  EXPECT_THAT(text, HasSubstr("snapshot:a/b/d FAILED: no light\n"));
}

TEST(ProgressLine, AFailureCannotSteerATerminal) {
  const std::string text = text_of(Progress::Style::lines, "no \x1b]0;title\x07light\xff\u202E");
  EXPECT_THAT(text, HasSubstr("FAILED: no \uFFFD]0;title\uFFFDlight\uFFFD\uFFFD\n"));
}

TEST(ProgressLine, TheEndHasTheCounts) {
  EXPECT_THAT(text_of(Progress::Style::lines), HasSubstr("1 done, 0 there already, 1 failed, 0 skipped"));
}

}  // namespace
}  // namespace lightbench
