#include "renderer/radiance/piecewise_encoder.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstdlib>
#include <limits>
#include <span>

#include <fmt/format.h>

#include "base/error.h"
#include "renderer/radiance/ramp.h"
#include "renderer/radiance/texel_block.h"

namespace lightbench {
namespace {

using Values = std::span<const Rgb8>;

int error_of(const Rgb8& a, const Rgb8& b) {
  return std::abs(a[0] - b[0]) + std::abs(a[1] - b[1]) + std::abs(a[2] - b[2]);
}

/// The slopes of the lines from one value that come near enough to all that follow it. Of a line's error
/// before rounding each component is at most max_error + 1/2, and the sum of their sizes at most max_error +
/// 3/2: bounds on the three components, and on their four sums with signs. In floats: it may let through a
/// line that is too far off by kSlack, and holds none back that is not.
class Corridor {
 public:
  Corridor(const Rgb8& start, int max_error) : start_(start) {
    low_.fill(-std::numeric_limits<float>::max());
    high_.fill(std::numeric_limits<float>::max());
    for (std::size_t i = 0; i < kSums; ++i)
      margin_[i] =
          float(max_error) + (std::abs(kRed[i]) + std::abs(kGreen[i]) + std::abs(kBlue[i])) / 2 + kSlack;
  }

  /// Keeps the slopes that come near enough to this value; `per_layer` is 1 over its distance. Whether the
  /// line to it was one of them before.
  bool narrow(const Rgb8& value, float per_layer) {
    const auto red = float(value[0] - start_[0]), green = float(value[1] - start_[1]),
               blue = float(value[2] - start_[2]);
    int outside = 0, empty = 0;
    for (std::size_t i = 0; i < kSums; ++i) {
      const float rise = kRed[i] * red + kGreen[i] * green + kBlue[i] * blue;
      const float slope = rise * per_layer;
      outside |= int(slope < low_[i]) | int(slope > high_[i]);
      low_[i] = std::max(low_[i], (rise - margin_[i]) * per_layer);
      high_[i] = std::min(high_[i], (rise + margin_[i]) * per_layer);
      empty |= int(low_[i] > high_[i]);
    }
    empty_ = empty != 0;
    return outside == 0;
  }
  bool empty() const { return empty_; }

 private:
  static constexpr std::size_t kSums = 8;  // the last one is the first again: eight go in one step
  using Sums = std::array<float, kSums>;
  static constexpr Sums kRed{1, 0, 0, 1, 1, 1, -1, 1};
  static constexpr Sums kGreen{0, 1, 0, 1, 1, -1, 1, 0};
  static constexpr Sums kBlue{0, 0, 1, 1, -1, 1, 1, 0};
  // Above what the roundings of a slope and its bounds come to over its distance: a few times 2^-24 of 1532.
  static constexpr float kSlack = 1e-3f;

  Rgb8 start_;
  bool empty_ = false;
  Sums margin_, low_, high_;
};

class GreedyRule {
 public:
  GreedyRule(int layers, int threshold) : max_error_(std::max(threshold, 1) - 1) {
    for (int i = 0; i < layers; ++i) per_layer_.push_back(1 / float(i));  // [0] is not used
  }

  void keep(Values values, std::vector<std::uint16_t>& kept) {
    std::size_t start = 0;
    kept.push_back(0);
    while (!stays(values.subspan(start))) {
      start += farthest(values.subspan(start));
      kept.push_back(std::uint16_t(start));
    }
  }

 private:
  bool near(const Rgb8& a, const Rgb8& b) const { return error_of(a, b) <= max_error_; }

  bool stays(Values values) const {
    return std::ranges::all_of(values, [&](const Rgb8& value) { return near(value, values[0]); });
  }

  /// The last value that a line from the first one may end at. A line that fails says nothing of those to
  /// later values: only an empty corridor does.
  std::size_t farthest(Values values) {
    ends_.clear();
    Corridor corridor(values[0], max_error_);
    for (std::size_t end = 1; end < values.size() && !corridor.empty(); ++end) {
      if (corridor.narrow(values[end], per_layer_[end])) ends_.push_back(end);
    }
    while (!line_is_near(values.first(ends_.back() + 1))) ends_.pop_back();
    return ends_.back();
  }

  bool line_is_near(Values values) const {
    Ramp ramp(values.front(), values.back(), int(values.size()) - 1);
    for (const Rgb8& value : values.subspan(1, values.size() - 2)) {
      ramp.step();
      if (!near(value, ramp.color())) return false;
    }
    return true;
  }

  int max_error_;
  std::vector<float> per_layer_;
  std::vector<std::size_t> ends_;  ///< of lines in the corridor; kept between calls for its memory
};

class PaperRule {
 public:
  explicit PaperRule(int threshold) : max_change_(std::max(threshold, 1) - 1) {}

  void keep(Values values, std::vector<std::uint16_t>& kept) const {
    kept.push_back(0);
    Step current = step_to(values, 1);
    for (std::size_t i = 2; i < values.size(); ++i) {
      const Step next = step_to(values, i);
      if (goes_on(current, next)) continue;
      kept.push_back(std::uint16_t(i - 1));
      current = next;
    }
    // The last layer ends the last line, unless the colour just stays.
    if (values.back() != values[kept.back()]) kept.push_back(std::uint16_t(values.size() - 1));
  }

 private:
  using Step = std::array<int, 3>;

  static Step step_to(Values values, std::size_t i) {
    const Rgb8 &a = values[i - 1], &b = values[i];
    return {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
  }

  bool goes_on(const Step& current, const Step& next) const {
    int sum = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      const int change = std::abs(next[c] - current[c]);
      if (2 * change > max_change_ || next[c] * current[c] < 0) return false;
      sum += change;
    }
    return sum <= max_change_;
  }

  int max_change_;
};

template <typename Rule>
void keep_samples(const ByteStack& stack, Rule rule, PiecewiseStack& result) {
  std::vector<std::uint16_t> kept;
  for (std::size_t first = 0; first < stack.layer_size(); first += TexelBlock::kMaxTexels) {
    TexelBlock block(first, stack);
    block.gather(stack);
    for (std::size_t i = 0; i < block.texels(); ++i) {
      const Values values = block.layers_of(i);
      kept.clear();
      rule.keep(values, kept);
      result.first_sample.push_back(std::uint32_t(result.layers.size()));
      result.layers.insert(result.layers.end(), kept.begin(), kept.end());
      for (const std::uint16_t layer : kept) result.colors.push_back(values[layer]);
    }
  }
}

void map_colors(PiecewiseStack& stack) {
  const ColorSet set(stack.colors);
  if (set.size() > kMaxMappedColors) return;
  stack.color_indices.reserve(stack.colors.size());
  for (const Rgb8& color : stack.colors) stack.color_indices.push_back(std::uint16_t(set.number(color)));
  stack.colors = set.colors();
}

}  // namespace

PiecewiseStack encode_piecewise(const ByteStack& stack, SampleRule rule, int threshold) {
  assert(threshold >= 0 && stack.texels.size() == stack.layer_size() * std::size_t(stack.grid.layers()));
  if (stack.texels.size() > std::numeric_limits<std::uint32_t>::max())
    throw Error(
        fmt::format("{} x {} texels of {} directions are too many to number their samples with 32 bits",
                    stack.width, stack.height, stack.grid.layers()));
  PiecewiseStack result{stack.width, stack.height, stack.grid, stack.scale, {}, {}, {}, {}};
  if (rule == SampleRule::greedy)
    keep_samples(stack, GreedyRule(stack.grid.layers(), threshold), result);
  else
    keep_samples(stack, PaperRule(threshold), result);
  map_colors(result);
  return result;
}

}  // namespace lightbench
