#pragma once

#include <string>
#include <vector>

namespace manifuzz {

/// Where a scene's candidate pairs went, in percent.
struct SkipBar {
  std::string name;
  double at_rest = 0;
  double separated = 0;
  double recycled = 0;
  double collided = 0;
};

/// Draws stacked bars, as `draw_by_gnuplot` does.
void write_skip_plot(const std::string& path, const std::vector<SkipBar>& bars);

}  // namespace manifuzz
