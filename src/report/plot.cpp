#include "report/plot.hpp"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <limits>

#include <fmt/format.h>

#include "cases/file.hpp"
#include "cases/text.hpp"
#include "cases/user_error.hpp"

namespace manifuzz {
namespace {

std::string terminal_of(const std::string& path) {
  if (path.ends_with(".svg")) return "svg size 900,600 font 'sans,14' background 'white'";
  if (path.ends_with(".png")) return "pngcairo size 900,600 font 'sans,11'";
  throw UserError(
      fmt::format("{}: the name of an SVG or PNG file is expected", printable(path, 200)));
}

std::string rows_of(const std::vector<PlotPoint>& points) {
  std::string rows;
  for (const PlotPoint& point : points) {
    rows += fmt::format("{} {} \"{}\"\n", point.x, point.y, point.name);
  }
  return rows;
}

std::string script_of(const Plot& plot, const std::string& terminal, const std::string& output) {
  return fmt::format(
      "set terminal {}\nset output '{}'\nset title \"{}\" noenhanced\n"
      "set xlabel \"{}\" noenhanced\nset ylabel \"{}\" noenhanced\n"
      "set logscale xy\nset grid\nset key off\nset offsets graph 0.1, graph 0.2, graph 0.1, 0\n"
      "$all << END\n{}END\n$front << END\n{}END\n"
      "plot $front using 1:2 with lines linewidth 2 linecolor '#8fb3d9', "
      "$all using 1:2 with points pointtype 7 linecolor '#1f4e79', "
      "$all using 1:2:3 with labels rotate by 30 offset 0.6,0.4 left noenhanced\n",
      terminal, output, plot.title, plot.x_label, plot.y_label, rows_of(plot.points),
      rows_of(front(plot.points)));
}

bool run_gnuplot(const std::string& script) {
  std::FILE* const gnuplot = popen("gnuplot", "w");
  if (gnuplot == nullptr) return false;
  std::fwrite(script.data(), 1, script.size(), gnuplot);
  return pclose(gnuplot) == 0;
}

}  // namespace

void expect_plot_name(const std::string& path) {
  terminal_of(path);
}

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
  const std::string terminal = terminal_of(path);
  const std::string unfinished = path + ".unfinished";
  if (!run_gnuplot(script_of(plot, terminal, unfinished))) {
    std::filesystem::remove(unfinished);
    throw UserError(fmt::format("{}: gnuplot could not draw it; is it installed?", path));
  }
  std::filesystem::rename(unfinished, path);
}

}  // namespace manifuzz
