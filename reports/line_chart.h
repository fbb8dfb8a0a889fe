#pragma once

#include <string>
#include <utility>
#include <vector>

namespace lightbench {

/// A line by its points, in the order of x.
struct ChartLine {
  std::string name;
  std::vector<std::pair<double, double>> points;
};

struct ChartTexts {
  std::string title;  ///< for those who cannot see the picture
  std::string x_axis;
  std::string y_axis;
};

/// An SVG picture that needs no other file; both axes begin at 0. Empty where there is nothing to draw.
std::string line_chart(const ChartTexts& texts, const std::vector<ChartLine>& lines);

/// The same with a bar for each value, side by side from 0 on.
std::string bar_chart(const ChartTexts& texts, const std::vector<double>& values);

}  // namespace lightbench
