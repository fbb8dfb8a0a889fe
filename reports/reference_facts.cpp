#include "reports/reference_facts.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/text.h"
#include "reports/value_text.h"

namespace lightbench {
namespace {

const ReportImage* image_of(const RunReport& report, const ReportImage& same_view,
                            const std::string& source) {
  const auto found = std::ranges::find_if(report.images, [&](const ReportImage& image) {
    return image.is_reference && image.source == source && image.scene == same_view.scene &&
           image.view == same_view.view;
  });
  return found == report.images.end() || found->outcome != Outcome::ok ? nullptr : &*found;
}

/// The mean of values that come one by one.
struct Mean {
  double sum = 0;
  std::size_t count = 0;

  void add(double value) {
    sum += value;
    ++count;
  }
  std::optional<double> value() const {
    return count == 0 ? std::nullopt : std::optional(sum / double(count));
  }
};

std::optional<double> light_share(const RunReport& report, const ReportImage& image,
                                  const ReportImageSource& fullest) {
  const ReportImage* other = image_of(report, image, fullest.name);
  if (!other || !image.mean_luminance || !other->mean_luminance || !(*other->mean_luminance > 0))
    return std::nullopt;
  return *image.mean_luminance / *other->mean_luminance;
}

ReferenceFacts facts_of(const RunReport& report, const ReportImageSource& reference,
                        const ReportImageSource* fullest) {
  ReferenceFacts facts;
  facts.name = reference.name;
  facts.kind = reference.kind;
  facts.bounces = reference.bounces;
  Mean noise, share, seconds;
  for (const ReportImage& image : report.images) {
    if (!image.is_reference || image.source != reference.name || image.outcome != Outcome::ok) continue;
    ++facts.views;
    seconds.add(image.seconds);
    facts.cpu_seconds += image.cpu_seconds;
    if (image.noise) {
      noise.add(*image.noise);
      facts.worst_noise = std::max(facts.worst_noise.value_or(0), *image.noise);
    }
    if (!fullest || fullest->name == reference.name) continue;
    if (const auto part = light_share(report, image, *fullest)) share.add(*part);
  }
  facts.noise = noise.value();
  facts.light_share = share.value();
  facts.seconds = seconds.value().value_or(0);
  return facts;
}

}  // namespace

const ReportImageSource* fullest_reference(const RunReport& report) {
  const auto [least, most] = std::ranges::minmax_element(report.references, {}, &ReportImageSource::bounces);
  if (least == report.references.end() || least->bounces == most->bounces) return nullptr;
  return &*most;
}

std::vector<ReferenceFacts> reference_facts(const RunReport& report) {
  const ReportImageSource* fullest = fullest_reference(report);
  std::vector<ReferenceFacts> facts;
  for (const ReportImageSource& reference : report.references)
    facts.push_back(facts_of(report, reference, fullest));
  return facts;
}

std::vector<std::string> bounces_lines(const RunReport& report) {
  std::vector<std::string> lines;
  for (const ReportImageSource& reference : report.references) {
    std::vector<std::string> others;
    for (const ReportImageSource& variant : report.variants)
      if (!variant.external && variant.bounces != reference.bounces)
        others.push_back(fmt::format("{} {}", variant.name, variant.bounces));
    if (!others.empty())
      lines.push_back(fmt::format("{} has {} of indirect light; other numbers: {}", reference.name,
                                  counted(std::size_t(reference.bounces), "bounce"), join(others, ", ")));
  }
  return lines;
}

std::vector<std::string> light_share_lines(const RunReport& report) {
  const ReportImageSource* fullest = fullest_reference(report);
  std::vector<std::string> lines;
  for (const ReferenceFacts& facts : reference_facts(report))
    if (facts.light_share)
      lines.push_back(fmt::format("{} ({}) has {:.1f} % of the light of {} ({})", facts.name,
                                  counted(std::size_t(facts.bounces), "bounce"), 100 * *facts.light_share,
                                  fullest->name, counted(std::size_t(fullest->bounces), "bounce")));
  return lines;
}

}  // namespace lightbench
