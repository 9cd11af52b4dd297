#include "report/picture/dot_canvas.hpp"

#include <algorithm>
#include <cmath>

namespace manifuzz {
namespace {

/// The bits of a cell's dots, by row and column.
constexpr unsigned kBits[4][2] = {{0x01, 0x08}, {0x02, 0x10}, {0x04, 0x20}, {0x40, 0x80}};

int nearest_dot(double x) {
  return static_cast<int>(std::floor(x + 0.5));
}

/// U+2800 and the dots, in UTF-8.
std::string braille(unsigned dots) {
  return {'\xe2', static_cast<char>(0xa0 | (dots >> 6)), static_cast<char>(0x80 | (dots & 0x3f))};
}

}  // namespace

DotCanvas::DotCanvas(int columns, int rows)
    : columns_(columns), rows_(rows), cells_(static_cast<std::size_t>(columns * rows)) {}

const DotCanvas::Cell* DotCanvas::cell(int x, int y) const {
  if (x < 0 || x >= width() || y < 0 || y >= height()) return nullptr;
  return &cells_[static_cast<std::size_t>(y / 4 * columns_ + x / 2)];
}

DotCanvas::Cell* DotCanvas::cell(int x, int y) {
  return const_cast<Cell*>(std::as_const(*this).cell(x, y));
}

void DotCanvas::dot(int x, int y) {
  if (Cell* const at = cell(x, y)) at->dots |= kBits[y % 4][x % 2];
}

void DotCanvas::line(const Point& from, const Point& to, int every) {
  const int x = nearest_dot(from.x());
  const int y = nearest_dot(from.y());
  const int dx = nearest_dot(to.x()) - x;
  const int dy = nearest_dot(to.y()) - y;
  const int steps = std::max({std::abs(dx), std::abs(dy), 1});
  for (int i = 0; i <= steps; i += every) {
    const double share = static_cast<double>(i) / steps;
    dot(x + nearest_dot(share * dx), y + nearest_dot(share * dy));
  }
}

void DotCanvas::mark(const Point& at, char mark) {
  if (Cell* const marked = cell(nearest_dot(at.x()), nearest_dot(at.y()))) marked->mark = mark;
}

char DotCanvas::mark_at(const Point& at) const {
  const Cell* const marked = cell(nearest_dot(at.x()), nearest_dot(at.y()));
  return marked == nullptr ? '\0' : marked->mark;
}

std::string DotCanvas::text() const {
  std::string text;
  for (int row = 0; row < rows_; ++row) {
    const auto begin = cells_.begin() + row * columns_;
    const auto is_used = [](const Cell& cell) { return cell.mark != 0 || cell.dots != 0; };
    const auto last = std::find_if(std::make_reverse_iterator(begin + columns_),
                                   std::make_reverse_iterator(begin), is_used);
    for (auto cell = begin; cell != last.base(); ++cell) {
      text += cell->mark != 0 ? std::string(1, cell->mark) : braille(cell->dots);
    }
    text += '\n';
  }
  const std::size_t begin = std::min(text.find_first_not_of('\n'), text.size());
  while (text.size() > begin + 1 && text.ends_with("\n\n")) text.pop_back();
  return text.substr(begin);
}

}  // namespace manifuzz
