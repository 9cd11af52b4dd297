#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base/text.hpp"
#include "campaign/in_child.hpp"
#include "report/picture/drawing.hpp"
#include "report/picture/pictures.hpp"
#include "report/words.hpp"

namespace manifuzz {
namespace {

constexpr int kPanels = 4;
constexpr double kPanelWidthMin = 387;  // 3 pixels for each of 129 cells
constexpr double kMapEdge = 28;
constexpr double kPanelGap = 24;
constexpr int kHeightMax = 4000;
constexpr Font kMapTitleFont{19, true};
constexpr Font kPanelFont{14, true};
constexpr Font kMapTextFont{13};
constexpr Font kSmallFont{11};
constexpr Colour kInk = 0x14181f;
constexpr Colour kQuiet = 0x5a6472;
constexpr Colour kPaper = 0xffffff;
constexpr Colour kHatch = 0x9aa3af;

// The colours of Okabe and Ito, told apart by every eye; pale grey is where nothing is the matter.
constexpr Colour kPale = 0xdfe3e8;
constexpr Colour kBlack = 0x000000;
constexpr Colour kOther = 0x7a6a5a;
constexpr std::array<Colour, 7> kStatementColours{0x0072b2, 0xf0e442, 0x009e73, 0xcc79a7,
                                                  0x56b4e9, 0xe69f00, 0xd55e00};

constexpr std::array<Colour, kVerdictNames.size()> kVerdictColours{
    kPale,    0x56b4e9, 0xe69f00, 0xd55e00, 0xf0e442, 0xcc79a7,
    0x0072b2, 0x009e73, kBlack,   0x5b2a86, kOther};

/// The roles whose statements are drawn, in the order of their panels.
constexpr std::array kRoles{&Cell::subject, &Cell::oracle, &Cell::truth};

/// A statement, the cells in which each role has it, and its colour.
struct Statement {
  ContactSummary what;
  std::array<int, kRoles.size()> cells{};
  Colour colour = kOther;

  int total() const { return cells[0] + cells[1] + cells[2]; }
};

/// What is said anywhere on the map, the most frequent first; what comes too late for a colour of
/// its own shares one.
std::vector<Statement> all_said(const Neighbourhood& neighbourhood) {
  std::vector<Statement> all;
  for (const Cell& cell : neighbourhood.cells) {
    if (cell.state != Cell::State::judged) continue;
    for (std::size_t role = 0; role < kRoles.size(); ++role) {
      const ContactSummary& what = cell.*kRoles[role];
      auto known = std::ranges::find(all, what, &Statement::what);
      if (known == all.end()) known = all.insert(all.end(), Statement{.what = what});
      ++known->cells[role];
    }
  }
  std::ranges::stable_sort(all, std::ranges::greater(), &Statement::total);
  std::size_t used = 0;
  for (Statement& said : all) {
    if (said.what.kind == ContactSummary::Kind::apart) {
      said.colour = kPale;
    } else if (said.what.kind == ContactSummary::Kind::nothing) {
      said.colour = kBlack;
    } else if (used < kStatementColours.size()) {
      said.colour = kStatementColours[used++];
    }
  }
  return all;
}

class MapPicture {
 public:
  MapPicture(const JudgedCase& judged, const Neighbourhood& neighbourhood)
      : judged_(judged),
        map_(neighbourhood),
        side_(neighbourhood.grid.side()),
        pixels_(std::max(1.0, std::ceil(kPanelWidthMin / side_))),
        panel_(pixels_ * side_),
        width_(2 * kMapEdge + kPanels * panel_ + (kPanels - 1) * kPanelGap),
        said_(all_said(neighbourhood)),
        canvas_(static_cast<int>(width_), kHeightMax) {}

  std::string draw() {
    write_title();
    draw_panels();
    const double top = y_;
    write_statements(left_of(0), left_of(3) - kPanelGap);
    const double bottom = std::exchange(y_, top);
    write_verdicts(left_of(3), width_ - kMapEdge);
    return canvas_.png(static_cast<int>(std::max(y_, bottom)));
  }

 private:
  double left_of(int panel) const { return kMapEdge + panel * (panel_ + kPanelGap); }
  bool any(Cell::State state) const {
    return std::ranges::find(map_.cells, state, &Cell::state) != map_.cells.end();
  }

  /// Text from `x` to `right`, in as many lines as it takes; moves down.
  void write(std::string_view text, double x, double right, const Font& font, Colour colour) {
    for (const std::string& line : wrapped(text, font, right - x)) {
      canvas_.text({x, y_}, line, font, colour);
      y_ += std::ceil(font.size * 1.55);
    }
  }
  void write_entry(std::string_view text, double x, double right, Colour colour) {
    const Box swatch{x, y_ - 11, 18, 13};
    canvas_.fill(swatch, colour);
    canvas_.frame(swatch, kQuiet);
    write(text, x + 27, right, kMapTextFont, kInk);
    y_ += 3;
  }

  /// The cells without a polygon.
  void draw_hatched(const Box& box) {
    for (int y = 0; y < box.height; y += 4) {
      canvas_.fill({box.x, box.y + y, box.width, 1}, kHatch);
    }
  }

  void write_title() {
    const double right = width_ - kMapEdge;
    const std::string name = std::filesystem::path(judged_.given.path).filename().string();
    y_ = 38;
    write(name.empty() || name == "-" ? "a case" : name, kMapEdge, right, kMapTitleFont, kInk);
    write(verdict_sentence(judged_), kMapEdge, right, kMapTextFont, kInk);
    write(severity_in_words(judged_, map_), kMapEdge, right, kMapTextFont, kInk);
    write(fmt::format("The map: {}. Right is +x, up is +y; the ring marks the case itself.",
                      grid_in_words(map_.grid)),
          kMapEdge, right, kMapTextFont, kQuiet);
    y_ += 14;
  }

  Colour colour_of_cell(int panel, const Cell& cell) const {
    if (panel == kPanels - 1) {
      return kVerdictColours[static_cast<std::size_t>(cell.bucket.verdict)];
    }
    const ContactSummary& what = cell.*kRoles[static_cast<std::size_t>(panel)];
    return std::ranges::find(said_, what, &Statement::what)->colour;
  }

  void draw_panel(int panel, std::string_view title) {
    const Box box{left_of(panel), y_ + 10, panel_, panel_};
    canvas_.text({box.x, y_}, title, kPanelFont, kInk);
    canvas_.frame(box, kQuiet);
    draw_hatched(box);
    for (int i = 0; i < map_.grid.cell_count(); ++i) {
      const Cell& cell = map_.cells[static_cast<std::size_t>(i)];
      if (cell.state == Cell::State::invalid) continue;
      const bool judged = cell.state == Cell::State::judged;
      const double column = map_.grid.x_of(i) + map_.grid.reach;
      const double row = map_.grid.reach - map_.grid.y_of(i);
      canvas_.fill({box.x + column * pixels_, box.y + row * pixels_, pixels_, pixels_},
                   judged ? colour_of_cell(panel, cell) : kPaper);
    }
    canvas_.ring(box.center(), 7, 4, kPaper);
    canvas_.ring(box.center(), 7, 1.8, kInk);
    const int ulps = map_.grid.reach * map_.grid.step;
    const std::string to = fmt::format("+{} ulps", ulps);
    const double below = box.bottom() + 16;
    canvas_.text({box.x, below}, fmt::format("-{}", ulps), kSmallFont, kQuiet);
    canvas_.text({box.center().x() - text_width("0", kSmallFont) / 2, below}, "0", kSmallFont,
                 kQuiet);
    canvas_.text({box.right() - text_width(to, kSmallFont), below}, to, kSmallFont, kQuiet);
  }

  void draw_panels() {
    draw_panel(0, "subject: " + judged_.subject.declaration.name);
    draw_panel(1, "oracle: " + judged_.oracle.declaration.name);
    draw_panel(2, "truth: the exact clip");
    draw_panel(3, "difference: the verdict");
    y_ += panel_ + 58;
  }

  void write_statements(double x, double right) {
    const auto entry = [&](std::string_view words, const std::array<int, kRoles.size()>& cells) {
      return fmt::format("{}   (cells: {} {}, {} {}, truth {})", words,
                         judged_.subject.declaration.name, cells[0],
                         judged_.oracle.declaration.name, cells[1], cells[2]);
    };
    write("What is said; points by their features, A's/B's: f a face, v a vertex", x, right,
          kPanelFont, kInk);
    y_ += 4;
    std::array<int, kRoles.size()> others{};
    int kinds = 0;
    for (const Statement& said : said_) {
      if (said.colour != kOther) {
        write_entry(entry(statement_in_words(said.what), said.cells), x, right, said.colour);
        continue;
      }
      ++kinds;
      for (std::size_t role = 0; role < kRoles.size(); ++role) others[role] += said.cells[role];
    }
    if (kinds > 0) {
      write_entry(entry(fmt::format("something else, of {}", counted(kinds, "kind")), others), x,
                  right, kOther);
    }
    if (any(Cell::State::invalid)) {
      draw_hatched({x, y_ - 11, 18, 13});
      canvas_.frame({x, y_ - 11, 18, 13}, kQuiet);
      write("the moved vertex makes no convex polygon", x + 27, right, kMapTextFont, kInk);
    }
    if (any(Cell::State::not_asked)) write_entry("not asked", x, right, kPaper);
  }

  void write_verdicts(double x, double right) {
    write("Verdicts, and in how many cells", x, right, kPanelFont, kInk);
    y_ += 4;
    for (std::size_t i = 0; i < kVerdictNames.size(); ++i) {
      const auto verdict = static_cast<Verdict>(i);
      const auto cells = std::ranges::count_if(map_.cells, [&](const Cell& cell) {
        return cell.state == Cell::State::judged && cell.bucket.verdict == verdict;
      });
      if (cells == 0) continue;
      const std::string words = verdict_in_words(verdict, judged_.subject.declaration.name,
                                                 judged_.oracle.declaration.name);
      write_entry(fmt::format("{} ({})", words, cells), x, right, kVerdictColours[i]);
    }
  }

  const JudgedCase& judged_;
  const Neighbourhood& map_;
  int side_;
  double pixels_;  // a cell's width
  double panel_;   // a panel's
  double width_;
  std::vector<Statement> said_;
  Canvas canvas_;
  double y_ = 0;
};

}  // namespace

std::string map_png(const JudgedCase& judged, const Neighbourhood& neighbourhood) {
  return MapPicture(judged, neighbourhood).draw();
}

CaseMap case_map(const JudgedCase& judged, const Collider& subject, const Collider& oracle,
                 int step_ulps, Interruption& interruption) {
  const PairCase& pair = judged.given.pair();
  const Grid grid = grid_around(exact::Truth(pair), step_ulps);
  const Neighbourhood map =
      ask_neighbourhood(pair, subject, oracle, grid, grid.cell_count(), interruption);
  if (interruption.is_stopped()) throw Interrupted();
  return {map_png(judged, map), {grid_in_words(grid), severity_in_words(judged, map)}};
}

}  // namespace manifuzz
