#pragma once

#include <span>
#include <string>
#include <vector>

#include "campaign/judged_case.hpp"
#include "report/picture/region.hpp"

namespace manifuzz {

/// A picture of characters, each of them two by four dots as Braille has them; marks stand over the
/// dots. Coordinates are dots, y down; what lies outside is not drawn.
class DotCanvas {
 public:
  DotCanvas(int columns, int rows);

  int width() const { return 2 * columns_; }
  int height() const { return 4 * rows_; }

  void dot(int x, int y);
  /// Both ends are inside. `every`: 1 for a solid line, 2 for each second dot of it.
  void line(const Point& from, const Point& to, int every);
  /// One character over the dot's cell.
  void mark(const Point& at, char mark);
  /// The mark over the dot's cell, or 0; nothing stands outside.
  char mark_at(const Point& at);

  /// The rows as lines of UTF-8. Empty cells are empty Braille, which is as wide as the others
  /// wherever they are not as wide as a blank; none at the end of a line, and no empty rows at the
  /// top and the bottom.
  std::string text() const;

 private:
  struct Cell {
    unsigned dots = 0;
    char mark = 0;
  };
  /// The cell of a dot, or nullptr.
  Cell* cell(int x, int y);

  int columns_;
  int rows_;
  std::vector<Cell> cells_;
};

/// The case as a picture of characters, for terminals, logs and code blocks: outlines, overlap,
/// right contact points and those of the answers (the subject, then the oracle if there is one), a
/// closer view where these are too near each other, a legend. At most 76 characters wide but for
/// the legend, and 46 lines with it; UTF-8.
std::string text_picture(const PairCase& pair, std::span<const DeclaredAnswer> answers);

/// Of a case between two colliders.
std::string text_picture(const JudgedCase& judged);

}  // namespace manifuzz
