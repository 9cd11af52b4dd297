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

/// Throws UserError where `path` ends neither in .svg nor in .png.
void expect_plot_name(const std::string& path);

/// Draws points with their names on two logarithmic axes, and their front as a line, by gnuplot.
/// `path` ends in .svg or .png. Throws UserError where it does not, or where gnuplot is missing.
void write_plot(const std::string& path, const Plot& plot);

}  // namespace manifuzz
