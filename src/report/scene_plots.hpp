#pragma once

#include <string>
#include <vector>

namespace manifuzz {

/// One scene's time of a step by its number of bodies.
struct ScalingLine {
  std::string name;                               ///< with the fitted exponent
  std::vector<std::pair<double, double>> points;  ///< bodies, ns a step; both above 0
};

/// Draws the lines on two logarithmic axes, as `draw_by_gnuplot` does.
void write_scaling_plot(const std::string& path, const std::vector<ScalingLine>& lines);

/// Where a scene's candidate pairs went, in percent.
struct SkipBar {
  std::string name;
  double at_rest = 0;
  double separated = 0;
  double collided = 0;
};

/// Draws stacked bars, as `draw_by_gnuplot` does.
void write_skip_plot(const std::string& path, const std::vector<SkipBar>& bars);

}  // namespace manifuzz
