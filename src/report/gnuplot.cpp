#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <unistd.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/file.hpp"
#include "base/text.hpp"
#include "report/measurements.hpp"

namespace manifuzz {
namespace {

std::string terminal_of(const std::string& path) {
  if (path.ends_with(".svg")) return "svg size 900,600 font 'sans,14' background 'white'";
  if (path.ends_with(".png")) return "pngcairo size 900,600 font 'sans,11'";
  throw UserError(
      fmt::format("{}: the name of an SVG or PNG file is expected", printable(path, 200)));
}

/// No settings of the user's own.
bool run_gnuplot(const std::string& script) {
  std::FILE* const gnuplot = popen("gnuplot -d", "w");
  if (gnuplot == nullptr) return false;
  std::fwrite(script.data(), 1, script.size(), gnuplot);
  return pclose(gnuplot) == 0;
}

/// An empty file under a name of its own, removed at the end.
class DrawnFile {
 public:
  DrawnFile() : path_((std::filesystem::temp_directory_path() / "manifuzz-plot-XXXXXX").string()) {
    const int file = mkstemp(path_.data());
    if (file < 0) throw UserError(fmt::format("{}: cannot be written", path_));
    close(file);
  }
  ~DrawnFile() { unlink(path_.c_str()); }
  DrawnFile(const DrawnFile&) = delete;
  DrawnFile& operator=(const DrawnFile&) = delete;

  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

/// Runs commands that draw one picture, which becomes the file.
void draw_plot(const std::string& path, const std::string& commands) {
  // The name stands in gnuplot's script, so it is never the user's.
  const DrawnFile drawn;
  const bool is_drawn = run_gnuplot(fmt::format("set terminal {}\nset output '{}'\n{}",
                                                terminal_of(path), drawn.path(), commands));
  const std::string picture = InputFile(drawn.path()).read_all();
  if (!is_drawn || picture.empty()) {
    throw UserError(
        fmt::format("{}: gnuplot could not draw it; is it installed?", printable(path, 200)));
  }
  write_file(path, picture);
}

std::string title_and_labels(const auto& plot) {
  return fmt::format(
      "set title \"{}\" noenhanced\nset xlabel \"{}\" noenhanced\nset ylabel \"{}\" noenhanced\n",
      plot.title, plot.x_label, plot.y_label);
}

/// Rows of data, which the script calls `$name`.
std::string block(const std::string& name, const std::string& rows) {
  return fmt::format("${} << END\n{}END\n", name, rows);
}

std::string rows_of(const std::vector<PlotPoint>& points) {
  std::string rows;
  for (const PlotPoint& point : points) {
    rows += fmt::format("{} {} \"{}\"\n", point.x, point.y, point.name);
  }
  return rows;
}

/// Told apart by those who cannot tell red from green, too (Okabe and Ito's).
constexpr std::array<std::string_view, 9> kColours{"#0072b2", "#d55e00", "#009e73",
                                                   "#cc79a7", "#e69f00", "#56b4e9",
                                                   "#5c3a1e", "#222222", "#8a8a00"};
constexpr std::array kPointTypes{7, 5, 9, 11, 13, 6, 4, 8, 10};

/// What is drawn where an error is 0, or too small for the picture.
constexpr double kFloor = 1e-18;

std::string data_of(const std::vector<std::pair<double, double>>& points) {
  std::string rows;
  for (const auto& [x, y] : points) rows += fmt::format("{} {}\n", x, std::max(y, kFloor));
  return rows;
}

std::string drawn(const PlotLine& line, std::size_t number) {
  if (line.is_ideal) {
    return fmt::format("$line{} with lines linewidth 2 dashtype 2 linecolor '#555555' title \"{}\"",
                       number, line.name);
  }
  const auto colour = kColours[number % kColours.size()];
  std::string text = fmt::format(
      "$line{} with linespoints linewidth 2 pointtype {} pointsize 0.6 linecolor '{}' title \"{}\"",
      number, kPointTypes[number % kPointTypes.size()], colour, line.name);
  if (!line.breaks_at) return text;
  return text + fmt::format(
                    ", $break{} with points pointtype 2 pointsize 2.4 linewidth 3 "
                    "linecolor '{}' notitle",
                    number, colour);
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

void write_plot(const std::string& path, const PointPlot& plot) {
  draw_plot(path, title_and_labels(plot) +
                      "set logscale xy\nset grid\nset key off\n"
                      "set offsets graph 0.1, graph 0.2, graph 0.1, 0\n" +
                      block("all", rows_of(plot.points)) +
                      block("front", rows_of(front(plot.points))) +
                      "plot $front using 1:2 with lines linewidth 2 linecolor '#8fb3d9', "
                      "$all using 1:2 with points pointtype 7 linecolor '#1f4e79', "
                      "$all using 1:2:3 with labels rotate by 30 offset 0.6,0.4 left noenhanced\n");
}

std::vector<PlotLine> merged(std::vector<PlotLine> lines) {
  std::vector<PlotLine> distinct;
  for (PlotLine& line : lines) {
    const auto same = std::ranges::find_if(distinct, [&](const PlotLine& other) {
      return other.points == line.points && other.breaks_at == line.breaks_at &&
             other.is_ideal == line.is_ideal;
    });
    if (same == distinct.end()) {
      distinct.push_back(std::move(line));
    } else {
      same->name += ", " + line.name;
    }
  }
  return distinct;
}

void write_plot(const std::string& path, const LinePlot& plot) {
  const std::vector<PlotLine> lines = merged(plot.lines);
  std::string text = title_and_labels(plot);
  text += fmt::format(
      "set logscale {0}\nset format {0} '10^{{%T}}'\nset grid linecolor '#dddddd'\n"
      "set key below Left reverse horizontal noenhanced samplen 2 height 1\n"
      "set xrange [*:*]{1} noextend\nset yrange [*:*]\nset offsets 0, 0, graph 0.05, graph 0.05\n",
      plot.is_linear_in_x ? "y" : "xy", plot.falls ? " reverse" : "");
  std::vector<std::string> drawings;
  if (plot.limit) {
    drawings.push_back(fmt::format(
        "{} with lines linewidth 1.5 linecolor '#aa0000' title \"broken above\"", *plot.limit));
  }
  for (std::size_t i = 0; i < lines.size(); ++i) {
    text += block(fmt::format("line{}", i), data_of(lines[i].points));
    if (lines[i].breaks_at) {
      text += block(fmt::format("break{}", i), data_of({lines[i].points[*lines[i].breaks_at]}));
    }
    drawings.push_back(drawn(lines[i], i));
  }
  if (plot.limit) {
    drawings.emplace_back(
        "NaN with points pointtype 2 pointsize 2 linewidth 3 linecolor '#333333' "
        "title \"breaks here\"");
  }
  draw_plot(path, fmt::format("{}plot {}\n", text, fmt::join(drawings, ", ")));
}

void write_plot(const std::string& path, const BarPlot& plot) {
  std::string rows;
  for (const auto& [name, percent] : plot.bars) {
    rows += fmt::format("\"{}\" {}\n", name, fmt::join(percent, " "));
  }
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < plot.parts.size(); ++i) {
    const auto& [name, colour] = plot.parts[i];
    parts.push_back(fmt::format("$bars using {}{} title \"{}\" linecolor '{}'", i + 2,
                                i == 0 ? ":xtic(1)" : "", name, colour));
  }
  draw_plot(path,
            fmt::format("set title \"{}\"\nset ylabel \"{}\"\n", plot.title, plot.y_label) +
                "set yrange [0:100]\nset style data histograms\nset style histogram rowstacked\n"
                "set style fill solid 0.9\nset boxwidth 0.7\nset xtics rotate by -30 noenhanced\n"
                "set key outside right\nset grid y\n" +
                block("bars", rows) + fmt::format("plot {}\n", fmt::join(parts, ", ")));
}

}  // namespace manifuzz
