#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "kernel/packed.hpp"
#include "scene/cell_level.hpp"

namespace manifuzz::scene {

/// Bodies by their boxes, of any mix of sizes: in levels, each of boxes down to a quarter of its
/// largest, filed by counting.
class Cells {
 public:
  /// Files these bodies anew; `boxes` is by body. Each cell has room for so many more.
  void file(std::span<const std::uint32_t> bodies, std::span<const Box> boxes, std::uint32_t room);

  /// Files a body whose box was another one, or that was not there (`before` is null); false where
  /// it finds no room, and all must be filed anew.
  bool refile(std::uint32_t body, const Box* before, const Box& box);

  /// Of a body that is filed with this box.
  void remove(std::uint32_t body, const Box& box);

  /// Puts the bodies whose boxes overlap this one into `found`, in no particular order.
  void near(const Box& box, std::vector<std::uint32_t>& found) const;

  /// Puts all pairs of bodies whose boxes overlap into `found`, each once, a < b.
  void pairs(std::vector<kernel::BodyPair>& found);

  /// The memory it takes.
  std::size_t bytes() const;

 private:
  void make_levels(std::span<const std::uint32_t> bodies, std::span<const Box> boxes);
  std::size_t level_of(const Box& box) const;
  /// Of a body, or of kNone, in a place; none if there is none.
  static std::optional<std::size_t> entry_of(const CellLevel& level, std::uint32_t place,
                                             std::uint32_t body);

  std::span<CellLevel> levels() { return std::span(levels_).first(used_); }
  std::span<const CellLevel> levels() const { return std::span(levels_).first(used_); }

  std::vector<CellLevel> levels_;  // the finest first
  std::size_t used_ = 0;           // of them

  // Of the filing under way: of each body its level and its place there.
  std::vector<std::uint8_t> level_;
  std::vector<std::uint32_t> place_;
  std::vector<std::uint32_t> found_;  // by one of the boxes
};

}  // namespace manifuzz::scene
