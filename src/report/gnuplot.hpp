#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace manifuzz {

// Pictures drawn by gnuplot. Each function throws UserError where the file's name does not end in
// .svg or .png, where gnuplot is missing, or where the file cannot be written.

/// A named point on two logarithmic axes: coordinates above 0.
struct PlotPoint {
  std::string name;
  double x = 0;
  double y = 0;
};

struct PointPlot {
  std::string title;
  std::string x_label;
  std::string y_label;
  std::vector<PlotPoint> points;
};

/// The points that no other is left of and below, by x.
std::vector<PlotPoint> front(std::vector<PlotPoint> points);

/// Draws the points with their names, and their front as a line.
void write_plot(const std::string& path, const PointPlot& plot);

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

/// Draws the merged lines, y logarithmic and x too unless it is linear.
void write_plot(const std::string& path, const LinePlot& plot);

/// Shares of a whole in percent, a bar a name, its parts from below.
struct BarPlot {
  struct Part {
    std::string name;
    std::string colour;  ///< "#rrggbb"
  };
  struct Bar {
    std::string name;
    std::vector<double> percent;  ///< of each part
  };
  std::string title;
  std::string y_label;
  std::vector<Part> parts;
  std::vector<Bar> bars;
};

/// Draws the bars, their parts stacked.
void write_plot(const std::string& path, const BarPlot& plot);

}  // namespace manifuzz
