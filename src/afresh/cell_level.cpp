#include "afresh/cell_level.hpp"

#include <bit>
#include <limits>

namespace manifuzz::scene {

void BoxColumns::clear_to(std::size_t entries) {
  size = entries;
  const std::size_t padded = size + kEntriesPastLast;
  for (auto* const column : {&x_min, &y_min, &x_max, &y_max}) resize(*column, padded);
  resize(body, padded);
  std::ranges::fill(x_min, std::numeric_limits<float>::infinity());
  std::ranges::fill(body, kNone);
}

void BoxColumns::clear(std::size_t entry) {
  x_min[entry] = std::numeric_limits<float>::infinity();
  body[entry] = kNone;
}

void BoxColumns::ask_for_all() const {
  for (const auto* const column : {&x_min, &y_min, &x_max, &y_max}) scene::ask_for_all(*column);
  scene::ask_for_all(body);
}

namespace {

/// A cell's sides, as multiples of the largest box of its level.
constexpr float kCellWidth = 0.5F;
constexpr float kCellHeight = 2;

}  // namespace

void CellLevel::lay_out(float extent_max, const Box& span, std::size_t count) {
  extent_max_ = extent_max;
  aside_ = 0;
  x_origin_ = span.x_min;
  y_origin_ = span.y_min;
  x_inverse_ = 1 / (kCellWidth * extent_max);
  y_inverse_ = 1 / (kCellHeight * extent_max);
  const auto cells = [](int last) { return std::bit_ceil(static_cast<std::uint32_t>(last) + 1); };
  std::uint64_t columns = cells(column(span.x_max));
  std::uint64_t rows = cells(row(span.y_max));
  const std::uint64_t places_max = std::bit_floor(count);
  while (columns * rows > places_max) (columns > rows ? columns : rows) /= 2;
  column_mask_ = static_cast<std::uint32_t>(columns) - 1;
  row_mask_ = static_cast<std::uint32_t>(rows) - 1;
}

}  // namespace manifuzz::scene
