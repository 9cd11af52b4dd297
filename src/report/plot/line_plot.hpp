#pragma once

#include <optional>
#include <string>
#include <vector>

namespace manifuzz {

/// One thing against a knob.
struct PlotLine {
  std::string name;
  std::vector<std::pair<double, double>> points;  ///< y 0 or more; x above 0 if logarithmic
  std::optional<std::size_t> breaks_at;           ///< the point that is marked
  bool is_ideal = false;                          ///< drawn as a thin dashed line, for comparison
};

struct LinePlot {
  std::string title;
  std::string x_label;
  std::string y_label;
  bool is_linear_in_x = false;
  bool falls = false;             ///< the axis of x runs from the largest to the smallest
  std::optional<double> limit{};  ///< a level line: above it a line has broken
  std::vector<PlotLine> lines{};
};

/// Lines of equal points as one, with their names: colliders often answer alike.
std::vector<PlotLine> merged(std::vector<PlotLine> lines);

/// Draws the merged lines, y logarithmic and x too unless it is linear, as `draw_by_gnuplot` does.
void write_line_plot(const std::string& path, const LinePlot& plot);

}  // namespace manifuzz
