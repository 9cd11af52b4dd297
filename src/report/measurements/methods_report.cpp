#include <algorithm>
#include <functional>

#include <fmt/format.h>

#include "engines/provenance.hpp"
#include "report/measurements/measurements.hpp"

namespace manifuzz {
namespace {

using Json = nlohmann::ordered_json;

bool is_of_frames(const MethodRow& row) {
  return row.frames.has_value();
}

/// Where a subject's row over a workload is.
const MethodRow* find_row(const std::vector<MethodRow>& rows, const std::string& name,
                          const std::string& depths, std::optional<int> vertices = {}) {
  const auto row = std::ranges::find_if(rows, [&](const MethodRow& one) {
    return one.subject.name == name && one.depths == depths && one.spec.vertices == vertices;
  });
  return row == rows.end() ? nullptr : &*row;
}

/// The rows of one workload, one a subject.
std::vector<const MethodRow*> rows_of_subjects(const std::vector<MethodRow>& rows,
                                               const std::string& depths) {
  std::vector<const MethodRow*> all;
  for (const MethodRow& row : rows) {
    if (row.depths == depths && !row.spec.vertices) all.push_back(&row);
  }
  return all;
}

std::string nanoseconds(const MethodRow* row) {
  return row != nullptr && row->timing ? fmt::format("{:.0f}", row->timing->ns_per_pair) : "-";
}

std::string percent(double share) {
  return fmt::format("{:.1f}%", 100 * share);
}

Json row_json(const MethodRow& row) {
  Json json{{"method", row.method},
            {"collider", row.subject.name},
            {"query", row.subject.query},
            {"input", row.depths == "frames" ? Json("frame") : Json("pair")},
            {"target", row.subject.target},
            {"vertices", row.spec.vertices ? Json(*row.spec.vertices) : Json("mixed")},
            {"depths", row.depths},
            {"touching", is_of_frames(row) ? Json() : Json(row.spec.touching)},
            {"regime", is_of_frames(row) ? Json("motions") : Json(row.spec.regime->name)}};
  json["ns_per_pair"] = row.timing ? Json(row.timing->ns_per_pair) : Json();
  json["speedup_over_box2d"] = row.timing ? Json(row.timing->speedup_over_box2d) : Json();
  json["error"] = {{"depth", spread_json(row.errors.of_extent.depth)},
                   {"normal", spread_json(row.errors.of_extent.normal)}};
  json["error_of_size"] = {{"depth", spread_json(row.errors.of_size.depth)},
                           {"normal", spread_json(row.errors.of_size.normal)}};
  json["missed"] = row.errors.missed;
  json["phantom"] = row.errors.phantom;
  json["contacts"] = row.errors.contacts;
  json["cases"] = row.errors.cases;
  json["points_missing"] = row.errors.points_missing;
  json["extent_lost"] = row.errors.extent_lost;
  const auto frame = [&](const char* name, const std::function<Json(const FrameErrors&)>& figure) {
    json[name] = row.frames ? figure(*row.frames) : Json();
  };
  frame("frames_to_complete", [](const FrameErrors& of) {
    return of.frames_to_complete ? Json(*of.frames_to_complete) : Json();
  });
  frame("completed", [](const FrameErrors& of) { return Json(of.completed); });
  frame("lingering", [](const FrameErrors& of) { return Json(of.lingering); });
  frame("flicker", [](const FrameErrors& of) { return Json(of.flicker); });
  return json;
}

std::string complete_after(const FrameErrors& frames) {
  return frames.frames_to_complete ? fmt::format("{:.0f}", *frames.frames_to_complete) : "never";
}

std::string table_of_frames(const std::vector<MethodRow>& rows) {
  std::string text = fmt::format("{:<19}{:>8}{:>8}{:>9}{:>9}{:>9}{:>8}{:>11}{:>8}{:>9}\n", "", "ns",
                                 "ns", "depth", "normal", "points", "extent", "frames to", "", "");
  text += fmt::format("{:<19}{:>8}{:>8}{:>9}{:>9}{:>9}{:>8}{:>11}{:>8}{:>9}\n", "", "a pair",
                      "a frame", "off", "off", "missing", "lost", "complete", "linger", "flicker");
  std::string method;
  for (const MethodRow* const row : rows_of_subjects(rows, "frames")) {
    if (row->method != method) text += row->method + "\n";
    method = row->method;
    text += fmt::format("  {:<17}{:>8}{:>8}{:>9.1g}{:>9.1g}{:>9.2f}{:>8}{:>11}{:>8}{:>9}\n",
                        row->subject.name, nanoseconds(find_row(rows, row->subject.name, "mixed")),
                        nanoseconds(row), row->errors.of_size.depth.p999,
                        row->errors.of_size.normal.p999, row->errors.points_missing,
                        percent(row->errors.extent_lost), complete_after(*row->frames),
                        percent(row->frames->lingering), percent(row->frames->flicker));
  }
  return text;
}

std::string table_of_pairs(const std::vector<MethodRow>& rows) {
  std::string text = fmt::format("{:<20}{:>27}   {:>24}   {:>24}\n", "", "ns, by vertices",
                                 "ns, by depth", "extent lost, depth off");
  text += fmt::format("{:<20}{:>6}{:>7}{:>7}{:>7}   {:>8}{:>8}{:>8}   {:>7}{:>7}{:>10}\n", "", 3, 4,
                      6, 8, "apart", "shallow", "deep", "shallow", "deep", "mixed");
  for (const MethodRow* const row : rows_of_subjects(rows, "mixed")) {
    const std::string& name = row->subject.name;
    text += fmt::format("{:<20}", name);
    for (const int vertices : {3, 4, 6, 8}) {
      text += fmt::format("{:>{}}", nanoseconds(find_row(rows, name, "mixed", vertices)),
                          vertices == 3 ? 6 : 7);
    }
    text += "   ";
    for (const char* const depths : {"apart", "shallow", "deep"}) {
      text += fmt::format("{:>8}", nanoseconds(find_row(rows, name, depths)));
    }
    text += "   ";
    for (const char* const depths : {"shallow", "deep"}) {
      const MethodRow* const at = find_row(rows, name, depths);
      text += fmt::format("{:>7}", at == nullptr ? "-" : percent(at->errors.extent_lost));
    }
    text += fmt::format("{:>10.2g}\n", row->errors.of_size.depth.p999);
  }
  return text;
}

/// One of the picture's columns.
struct Panel {
  std::string title;
  std::string format;  ///< of the numbers at the bars' ends
  bool is_logarithmic = false;
  std::function<std::optional<double>(const MethodRow&)> figure;
};

/// From where logarithmic bars begin, and what is drawn where a figure is 0.
constexpr double kLeastDrawn = 1e-9;

std::vector<Panel> panels() {
  return {{"time of\\na frame, ns", "{:.0f}", true,
           [](const MethodRow& row) {
             return row.timing ? std::optional(row.timing->ns_per_pair) : std::nullopt;
           }},
          {"depth off by\\n(share of size)", "{:.0e}", true,
           [](const MethodRow& row) { return row.errors.of_size.depth.p999; }},
          {"contact not\\nspanned, %", "{:.1f}", false,
           [](const MethodRow& row) { return 100 * row.errors.extent_lost; }},
          {"frames until\\nall is spanned", "{:.0f}", false,
           [](const MethodRow& row) { return row.frames->frames_to_complete; }},
          {"points come or go,\\n% of frames", "{:.1f}", false,
           [](const MethodRow& row) { return 100 * row.frames->flicker; }}};
}

constexpr std::array<std::string_view, 7> kWays{"#0072b2", "#5c3a1e", "#d55e00", "#e69f00",
                                                "#56b4e9", "#009e73", "#cc79a7"};

/// The subjects from top to bottom, each with its way's colour; a gap before each way.
struct Bar {
  const MethodRow* row;
  double height;
  std::string_view colour;
};

std::vector<Bar> bars_of(const std::vector<const MethodRow*>& rows) {
  std::vector<Bar> bars;
  double height = 0;
  std::size_t ways = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const bool is_first = i == 0 || rows[i]->method != rows[i - 1]->method;
    if (is_first && i > 0) ++ways;
    height -= is_first ? 1.9 : 1;
    bars.push_back({rows[i], height, kWays[ways % kWays.size()]});
  }
  return bars;
}

std::string drawn_panel(const Panel& panel, const std::vector<Bar>& bars, std::size_t number) {
  const double left = 0.19 + 0.16 * static_cast<double>(number);
  double most = 0;
  for (const Bar& bar : bars) most = std::max(most, panel.figure(*bar.row).value_or(0));
  const double from = panel.is_logarithmic ? (number == 0 ? 10 : kLeastDrawn) : 0;
  // Room for the number at the longest bar's end.
  const double to =
      panel.is_logarithmic ? most * std::pow(most / from, 0.75) : 1.45 * std::max(most, 1.0);
  std::string text = fmt::format(
      "unset label\nset lmargin at screen {}\nset rmargin at screen {}\n"
      "set title \"{}\" noenhanced offset 0,-0.6\n{} logscale x\nset xrange [{}:{}]\n",
      left, left + 0.145, panel.title, panel.is_logarithmic ? "set" : "unset", from, to);
  std::string rows;
  for (const Bar& bar : bars) {
    const std::optional<double> figure = panel.figure(*bar.row);
    const double end = std::max(figure.value_or(from), from);
    rows +=
        fmt::format("{} {} {} {} {} {} {}\n", from, bar.height, from, end, bar.height - 0.38,
                    bar.height + 0.38, std::stoi(std::string(bar.colour.substr(1)), nullptr, 16));
    const std::string said = figure ? fmt::format(fmt::runtime(panel.format), *figure)
                                    : std::string(number == 3 ? "never" : "not timed");
    text += fmt::format("set label \"{}\" at {},{} left offset 0.4,0 noenhanced\n", said, end,
                        bar.height);
  }
  text += fmt::format("$panel{} << END\n{}END\n", number, rows);
  if (number == 0) {
    std::string before;
    for (const Bar& bar : bars) {
      const std::string& name = bar.row->subject.name;
      text += fmt::format("set label \"{}\" at screen 0.183, first {} right noenhanced\n", name,
                          bar.height);
      if (bar.row->method == before) continue;
      before = bar.row->method;
      text += fmt::format(
          "set label \"{}\" at screen 0.01, first {} left textcolor rgb '{}' noenhanced\n", before,
          bar.height + 0.92, bar.colour);
    }
  }
  text += fmt::format(
      "plot $panel{} using 1:2:3:4:5:6:7 with boxxyerror linecolor rgb variable notitle\n", number);
  return text;
}

}  // namespace

std::string methods_table(const std::vector<MethodRow>& rows) {
  return table_of_frames(rows) +
         "\ndepth and normal off: at 99.9% of contacts, as a share of the size, and of 1; frames "
         "are of motions\n\n" +
         table_of_pairs(rows);
}

Json methods_json(const std::vector<MethodRow>& rows, const std::vector<MethodSubject>& subjects,
                  std::uint64_t seed) {
  std::vector<Declaration> declarations;
  for (const MethodSubject& subject : subjects) {
    declarations.push_back(subject.keeper ? subject.keeper().declaration
                                          : subject.bench.collider().declaration);
  }
  Json json = provenance(seed, declarations);
  json["rows"] = Json::array();
  for (const MethodRow& row : rows) json["rows"].push_back(row_json(row));
  return json;
}

void write_methods_plot(const std::string& path, const std::vector<MethodRow>& rows) {
  const std::vector<Bar> bars = bars_of(rows_of_subjects(rows, "frames"));
  std::string text = fmt::format(
      "set multiplot title \"Ways to contact points, over the same moving polygons: the shorter a "
      "bar, the better\" noenhanced\n"
      "set tmargin at screen 0.86\nset bmargin at screen 0.03\n"
      "set yrange [{}:0]\nunset ytics\nunset xtics\nset border 2 linecolor '#999999'\n"
      "set style fill solid 0.85 noborder\n",
      bars.back().height - 0.7);
  const std::vector<Panel> all = panels();
  for (std::size_t i = 0; i < all.size(); ++i) text += drawn_panel(all[i], bars, i);
  draw_plot(path, text + "unset multiplot\n");
}

}  // namespace manifuzz
