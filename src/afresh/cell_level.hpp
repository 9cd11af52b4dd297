#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "afresh/lists.hpp"
#include "afresh/shape_table.hpp"

namespace manifuzz::scene {

/// Vectors read so many entries past the last one.
inline constexpr std::size_t kEntriesPastLast = 64;

/// Boxes that lie together in memory as their cells do: a coordinate an array, so that a vector
/// compares as many boxes as it has lanes. An entry without a body overlaps no box.
struct BoxColumns {
  std::vector<float> x_min, y_min, x_max, y_max;
  std::vector<std::uint32_t> body;
  std::size_t size = 0;  ///< of them; the arrays are longer

  /// All entries without a body.
  void clear_to(std::size_t entries);
  void set(std::size_t entry, std::uint32_t of_body, const Box& box) {
    x_min[entry] = box.x_min;
    y_min[entry] = box.y_min;
    x_max[entry] = box.x_max;
    y_max[entry] = box.y_max;
    body[entry] = of_body;
  }
  void clear(std::size_t entry);
  /// Asks for one ahead of its use.
  void ask_for(std::size_t entry) const {
    for (const auto* const column : {&x_min, &y_min, &x_max, &y_max}) {
      scene::ask_for(*column, entry);
    }
    scene::ask_for(body, entry);
  }
  /// Asks for all of them ahead of their use.
  void ask_for_all() const;
  Box box(std::size_t entry) const {
    return {x_min[entry], y_min[entry], x_max[entry], y_max[entry]};
  }
};

/// Cells that a box's lower left corner can lie in, x and y each from first to last.
struct CellRange {
  int x_first, x_last, y_first, y_last;
};

/// Boxes of about one size, by the cells of their lower left corners. The cells lie row by row, and
/// those of a row follow each other, so that what is near a box is a few runs of entries. Far apart
/// cells share a place where there are many more cells than boxes. Every step from a coordinate to
/// its cell is monotone, rounded as it is: what overlaps is never missed.
class CellLevel {
 public:
  /// Makes it a level for boxes up to this wide and high, a length, whose corners lie in `span`;
  /// about `count`. It keeps its memory.
  void lay_out(float extent_max, const Box& span, std::size_t count);

  /// No box of the level is wider or higher; a length.
  float extent_max() const { return extent_max_; }

  /// The place of the cell in which a box's lower left corner lies.
  std::uint32_t place_of(const Box& box) const { return place(column(box.x_min), row(box.y_min)); }
  /// The place of the cell to the right of one's.
  std::uint32_t next_in_row(std::uint32_t place) const {
    return (place & ~column_mask_) | ((place + 1) & column_mask_);
  }
  std::uint32_t places() const { return (column_mask_ + 1) * (row_mask_ + 1); }

  /// From now on a box may lie so many cells to the right of its own.
  void allow_aside(int cells) { aside_ = std::max(aside_, cells); }

  /// The cells of boxes that may overlap this one.
  CellRange near(const Box& box) const {
    return {column(box.x_min - extent_max_), column(box.x_max) + aside_,
            row(box.y_min - extent_max_), row(box.y_max)};
  }
  /// Cells of boxes whose left side is not left of this one's, where each lies in its own cell.
  CellRange right_of(const Box& box) const {
    return {column(box.x_min), column(box.x_max), row(box.y_min - extent_max_), row(box.y_max)};
  }

  /// Calls `run(first, last)` for the entries in those cells, each once.
  template <class Run>
  void each_run(const CellRange& range, const Run& run) const {
    const std::uint32_t columns = column_mask_ + 1;
    const auto rows = std::min<std::uint32_t>(
        static_cast<std::uint32_t>(range.y_last - range.y_first), row_mask_);
    const bool all_columns =
        static_cast<std::uint32_t>(range.x_last - range.x_first) >= column_mask_;
    const std::uint32_t left =
        all_columns ? 0 : static_cast<std::uint32_t>(range.x_first) & column_mask_;
    const std::uint32_t right =
        all_columns ? column_mask_ : static_cast<std::uint32_t>(range.x_last) & column_mask_;
    for (std::uint32_t k = 0; k <= rows; ++k) {
      const std::uint32_t row = (static_cast<std::uint32_t>(range.y_first) + k) & row_mask_;
      const std::uint32_t* const begin = begin_.data() + std::size_t{row} * columns;
      if (left <= right) {
        run(begin[left], begin[right + 1]);
      } else {
        run(begin[left], begin[columns]);
        run(begin[0], begin[right + 1]);
      }
    }
  }

  /// Where each place's entries begin, and where the last one's end.
  std::vector<std::uint32_t>& begin() { return begin_; }
  const std::vector<std::uint32_t>& begin() const { return begin_; }

 private:
  static int cell(float x, float origin, float inverse) {
    constexpr float kCellMax = 1 << 29;
    const float place = std::clamp((x - origin) * inverse, -kCellMax, kCellMax);
    const int towards_zero = static_cast<int>(place);
    return towards_zero - static_cast<int>(place < static_cast<float>(towards_zero));
  }
  int column(float x) const { return cell(x, x_origin_, x_inverse_); }
  int row(float y) const { return cell(y, y_origin_, y_inverse_); }
  std::uint32_t place(int column, int row) const {
    return (static_cast<std::uint32_t>(row) & row_mask_) * (column_mask_ + 1) +
           (static_cast<std::uint32_t>(column) & column_mask_);
  }

  float extent_max_ = 0;
  float x_origin_ = 0;
  float y_origin_ = 0;
  float x_inverse_ = 0;  ///< of a cell's width and height
  float y_inverse_ = 0;
  int aside_ = 0;  ///< so many cells to the right of its own a box may lie
  std::uint32_t column_mask_ = 0;
  std::uint32_t row_mask_ = 0;
  std::vector<std::uint32_t> begin_;
};

}  // namespace manifuzz::scene
