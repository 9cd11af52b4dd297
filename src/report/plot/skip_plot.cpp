#include "report/plot/skip_plot.hpp"

#include <fmt/format.h>

#include "report/plot/gnuplot.hpp"

namespace manifuzz {

void write_skip_plot(const std::string& path, const std::vector<SkipBar>& bars) {
  std::string rows;
  for (const SkipBar& bar : bars) {
    rows += fmt::format("\"{}\" {} {} {} {}\n", bar.name, bar.at_rest, bar.separated, bar.recycled,
                        bar.collided);
  }
  draw_by_gnuplot(path,
                  "set title \"Where candidate pairs went\"\nset ylabel \"% of candidate pairs\"\n"
                  "set yrange [0:100]\nset style data histograms\nset style histogram rowstacked\n"
                  "set style fill solid 0.9\nset boxwidth 0.7\nset xtics rotate by -30 noenhanced\n"
                  "set key outside right\nset grid y\n$bars << END\n" +
                      rows +
                      "END\nplot $bars using 2:xtic(1) title \"at rest\" linecolor '#d0d0d0', "
                      "$bars using 3 title \"proven separated\" linecolor '#8fb3d9', "
                      "$bars using 4 title \"recycled\" linecolor '#e69f00', "
                      "$bars using 5 title \"collided\" linecolor '#1f4e79'\n");
}

}  // namespace manifuzz
