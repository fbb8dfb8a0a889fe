#include "base/process.h"

#include <csignal>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "base/files.h"

namespace lightbench {
namespace {

using namespace std::chrono_literals;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

ProcessOptions shell(const std::string& script) {
  return {.argv = {"sh", "-c", script}};
}

TEST(Process, OutputErrorAndExitCodeAreKept) {
  const auto result = run_process(shell("echo out; echo err >&2; exit 3"));
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_EQ(result.out, "out\n");
  EXPECT_EQ(result.err, "err\n");
  EXPECT_EQ(result.describe(), "exit code 3");
}

TEST(Process, ArgumentsAreNotAShell) {
  const auto result = run_process({.argv = {"printf", "%s", "$(id) `id`; 'x'"}});
  EXPECT_EQ(result.out, "$(id) `id`; 'x'");
}

TEST(Process, FolderAndEnvironmentAreTheChildsOwn) {
  const TemporaryFolder folder;
  auto options = shell("pwd; echo $LIGHTBENCH_X");
  options.working_directory = folder.path();
  options.environment["LIGHTBENCH_X"] = "seven";
  EXPECT_EQ(run_process(options).out, folder.path().string() + "\nseven\n");
}

TEST(Process, ASignalIsToldApart) {
  const auto result = run_process(shell("kill -SEGV $$"));
  EXPECT_EQ(result.signal, SIGSEGV);
  EXPECT_THAT(result.describe(), HasSubstr("signal 11"));
}

TEST(Process, TimeoutEndsTheWholeGroupEvenWhereTermIsIgnored) {
  const TemporaryFolder folder;
  auto options = shell("trap '' TERM; (trap '' TERM; sleep 30; touch late) & sleep 30");
  options.working_directory = folder.path();
  options.timeout = 100ms;
  const auto result = run_process(options);
  EXPECT_TRUE(result.timed_out);
  EXPECT_EQ(result.signal, SIGKILL);
  EXPECT_THAT(result.describe(), HasSubstr("timed out"));
}

TEST(Process, AnOrphanHoldingThePipeDoesNotHoldUs) {
  const auto result = run_process(shell("sleep 30 & echo done"));
  EXPECT_EQ(result.out, "done\n");
  EXPECT_LT(result.seconds, 20);
}

TEST(Process, MissingProgramsAreErrors) {
  EXPECT_THROW(run_process({.argv = {"no-such-program-anywhere"}}), Error);
  EXPECT_THROW(run_process({.argv = {"/etc/passwd"}}), Error);
  EXPECT_TRUE(find_program("sh").is_absolute());
}

TEST(Process, OnlyTheLastBytesOfALongOutputAreKept) {
  auto options = shell("yes abcdefghi | head -n 200000; echo end");
  options.keep_output = 1000;
  const auto result = run_process(options);
  EXPECT_EQ(result.out.size(), 1000u);
  EXPECT_TRUE(result.out.ends_with("end\n"));
}

TEST(Process, CpuTimeIsThatOfTheChild) {
  const auto busy = run_process(shell("i=0; while [ $i -lt 100000 ]; do i=$((i+1)); done"));
  const auto idle = run_process(shell("sleep 0.3"));
  EXPECT_GT(busy.cpu_seconds, idle.cpu_seconds);
}

TEST(Process, OwnCpuTimeHoldsThatOfChildren) {
  const double before = own_cpu_seconds();
  const auto busy = run_process(shell("i=0; while [ $i -lt 100000 ]; do i=$((i+1)); done"));
  EXPECT_GE(own_cpu_seconds() - before, busy.cpu_seconds);
}

TEST(ProcessLoop, HandsOverLinesAndStartsFurtherChildren) {
  ProcessLoop loop;
  std::vector<std::string> lines;
  const auto on_line = [&](std::string_view line) { lines.emplace_back(line); };
  loop.start(shell("echo one; echo two"), on_line,
             [&](const ProcessResult&) { loop.start(shell("echo three"), on_line, nullptr); });
  loop.run();
  EXPECT_THAT(lines, ElementsAre("one", "two", "three"));
}

TEST(Process, InputIsReadToItsEnd) {
  const std::string megabytes(5'000'000, 'x');
  auto options = shell("cat; echo; cat | wc -c");
  options.input = megabytes;
  options.keep_output = 10'000'000;
  EXPECT_EQ(run_process(options).out, megabytes + "\n0\n");
  EXPECT_EQ(run_process(shell("wc -c")).out, "0\n");
}

TEST(Process, AChildNeedNotReadItsInput) {
  auto options = shell("exit 3");
  options.input = std::string(5'000'000, 'x');
  EXPECT_EQ(run_process(options).exit_code, 3);
}

TEST(ProcessLoop, OfALineThatIsTooLongOnlyTheStartIsHandedOver) {
  ProcessLoop loop;
  std::vector<std::string> lines;
  auto options = shell("head -c 1000000 /dev/zero | tr '\\0' x; echo; echo next; printf unfinished");
  options.longest_line = 1000;
  loop.start(
      options, [&](std::string_view line) { lines.emplace_back(line); }, nullptr);
  loop.run();
  EXPECT_THAT(lines, ElementsAre(std::string(1000, 'x'), "next"));
}

TEST(ProcessLoop, SignalsThatWeIgnoreStayIgnored) {
  for (const int signal : {SIGHUP, SIGINT, SIGTERM}) {
    const auto before = std::signal(signal, SIG_IGN);
    ProcessLoop loop;
    const TemporaryFolder folder;
    auto options = shell("while [ ! -e raised ]; do sleep 0.01; done");
    options.working_directory = folder.path();
    ProcessResult result;
    loop.start(options, nullptr, [&](const ProcessResult& r) { result = r; });
    loop.every(10ms, [&] {
      std::raise(signal);
      write_file_atomic(folder.path() / "raised", "");
    });
    loop.run();
    EXPECT_FALSE(loop.interrupted());
    EXPECT_TRUE(result.ok()) << result.describe();
    EXPECT_EQ(std::signal(signal, before), SIG_IGN);
  }
}

TEST(ProcessLoop, ChildrenRunSideBySide) {
  const TemporaryFolder folder;
  ProcessLoop loop;
  // Each waits for the other's file: one after the other they would never end.
  for (const char* script :
       {"touch a; while [ ! -e b ]; do sleep 0.01; done", "touch b; while [ ! -e a ]; do sleep 0.01; done"}) {
    auto options = shell(script);
    options.working_directory = folder.path();
    options.timeout = 20s;
    loop.start(options, nullptr, [](const ProcessResult& result) { EXPECT_TRUE(result.ok()); });
  }
  loop.run();
}

TEST(ProcessLoop, AnInterruptEndsTheChildren) {
  ProcessLoop loop;
  ProcessResult result;
  loop.start(shell("sleep 30"), nullptr, [&](const ProcessResult& r) { result = r; });
  loop.every(50ms, [sent = false]() mutable {
    if (!sent) std::raise(SIGINT);
    sent = true;
  });
  loop.run();
  EXPECT_TRUE(loop.interrupted());
  EXPECT_EQ(result.signal, SIGTERM);
}

TEST(Process, OneThatWorksIsNotIdle) {
  const auto result = run_process(
      {.argv = {"sh", "-c", "end=$(($(date +%s) + 2)); while [ $(date +%s) -lt $end ]; do :; done"},
       .idle_timeout = std::chrono::milliseconds(800)});
  EXPECT_TRUE(result.ok()) << result.describe();
}

TEST(Process, OneThatRestsIsEnded) {
  const auto result = run_process({.argv = {"sleep", "60"}, .idle_timeout = std::chrono::milliseconds(200)});
  EXPECT_TRUE(result.stalled);
  EXPECT_THAT(result.describe(), testing::HasSubstr("stalled"));
}

}  // namespace
}  // namespace lightbench
