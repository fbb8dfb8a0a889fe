#include <csignal>

#include "e2e_fixture.h"

/// What can happen to POV-Ray: the row of its view says it, nothing else is lost, and --retry-failed makes up
/// for it.
namespace lightbench {
namespace {

using ::testing::AllOf;
using ::testing::AnyOf;
using ::testing::HasSubstr;
using ::testing::Not;
using Json = nlohmann::json;

/// A job of two views; the fault happens to the view `front`.
class FaultyReference : public test::Program {
 protected:
  void write_job(const std::string& reference = "") const {
    write("job.json", R"({"name": "job", "size": [32, 24],
      "scenes": [{"name": "box", "scene": "scene.json", "cameras": "cameras.json"}],
      "variants": [{"name": "direct", "technique": "direct", "params": {"shadows": "none"}}],
      "references": [{"name": "truth", "kind": "povray")" +
                          reference + R"(}], "metrics": ["mean_error"]})");
  }

  /// Runs the job; one row fails, everything else is there.
  Json row_of_fault() const {
    const auto result = run({"run", "job.json", "--out", "out"});
    EXPECT_EQ(result.exit_code, 2) << result.out << result.err;
    const Json report = Json::parse(read_file(path("out/run.json")));
    Json fault;
    for (const Json& image : report.at("images")) {
      const bool is_fault = image.at("view") == "front" && image.at("is_reference").get<bool>();
      if (is_fault) fault = image;
      EXPECT_EQ(image.at("outcome"), is_fault ? "failed" : "ok") << image;
    }
    for (const Json& score : report.at("scores"))
      EXPECT_EQ(score.at("outcome"), score.at("view") == "front" ? "skipped" : "ok") << score;
    EXPECT_FALSE(std::filesystem::exists(path("out/views/box/front/truth.exr")));
    for (const auto& file : files("out")) EXPECT_THAT(file, Not(HasSubstr("tmp")));
    return fault;
  }

  void expect_retry_makes_up_for_it() const {
    const auto result = run({"run", "job.json", "--out", "out", "--retry-failed"});
    EXPECT_EQ(result.exit_code, 0) << result.out << result.err;
    EXPECT_THAT(result.out, HasSubstr("2 tasks to do"));  // the reference and its score
    const Json report = Json::parse(read_file(path("out/run.json")));
    for (const Json& image : report.at("images")) EXPECT_EQ(image.at("outcome"), "ok") << image;
  }
};

class GlFakeFault : public FaultyReference {
 protected:
  GlFakeFault() { write_job(R"(, "timeout": 2)"); }

  std::string error_after(const std::string& script) {
    fake_povray("case \"$(readlink scene.pov)\" in */front/*) " + script + ";; esac\n" + copy_picture());
    const std::string error = row_of_fault().at("error");
    fake_povray(copy_picture());
    return error;
  }
};

TEST_F(GlFakeFault, Killed) {
  EXPECT_THAT(error_after("kill -9 $$"), HasSubstr("povray killed by signal 9"));
  expect_retry_makes_up_for_it();
}

TEST_F(GlFakeFault, Hanging) {
  EXPECT_THAT(error_after("sleep 60"), HasSubstr("povray timed out"));
  expect_retry_makes_up_for_it();
}

TEST_F(GlFakeFault, OutOfMemory) {
  EXPECT_THAT(error_after("echo 'Fatal error: Out of memory.' >&2; exit 1"),
              AllOf(HasSubstr("exit code 1"), HasSubstr("Out of memory")));
  expect_retry_makes_up_for_it();
}

TEST_F(GlFakeFault, OutOfDisk) {
  EXPECT_THAT(error_after("head -c 40 '" + path("grey.exr").string() + "' > \"$image\"; exit 0"),
              HasSubstr("image.exr"));
  expect_retry_makes_up_for_it();
}

TEST_F(GlFakeFault, WithoutAnImage) {
  EXPECT_THAT(error_after("exit 0"), HasSubstr("wrote no image"));
  expect_retry_makes_up_for_it();
}

TEST_F(GlFakeFault, MissingIsToldBeforeAnyWorkAndLosesNothing) {
  fake_povray(copy_picture());
  run({"run", "job.json", "--out", "out", "--only", "box/side"});
  environment_["LIGHTBENCH_POVRAY"] = path("absent").string();
  const auto result = run({"run", "job.json", "--out", "out"});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.err, HasSubstr("POV-Ray is not there"));
  EXPECT_TRUE(std::filesystem::exists(path("out/views/box/side/truth.exr")));
}

TEST_F(GlFakeFault, AnotherVersionIsToldApart) {
  fake_povray(copy_picture());
  ASSERT_EQ(run({"run", "job.json", "--out", "out"}).exit_code, 0);
  std::string program = read_file(path("povray"));
  write("povray", program.replace(program.find("3.7.fake"), 8, "3.8.fake"));
  std::filesystem::permissions(path("povray"), std::filesystem::perms::owner_all);
  const auto plan = run({"plan", "job.json", "--out", "out", "--explain"});
  EXPECT_THAT(plan.out, HasSubstr("reference:box/front/truth  to do: changed: tool"));
  EXPECT_THAT(plan.out, HasSubstr("snapshot:box/front/direct  there already"));
  ASSERT_EQ(run({"run", "job.json", "--out", "out"}).exit_code, 0);
  EXPECT_EQ(read_image_metadata(path("out/views/box/front/truth.exr")).at("lightbench:tool"),
            "POV-Ray 3.8.fake");
}

TEST_F(GlFakeFault, NothingToRetryIsNoError) {
  fake_povray(copy_picture());
  ASSERT_EQ(run({"run", "job.json", "--out", "out"}).exit_code, 0);
  const auto result = run({"run", "job.json", "--out", "out", "--retry-failed"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_THAT(result.out, HasSubstr("nothing to retry"));
}

/// The real program, started by a script that does something to it on the view `front`.
class PovrayFault : public FaultyReference {
 protected:
  PovrayFault() { write_job(R"(, "preset": "direct")"); }

  void wrap(const std::string& on_front) {
    write("povray", "#!/bin/sh\ncase \"$(readlink scene.pov 2>/dev/null)\" in */front/*) " + on_front +
                        ";; esac\nexec '" + find_program("povray").string() + "' \"$@\"\n");
    std::filesystem::permissions(path("povray"), std::filesystem::perms::owner_all);
    environment_["LIGHTBENCH_POVRAY"] = path("povray").string();
  }
  std::string error_with(const std::string& on_front) {
    wrap(on_front);
    const std::string error = row_of_fault().at("error");
    wrap("true");
    return error;
  }
};

TEST_F(PovrayFault, Killed) {
  EXPECT_THAT(error_with("(sleep 0.05; kill -9 $$) &"), HasSubstr("povray killed by signal 9"));
  expect_retry_makes_up_for_it();
}

TEST_F(PovrayFault, Hanging) {
  write_job(R"(, "preset": "direct", "timeout": 1)");
  EXPECT_THAT(error_with("(sleep 0.02; kill -STOP $$) &"), HasSubstr("timed out"));
  write_job(R"(, "preset": "direct")");
  expect_retry_makes_up_for_it();
}

TEST_F(PovrayFault, OutOfMemory) {
  write_job(R"(, "preset": "direct", "timeout": 5)");
  // It cannot start a thread: it aborts, or waits until it is ended.
  EXPECT_THAT(error_with("ulimit -v 60000"),
              AnyOf(HasSubstr("killed by signal"), HasSubstr("timed out"), HasSubstr("exit code")));
  expect_retry_makes_up_for_it();
}

TEST_F(PovrayFault, OutOfDisk) {
  EXPECT_THAT(error_with("ulimit -f 0"), HasSubstr("povray"));
  expect_retry_makes_up_for_it();
}

}  // namespace
}  // namespace lightbench
