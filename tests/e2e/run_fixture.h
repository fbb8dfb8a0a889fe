#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "e2e_fixture.h"

namespace lightbench::test {

/// Runs of a small job with a stand-in for POV-Ray.
class GlRun : public Program {
 protected:
  GlRun() {
    write_job("");
    fake_povray(copy_picture());
  }

  /// `more` goes into the job as further keys.
  void write_job(const std::string& more) const {
    write("job.json", R"({"name": "job", "size": [32, 24],
      "scenes": [{"name": "box", "scene": "scene.json", "cameras": "cameras.json"}],
      "variants": [{"name": "direct", "technique": "direct", "params": {"shadows": "none"}},
                   {"name": "lit", "technique": "ambient", "params": {"shadows": "none"}}],
      "references": [{"name": "truth", "kind": "povray"}])" +
                          more + "}");
  }

  ProcessResult run_job(std::vector<std::string> more = {}) const {
    more.insert(more.begin(), {"run", "job.json", "--out", "out"});
    return run(more);
  }
  nlohmann::json report() const { return nlohmann::json::parse(read_file(path("out/run.json"))); }

  std::size_t lines_of_ledger() const {
    const std::string text = read_file(path("out/ledger.jsonl"));
    return std::size_t(std::count(text.begin(), text.end(), '\n'));
  }
  std::size_t pictures(const std::string& ending) const {
    std::size_t count = 0;
    for (const auto& file : files("out")) count += file.ends_with(ending);
    return count;
  }

  static constexpr std::size_t kTasks = 13;  // 4 snapshots, 2 references, 3 exports, 4 scores
};

}  // namespace lightbench::test
