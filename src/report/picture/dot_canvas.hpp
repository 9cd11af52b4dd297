#pragma once

#include <string>
#include <vector>

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
  char mark_at(const Point& at) const;

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
  const Cell* cell(int x, int y) const;
  Cell* cell(int x, int y);

  int columns_;
  int rows_;
  std::vector<Cell> cells_;
};

}  // namespace manifuzz
