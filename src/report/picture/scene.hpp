#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "campaign/plan.hpp"
#include "report/picture/drawing.hpp"

namespace manifuzz {

inline constexpr std::array<Side, 2> kSides{Side::a, Side::b};

/// A face of a polygon where it stands.
struct PlacedFace {
  Side side = Side::a;
  int index = 0;
  Segment segment;
};

/// A depth as a stretch along the normal: from the incident shape's skin to the reference face's.
struct DepthBar {
  Point from{0, 0};
  Point to{0, 0};
  double depth = 0;  ///< world length; negative: a gap
};

/// A contact point that a collider reported.
struct DrawnPoint {
  bool by_subject = true;
  Point position{0, 0};  ///< finite; all else need not be
  Point normal{0, 0};    ///< of its manifold, from A to B, as long as it was reported
  DepthBar bar;
};

/// What a picture of a case shows: world directions and lengths, seen from A's position.
struct Scene {
  exact::RoughPair polygons;
  std::array<double, 2> radii{};
  /// Of the candidate to show; where the polygons are apart, the face of the greatest separation
  /// alone.
  PlacedFace reference;
  std::optional<PlacedFace> incident;
  Point outward{0, 0};             ///< the reference face's normal, unit
  DepthBar deepest;                ///< the truth at the deepest point
  double depth = 0;                ///< of the overlap, or the gap; a world length
  double rounding = 0;             ///< how far the subject's figures may be off, by its bounds
  std::vector<Point> right;        ///< the candidate's contact points
  std::vector<DrawnPoint> points;  ///< the subject's first

  double radius(Side side) const { return radii[static_cast<std::size_t>(side)]; }
  Point a_to_b() const { return reference.side == Side::a ? outward : Point(-outward); }
  /// A polygon with its skin, which inside the box comes within `tolerance` of the arcs.
  Region shape(Side side, const Box& where, double tolerance) const {
    return rounded(polygons[side], radius(side), where, tolerance);
  }
  /// Around both shapes and the points that are not farther off than `reach` times their size.
  Box whole(double reach) const;
};

/// `answers`: the subject's, then the oracle's if there is one.
Scene make_scene(const PairCase& pair, std::span<const DeclaredAnswer> answers);

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
  /// Where the scale stands; no label does.
  Box footer() const { return {frame.x + 8, frame.bottom() - 24, 290, 20}; }
  /// A direction of the scene, on the canvas.
  static Point direction(const Point& d) { return {d.x(), -d.y()}; }
};

/// The views of a picture: the whole scene first, then up to two closer ones. The first of these
/// shows the largest thing of interest that is too small to be seen so far, the second the depth or
/// else the smallest. They fill a box of this width from (x, y) down; how high it is they decide.
std::vector<View> choose_views(const Scene& scene, double x, double y, double width);

/// Everything of the scene that the view shows. `names` are the subject's and the oracle's.
void draw_view(Svg& svg, const Scene& scene, const View& view,
               const std::array<std::string, 2>& names);

/// A contact point's mark: the subject's a disc, the oracle's a square around it.
void draw_mark(Svg& svg, const Point& at, bool by_subject);

}  // namespace manifuzz
