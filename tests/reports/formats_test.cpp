#include <cstdlib>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/files.h"
#include "reports/escape.h"
#include "reports/report_formats.h"
#include "reports/verdict.h"
#include "tests/base/small_disk.h"
#include "tests/reports/sample_run.h"

namespace lightbench {
namespace {

using test::kHostileScene;
using test::sample_run;
using testing::HasSubstr;
using testing::Not;

std::string written(const std::string& format, const RunReport& run = sample_run()) {
  for (const ReportFormat& row : report_formats())
    if (row.name == format) {
      const auto files = row.write(run);
      return files.empty() ? "" : files.front().text;
    }
  ADD_FAILURE() << "no format " << format;
  return "";
}

/// Compares with the approved text; LIGHTBENCH_APPROVE=1 makes the text the approved one.
void expect_approved(const std::string& name, const std::string& text) {
  const std::filesystem::path file = std::filesystem::path(LIGHTBENCH_TEST_DATA) / "reports" / name;
  if (std::getenv("LIGHTBENCH_APPROVE")) write_file_atomic(file, text);
  EXPECT_EQ(text, read_file(file)) << "differs from " << file;
}

std::string between(const std::string& text, const std::string& begin, const std::string& end) {
  const std::size_t from = text.find(begin) + begin.size();
  return text.substr(from, text.find(end, from) - from);
}

TEST(ReportFormats, JsonIsAsApproved) {
  expect_approved("run.json", written("json"));
}

TEST(ReportFormats, JunitIsAsApproved) {
  expect_approved("junit.xml", written("junit"));
}

TEST(ReportFormats, MarkdownIsAsApproved) {
  expect_approved("summary.md", written("markdown"));
}

TEST(ReportFormats, ResIsAsApproved) {
  expect_approved("res.txt", written("res"));
}

TEST(ReportFormats, HtmlBodyIsAsApproved) {
  // Without the style and the script, which are files of their own.
  expect_approved("index_main.html", between(written("html"), "<body>\n", "<script>"));
}

TEST(ReportFormats, TerminalSummaryIsAsApproved) {
  expect_approved("terminal.txt", terminal_summary(sample_run()));
}

TEST(ReportFormats, AllAreWrittenIntoTheFolder) {
  const TemporaryFolder folder;
  write_reports(sample_run(), folder.path());
  for (const char* name : {"index.html", "run.json", "junit.xml", "summary.md", "res-isr-48.txt"})
    EXPECT_TRUE(std::filesystem::exists(folder.path() / name)) << name;
}

TEST(ReportFormats, OnlyTheNamedOnesAreWritten) {
  const TemporaryFolder folder;
  write_reports(sample_run(), folder.path(), {"junit"});
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "junit.xml"));
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "run.json"));
}

TEST(ReportFormats, OnAFullDiskAReportIsWholeOrTheOldOne) {
  if (!test::with_small_disk([&](const test::SmallDisk& disk) {
        test::expect_whole_or_old(disk, "run.json", [&](const std::filesystem::path& file) {
          write_reports(sample_run(), file.parent_path(), {"json"});
        });
      }))
    GTEST_SKIP() << test::kNoMounts;
}

TEST(ReportFormats, UnknownFormatIsAnErrorBeforeAnythingIsWritten) {
  const TemporaryFolder folder;
  EXPECT_THROW(write_reports(sample_run(), folder.path(), {"json", "htlm"}), Error);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(ReportFormats, AnEmptyRunCanBeWritten) {
  for (const ReportFormat& format : report_formats()) EXPECT_NO_THROW(format.write({})) << format.name;
  EXPECT_EQ(terminal_summary({}), "Finished\n");
}

TEST(HtmlReport, HostileTextStaysText) {
  const std::string page = written("html");
  EXPECT_THAT(page, Not(HasSubstr("<img src=x")));
  EXPECT_THAT(page, Not(HasSubstr("<b>bold</b>")));
  EXPECT_THAT(page, HasSubstr("&lt;img src=x onerror=alert(1)&gt;"));
}

TEST(HtmlReport, EmbeddedDataIsJsonThatCannotCloseItsElement) {
  const std::string data =
      between(written("html"), "<script type=\"application/json\" id=\"run-data\">", "</script>");
  const auto json = nlohmann::json::parse(data);
  // The same text as the page's attributes, which the script compares with it.
  EXPECT_EQ(json["views"][1]["name"], clean_utf8(std::string(kHostileScene) + "/" + test::kHostileView));
}

TEST(HtmlReport, PathsArePercentEncoded) {
  EXPECT_THAT(written("html"), HasSubstr("src=\"views/%253C/a%20b%23%3F/direct.png\""));
}

TEST(HtmlReport, NeedsNoNetwork) {
  const std::string page = written("html");
  for (const char* address : {"http:", "https:", "src=\"//", "@import", "fetch("})
    EXPECT_THAT(page, Not(HasSubstr(address))) << address;
}

TEST(HtmlReport, PicturesAreLoadedWhenShown) {
  const std::string page = between(written("html"), "<main>", "</main>");
  for (std::size_t at = page.find("<img"); at != std::string::npos; at = page.find("<img", at + 1))
    EXPECT_THAT(page.substr(at, page.find('>', at) - at), HasSubstr("loading=\"lazy\""));
}

TEST(JunitReport, HasNoByteThatXmlForbids) {
  const std::string text = written("junit");
  for (const char c : text) EXPECT_TRUE(c == '\n' || static_cast<unsigned char>(c) >= 0x20);
  EXPECT_THAT(text, Not(HasSubstr("]]>")));
}

TEST(JunitReport, CountsFailuresAndErrors) {
  const std::string text = written("junit");
  EXPECT_THAT(
      text,
      HasSubstr(
          "<testsuites name=\"rooms &amp; more\" tests=\"21\" failures=\"1\" errors=\"3\" skipped=\"1\""));
}

TEST(JunitReport, NamesHoldNoThreshold) {
  RunReport run;
  run.variants.push_back({"isr", "isr", {}, 0, false, ""});
  for (const double bound : {10, 20}) {
    Gate gate;
    gate.metric = "gain";
    gate.variant = "isr";
    gate.over = Gate::Over::mean;
    gate.min = bound;
    run.gates = {evaluate_gate(gate, run)};
    EXPECT_THAT(written("junit", run), HasSubstr("classname=\"gate\" name=\"gain of isr, mean, min\""))
        << bound;
  }
}

TEST(JunitReport, HasACaseForEachViewOfAGate) {
  const std::string text = written("junit");
  EXPECT_THAT(text, HasSubstr("name=\"gain of isr-48, each view, min: office/desk\" time=\"0.000\"/>"));
  EXPECT_THAT(text, HasSubstr("<failure type=\"gate not met\""));
}

TEST(MarkdownReport, HostileTextCannotMakeCellsOrMarkup) {
  const std::string text = written("markdown");
  EXPECT_THAT(text, Not(HasSubstr("<b>")));
  EXPECT_THAT(text, HasSubstr("a\\|b"));
}

TEST(MarkdownReport, StaysSmallForAHugeRun) {
  RunReport run = sample_run();
  const std::string long_text(5000, '|');
  for (int i = 0; i < 3000; ++i) {
    run.variants.push_back({"v" + std::to_string(i) + long_text, "isr", {}, 0, false, ""});
    run.gates.push_back({long_text, GateState::not_met, long_text});
    run.scores.push_back(run.scores[3]);
    run.scores.back().error = long_text;
    run.bakes.push_back(run.bakes[0]);
    run.bakes.back().scene = std::to_string(i % 100) + long_text;
    run.bakes.back().object = long_text;
    run.compressions.push_back(run.compressions[1]);
    run.compressions.back().error = long_text;
  }
  EXPECT_LT(written("markdown", run).size(), std::size_t(1) << 20);
}

TEST(ResReport, NamesHaveNoBlanks) {
  const std::string text = written("res");
  EXPECT_THAT(text, testing::StartsWith("office/desk 0.9 8\t0.95 6\tc:OK\tm:OK\n"));
  EXPECT_THAT(text, testing::EndsWith("\n0.9 vs. 0.95\n8 vs. 6\n"));
}

TEST(ResReport, OneFileForEachVariant) {
  RunReport run = sample_run();
  run.variants.push_back({"a b", "isr", {}, 1, false, ""});
  for (const ReportFormat& row : report_formats()) {
    if (row.name != "res") continue;
    const auto files = row.write(run);
    ASSERT_EQ(files.size(), 3u);
    EXPECT_EQ(files[0].name, "res-isr-48.txt");
    EXPECT_EQ(files[2].name, "res-a%20b.txt");
    EXPECT_EQ(files[2].text, "undefined vs. undefined\nundefined vs. undefined\n");
  }
}

TEST(ResReport, IsNotWrittenWithoutABaseline) {
  RunReport run = sample_run();
  run.baseline.clear();
  EXPECT_EQ(written("res", run), "");
}

TEST(TerminalSummary, HasNoControlCharacters) {
  for (const char c : terminal_summary(sample_run()))
    EXPECT_TRUE(c == '\n' || static_cast<unsigned char>(c) >= 0x20);
}

}  // namespace
}  // namespace lightbench
