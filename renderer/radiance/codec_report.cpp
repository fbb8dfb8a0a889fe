#include "renderer/radiance/codec_report.h"

#include <algorithm>
#include <array>
#include <cstdlib>

#include "base/error.h"

namespace lightbench {
namespace {

/// How many values have which sum of errors over their components.
using ErrorCounts = std::array<std::uint64_t, 3 * 255 + 1>;

void measure_errors(const ErrorCounts& counts, std::uint64_t values, CodecReport& report) {
  std::uint64_t sum = 0, seen = 0;
  for (std::size_t error = 0; error < counts.size(); ++error) {
    if (counts[error] == 0) continue;
    sum += error * counts[error];
    if (100 * seen < 99 * values) report.error_99 = double(error) / 3;
    seen += counts[error];
    report.max_error = double(error) / 3;
  }
  report.changed_values = values - counts[0];
  if (report.changed_values == 0) return;
  report.changed = double(report.changed_values) / double(values);
  report.mean_changed_error = double(sum) / 3 / double(report.changed_values);
}

}  // namespace

std::vector<std::pair<std::string, double>> codec_numbers(const CodecReport& report) {
  std::vector<std::pair<std::string, double>> numbers{{"width", report.width},
                                                      {"height", report.height},
                                                      {"texels", double(report.texels)},
                                                      {"directions", report.directions},
                                                      {"raw_bytes", double(report.raw_bytes)}};
  for (const FileSize& file : report.files) numbers.emplace_back("bytes." + file.name, double(file.bytes));
  numbers.insert(numbers.end(), {{"ratio", report.ratio},
                                 {"changed_values", double(report.changed_values)},
                                 {"changed", report.changed},
                                 {"mean_changed_error", report.mean_changed_error},
                                 {"error_99", report.error_99},
                                 {"max_error", report.max_error},
                                 {"max_component_error", report.max_component_error},
                                 {"colors", double(report.colors)}});
  return numbers;
}

CodecReport report_codec(const ByteStack& original, const ByteStack& decoded, std::vector<FileSize> files,
                         std::span<const std::uint8_t> counts) {
  if (original.width != decoded.width || original.height != decoded.height || original.grid != decoded.grid ||
      original.texels.size() != decoded.texels.size())
    throw Error("the decoded object has another size, or other directions, than the original");
  CodecReport report{.width = original.width,
                     .height = original.height,
                     .directions = original.grid.layers(),
                     .files = std::move(files)};
  ErrorCounts errors{};
  std::vector<bool> seen(std::size_t{1} << 24);  // colours
  std::uint64_t values = 0;
  for (std::size_t i = 0; i < original.texels.size(); ++i) {
    if (!counts.empty() && counts[i % original.layer_size()] == 0) continue;
    ++values;
    const auto& [r, g, b] = original.texels[i];
    const std::size_t color = std::size_t(r) << 16 | std::size_t(g) << 8 | b;
    if (!seen[color]) ++report.colors;
    seen[color] = true;
    int sum = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      const int error = std::abs(original.texels[i][c] - decoded.texels[i][c]);
      report.max_component_error = std::max(report.max_component_error, error);
      sum += error;
    }
    ++errors[std::size_t(sum)];
  }
  measure_errors(errors, values, report);
  std::uint64_t bytes = 0;
  for (const FileSize& file : report.files) bytes += file.bytes;
  report.texels = values / std::uint64_t(report.directions);
  report.raw_bytes = 3 * values;
  report.ratio = double(report.raw_bytes) / double(bytes);
  return report;
}

}  // namespace lightbench
