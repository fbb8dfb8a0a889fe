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

  /// Adds a variant of another engine's pictures, mine/<scene>-<view>.png, of one grey.
  void add_pictures(std::uint8_t grey) const {
    for (const char* view : {"front", "side"})
      write_png(path(std::string("mine/box-") + view + ".png"), Image8(32, 24, 3, grey));
    std::string text = read_file(path("job.json"));
    const std::string place = R"("variants": [)";
    write("job.json",
          text.replace(text.find(place), place.size(), place + R"({"name": "mine", "technique": "images",
                                             "params": {"pattern": "mine/{scene}-{view}.png"}},)"));
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

  /// Files of the run that have this in their names.
  std::size_t files_called(const std::string& part) const {
    const auto all = files("out");
    return std::size_t(
        std::ranges::count_if(all, [&](const std::string& file) { return file.find(part) != file.npos; }));
  }

  static constexpr std::size_t kTasks = 13;  // 4 snapshots, 2 references, 3 exports, 4 scores
};

}  // namespace lightbench::test
