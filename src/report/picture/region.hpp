#pragma once

#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "exact/placed.hpp"
#include "geometry/convex_polygon.hpp"

namespace manifuzz {

// Plain geometry of pictures, in double and in any units: good enough to look at.

using Point = Vector2<double>;
using Segment = std::pair<Point, Point>;

/// A convex region by its corners in order; fewer than three: nothing.
using Region = std::vector<Point>;

/// A rectangle with its sides along the axes.
struct Box {
  double x = 0;  ///< of the corner with the least coordinates
  double y = 0;
  double width = 0;
  double height = 0;

  double right() const { return x + width; }
  double bottom() const { return y + height; }
  Point center() const { return {x + width / 2, y + height / 2}; }
  bool contains(const Point& p) const {
    return p.x() >= x && p.x() <= right() && p.y() >= y && p.y() <= bottom();
  }
  bool contains(const Box& box) const {
    return box.x >= x && box.right() <= right() && box.y >= y && box.bottom() <= bottom();
  }
  bool overlaps(const Box& box) const {
    return x < box.right() && box.x < right() && y < box.bottom() && box.y < bottom();
  }
  Box grown(double by) const { return {x - by, y - by, width + 2 * by, height + 2 * by}; }
};

/// The mean of the corners, of which there is one at least.
Point middle_of(const Region& region);

/// The smallest box around points, of which there is one at least.
Box box_around(const std::vector<Point>& points);

/// `v` at length 1, or zero where it has none.
Point unit_or_zero(const Point& v);

/// The point of the box nearest to `p`.
Point nearest(const Box& box, const Point& p);

/// A corner of a convex shape with a radius: an arc about a place, counter-clockwise (y up) between
/// two unit directions that are at most half a turn apart. Of radius 0 a sharp corner.
struct RimCorner {
  Point center{0, 0};
  double radius = 0;
  Point from{0, 0};
  Point to{0, 0};

  Point begin() const { return center + radius * from; }
  Point end() const { return center + radius * to; }
};

/// A convex shape by its corners in order, straight from the end of each to the begin of the next.
/// A circle has two, half a turn each.
using Rim = std::vector<RimCorner>;

/// A core with its radius, its corners round or as sharp as the core's; fewer than three vertices
/// are always round.
Rim rim_of(const exact::RoughPolygon& polygon, double radius, Rounding corners);

/// A's and B's, with skins that are mitred where both are: that is how they are judged.
std::array<Rim, 2> rims_of(const PairCase& pair, const exact::RoughPair& placed);

Box box_around_rim(const Rim& rim);

/// The arcs as short edges, which inside the box come within `tolerance` of them.
Region region_of(const Rim& rim, const Box& where, double tolerance);

/// What both convex regions cover; both counter-clockwise (y up).
Region intersection(const Region& region, const Region& with);
Region intersection(const Region& region, const Box& box);

/// How far inside a counter-clockwise convex region a point is; negative: how far outside, at
/// least.
double depth_in(const Region& region, const Point& p);

/// The part of a segment inside the box.
std::optional<Segment> inside(const Segment& segment, const Box& box);

/// The nearest box straight above or below the one that is wanted, or that itself, that is in the
/// frame and overlaps nothing that is taken.
std::optional<Box> nearest_free(const Box& wanted, const std::vector<Box>& taken, const Box& frame);

}  // namespace manifuzz
