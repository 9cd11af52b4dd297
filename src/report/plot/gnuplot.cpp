#include "report/plot/gnuplot.hpp"

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <unistd.h>

#include <fmt/format.h>

#include "base/file.hpp"
#include "base/text.hpp"
#include "base/user_error.hpp"

namespace manifuzz {
namespace {

std::string terminal_of(const std::string& path) {
  if (path.ends_with(".svg")) return "svg size 900,600 font 'sans,14' background 'white'";
  if (path.ends_with(".png")) return "pngcairo size 900,600 font 'sans,11'";
  throw UserError(
      fmt::format("{}: the name of an SVG or PNG file is expected", printable(path, 200)));
}

bool run_gnuplot(const std::string& script) {
  std::FILE* const gnuplot = popen("gnuplot", "w");
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

}  // namespace

void draw_by_gnuplot(const std::string& path, const std::string& commands) {
  const std::string terminal = terminal_of(path);
  // The name stands in gnuplot's script, so it is never the user's.
  const DrawnFile drawn;
  const bool is_drawn = run_gnuplot(
      fmt::format("set terminal {}\nset output '{}'\n", terminal, drawn.path()) + commands);
  const std::string picture = InputFile(drawn.path()).read_all();
  if (!is_drawn || picture.empty()) {
    throw UserError(fmt::format("{}: gnuplot could not draw it; is it installed?", path));
  }
  write_file(path, picture);
}

}  // namespace manifuzz
