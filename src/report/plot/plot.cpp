#include "report/plot/plot.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "report/plot/gnuplot.hpp"

namespace manifuzz {
namespace {

std::string rows_of(const std::vector<PlotPoint>& points) {
  std::string rows;
  for (const PlotPoint& point : points) {
    rows += fmt::format("{} {} \"{}\"\n", point.x, point.y, point.name);
  }
  return rows;
}

std::string commands_of(const Plot& plot) {
  return fmt::format(
      "set title \"{}\" noenhanced\n"
      "set xlabel \"{}\" noenhanced\nset ylabel \"{}\" noenhanced\n"
      "set logscale xy\nset grid\nset key off\nset offsets graph 0.1, graph 0.2, graph 0.1, 0\n"
      "$all << END\n{}END\n$front << END\n{}END\n"
      "plot $front using 1:2 with lines linewidth 2 linecolor '#8fb3d9', "
      "$all using 1:2 with points pointtype 7 linecolor '#1f4e79', "
      "$all using 1:2:3 with labels rotate by 30 offset 0.6,0.4 left noenhanced\n",
      plot.title, plot.x_label, plot.y_label, rows_of(plot.points), rows_of(front(plot.points)));
}

}  // namespace

std::vector<PlotPoint> front(std::vector<PlotPoint> points) {
  std::ranges::sort(points, [](const PlotPoint& p, const PlotPoint& q) {
    return p.x != q.x ? p.x < q.x : p.y < q.y;
  });
  std::vector<PlotPoint> best;
  for (PlotPoint& point : points) {
    if (best.empty() || point.y < best.back().y) best.push_back(std::move(point));
  }
  return best;
}

void write_plot(const std::string& path, const Plot& plot) {
  draw_by_gnuplot(path, commands_of(plot));
}

}  // namespace manifuzz
