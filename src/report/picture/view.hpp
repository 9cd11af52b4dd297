#pragma once

#include <string>
#include <vector>

#include "report/picture/scene.hpp"

namespace manifuzz {

/// A frame on the canvas (pixels, y down) and what of the scene it shows (y up), at one scale.
struct View {
  Box frame;
  Point center{0, 0};  ///< in the scene, in the middle of the frame
  double scale = 1;    ///< pixels a length

  Point place(const Point& p) const {
    const Point moved = (p - center) * scale;
    return frame.center() + Point(moved.x(), -moved.y());
  }
  Segment place(const Segment& s) const { return {place(s.first), place(s.second)}; }
  Region place(const Region& region) const;
  /// The part of the scene inside the frame.
  Box shown() const {
    return {center.x() - frame.width / 2 / scale, center.y() - frame.height / 2 / scale,
            frame.width / scale, frame.height / scale};
  }
  /// A direction of the scene, on the canvas.
  static Point direction(const Point& d) { return {d.x(), -d.y()}; }
};

/// The views of a picture: the whole scene first, then up to two closer ones. The first
/// of these shows the largest thing of interest that is too small to be seen so far, the second the
/// depth or else the smallest.
/// They fill a box of this width from (x, y) down; how high it is they decide.
std::vector<View> choose_views(const Scene& scene, double x, double y, double width);

}  // namespace manifuzz
