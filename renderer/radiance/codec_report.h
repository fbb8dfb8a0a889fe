#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "renderer/radiance/radiance_stack.h"

namespace lightbench {

struct FileSize {
  std::string name;
  std::uint64_t bytes;
};

/// What a compression of one object costs and saves. Errors are in steps of 8 bits. That of a value, a texel
/// in one direction, is the mean of |decoded - true| over its three components.
struct CodecReport {
  int width = 0;                ///< texels
  int height = 0;               ///< texels
  std::uint64_t texels = 0;     ///< that count, of one layer
  int directions = 0;           ///< of each texel
  std::uint64_t raw_bytes = 0;  ///< three for each value
  std::vector<FileSize> files;
  double ratio = 0;                  ///< raw_bytes over all files together
  std::uint64_t changed_values = 0;  ///< that were not decoded as they were
  double changed = 0;                ///< their share of all, 0..1
  double mean_changed_error = 0;     ///< over them alone; 0 where there are none
  double error_99 = 0;               ///< the least error that 99 % of all values do not exceed
  double max_error = 0;
  int max_component_error = 0;
  std::size_t colors = 0;  ///< distinct ones in the original
};

/// Its numbers by the names of the members; the size of a file is called bytes.NAME.
std::vector<std::pair<std::string, double>> codec_numbers(const CodecReport& report);

/// For any codec. `counts` tells of each place of a layer whether a texel is there (not 0); empty: all are.
/// Where none is, neither errors nor raw bytes are counted. Throws Error unless both stacks have the same
/// size and directions.
CodecReport report_codec(const ByteStack& original, const ByteStack& decoded, std::vector<FileSize> files,
                         std::span<const std::uint8_t> counts = {});

}  // namespace lightbench
