#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <unistd.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/file.hpp"
#include "base/text.hpp"
#include "report/measurements/measurements.hpp"

namespace manifuzz {
namespace {

std::string terminal_of(const std::string& path) {
  if (path.ends_with(".svg")) return "svg size 900,600 font 'sans,14' background 'white'";
  if (path.ends_with(".png")) return "pngcairo size 900,600 font 'sans,11'";
  throw UserError(
      fmt::format("{}: the name of an SVG or PNG file is expected", printable(path, 200)));
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
  DrawnFile& operator=(DrawnFile&&) = delete;  // neither moved nor copied

  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

/// Rows of data, which the script calls `$name`.
std::string block(const std::string& name, const std::string& rows) {
  return fmt::format("${} << END\n{}END\n", name, rows);
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

void draw_plot(const std::string& path, const std::string& commands) {
  // The name stands in gnuplot's script, so it is never the user's.
  const DrawnFile drawn;
  const std::string script = fmt::format("set terminal {}\nset output '{}'\n{}", terminal_of(path),
                                         drawn.path(), commands);
  // No settings of the user's own, and no warnings: of a range of one value, which it widens.
  std::FILE* const gnuplot = popen("gnuplot -d 2>/dev/null", "w");
  if (gnuplot != nullptr) std::fwrite(script.data(), 1, script.size(), gnuplot);
  const bool is_drawn = gnuplot != nullptr && pclose(gnuplot) == 0;
  const std::string picture = InputFile(drawn.path()).read_all();
  if (!is_drawn || picture.empty()) {
    throw UserError(
        fmt::format("{}: gnuplot could not draw it; is it installed?", printable(path, 200)));
  }
  write_file(path, picture);
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
  std::string text = fmt::format(
      "set title \"{2}\" noenhanced\nset xlabel \"{3}\" noenhanced\n"
      "set ylabel \"{4}\" noenhanced\n"
      "set logscale {0}\nset format {0} '10^{{%T}}'\nset grid linecolor '#dddddd'\n"
      "set key below Left reverse horizontal noenhanced samplen 2 height 1\n"
      "set xrange [*:*]{1} noextend\nset yrange [*:*]\nset offsets 0, 0, graph 0.05, graph 0.05\n",
      plot.is_linear_in_x ? "y" : "xy", plot.falls ? " reverse" : "", plot.title, plot.x_label,
      plot.y_label);
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

}  // namespace manifuzz
