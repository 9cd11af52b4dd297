#pragma once

#include <optional>
#include <string>
#include <vector>

#include "report/picture/svg.hpp"

namespace manifuzz {

/// A word or two beside what it names.
struct Label {
  std::string text;
  Point anchor{0, 0};   ///< what it names, in pixels
  Point towards{0, 0};  ///< the direction in which it had rather lie, unit or zero
  Font font = {};
  std::string css;
  double reach = 1e9;  ///< how far from its anchor it may lie; left out where that does not do
};

/// Finds places for labels inside a frame: none covers another or what is blocked, lines are
/// covered and crossed as little as can be, and each lies near what it names.
class LabelLayer {
 public:
  explicit LabelLayer(const Box& frame) : frame_(frame) {}

  /// Never to be covered.
  void block(const Box& box) { blocked_.push_back(box); }
  /// To be covered only where there is nothing better.
  void avoid(const Segment& line) { lines_.push_back(line); }

  /// Whether a box covers nothing: neither what is blocked nor a line.
  bool is_free(const Box& box) const;

  /// Places the label and blocks its place; in the order of importance. False if there is none.
  bool place(const Label& label);

  void draw(Svg& svg) const;

 private:
  struct Placed {
    Label label;
    Box box;
    std::optional<Segment> leader;
  };
  bool is_blocked(const Box& box) const;
  double cost(const Label& label, const Box& box, double best) const;

  Box frame_;
  std::vector<Box> blocked_;
  std::vector<Segment> lines_;
  std::vector<Placed> placed_;
};

}  // namespace manifuzz
