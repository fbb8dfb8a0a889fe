#include "reports/shared_warnings.h"

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "base/text.h"

namespace lightbench {
namespace {

constexpr std::size_t kNamed = 3;

class Sharing {
 public:
  void add(const std::vector<std::string>& texts, const std::string& about) {
    for (const std::string& text : texts) {
      const auto [position, is_new] = index_.try_emplace(text, warnings_.size());
      if (is_new) warnings_.push_back({text, {}});
      if (!about.empty()) warnings_[position->second].about.push_back(about);
    }
  }

  std::vector<SharedWarning> take() { return std::move(warnings_); }

 private:
  std::map<std::string, std::size_t> index_;
  std::vector<SharedWarning> warnings_;
};

}  // namespace

std::vector<SharedWarning> shared_warnings(const RunReport& report) {
  Sharing sharing;
  sharing.add(report.warnings, "");
  for (const ReportScene& scene : report.scenes) sharing.add(scene.warnings, scene.name);
  for (const ReportImage& image : report.images)
    sharing.add(image.warnings, fmt::format("{}/{} {}", image.scene, image.view, image.source));
  for (const ReportScore& score : report.scores)
    sharing.add(score.warnings,
                fmt::format("{}/{} {} against {}", score.scene, score.view, score.variant, score.reference));
  return sharing.take();
}

std::string about_text(const SharedWarning& warning) {
  const std::size_t named = std::min(warning.about.size(), kNamed);
  const std::vector<std::string> names(warning.about.begin(), warning.about.begin() + std::ptrdiff_t(named));
  const std::size_t others = warning.about.size() - named;
  return join(names, ", ") + (others > 0 ? fmt::format(" and {} more", others) : "");
}

}  // namespace lightbench
