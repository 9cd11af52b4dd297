#pragma once

#include <string>
#include <vector>

namespace manifuzz {

/// A point of a picture of run time against error.
struct PlotPoint {
  std::string name;
  double x = 0;
  double y = 0;
};

struct Plot {
  std::string title;
  std::string x_label;
  std::string y_label;
  std::vector<PlotPoint> points;  ///< coordinates above 0
};

/// The points that no other is left of and below, by x.
std::vector<PlotPoint> front(std::vector<PlotPoint> points);

/// Draws points with their names on two logarithmic axes, and their front as a line, as
/// `draw_by_gnuplot` does.
void write_plot(const std::string& path, const Plot& plot);

}  // namespace manifuzz
