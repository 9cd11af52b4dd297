#include "report/picture/region.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "generating/drafts.hpp"

namespace manifuzz {
namespace {

constexpr int kBisectionsMin = 4;
constexpr int kBisectionsMax = 40;

/// The direction halfway between two unit vectors, `to` being less than a half turn
/// counter-clockwise of `from`.
Point halfway(const Point& from, const Point& to) {
  const Point sum =
      from.dot(to) < 0 ? counter_clockwise_quarter<double>(from - to) : Point(from + to);
  return unit_or_zero(sum);
}

/// An arc around a corner, and how finely it is to be drawn.
struct Arc {
  Point center{0, 0};
  double radius = 0;
  Box where;
  double tolerance = 0;

  Point at(const Point& direction) const { return center + radius * direction; }
};

/// The points from `from` to just before `to`. A chord is fine where it is near the arc, or where
/// nobody looks.
void append_arc(Region& region, const Arc& arc, const Point& from, const Point& to,
                int bisections) {
  const double chord = length(to - from) * arc.radius;
  const double sag = chord * chord / (8 * arc.radius);
  const bool is_fine =
      sag <= arc.tolerance || !inside({arc.at(from), arc.at(to)}, arc.where.grown(sag));
  if (bisections == 0 || (is_fine && bisections <= kBisectionsMax - kBisectionsMin)) {
    region.push_back(arc.at(from));
    return;
  }
  const Point middle = halfway(from, to);
  append_arc(region, arc, from, middle, bisections - 1);
  append_arc(region, arc, middle, to, bisections - 1);
}

}  // namespace

Point unit_or_zero(const Point& v) {
  const double long_as = length(v);
  return long_as > 0 ? Point(v / long_as) : Point(0, 0);
}

Point middle_of(const Region& region) {
  Point sum(0, 0);
  for (const Point& corner : region) sum += corner / static_cast<double>(region.size());
  return sum;
}

Box box_around(const std::vector<Point>& points) {
  Point least = points.front();
  Point most = points.front();
  for (const Point& point : points) {
    least = least.cwiseMin(point);
    most = most.cwiseMax(point);
  }
  return {least.x(), least.y(), most.x() - least.x(), most.y() - least.y()};
}

Point nearest(const Box& box, const Point& p) {
  return {std::clamp(p.x(), box.x, box.right()), std::clamp(p.y(), box.y, box.bottom())};
}

Box box_around_rim(const Rim& rim) {
  std::vector<Point> corners;
  for (const RimCorner& corner : rim) {
    const Point reach(corner.radius, corner.radius);
    corners.insert(corners.end(), {corner.center - reach, corner.center + reach});
  }
  return box_around(corners);
}

Rim rim_of(const exact::RoughPolygon& polygon, double radius, Rounding corners) {
  const bool is_mitred = corners == Rounding::mitre && polygon.count >= kMinVertices;
  Rim rim;
  for (int i = 0; i < polygon.count; ++i) {
    const Point& vertex = polygon.vertices[i];
    const Point& before = polygon.normals[polygon.previous(i)];
    const Point& after = polygon.normals[i];
    // Both faces are a radius farther out: their sum is 2 cos of half the turn long.
    const double span = 1 + before.dot(after);
    if (radius <= 0) {
      rim.push_back({.center = vertex});
    } else if (is_mitred && span > 0) {
      rim.push_back({.center = vertex + radius / span * (before + after)});
    } else {
      rim.push_back({vertex, radius, before, after});
    }
  }
  if (polygon.count == 1 && radius > 0) {
    rim = {{polygon.vertices[0], radius, {1, 0}, {-1, 0}},
           {polygon.vertices[0], radius, {-1, 0}, {1, 0}}};
  }
  return rim;
}

std::array<Rim, 2> rims_of(const PairCase& pair, const exact::RoughPair& placed) {
  const Rounding corners = is_round(pair) ? Rounding::round : Rounding::mitre;
  return {rim_of(placed.a, static_cast<double>(pair.a.polygon.radius), corners),
          rim_of(placed.b, static_cast<double>(pair.b.polygon.radius), corners)};
}

Region region_of(const Rim& rim, const Box& where, double tolerance) {
  Region region;
  for (const RimCorner& corner : rim) {
    if (corner.radius > 0) {
      append_arc(region, {corner.center, corner.radius, where, tolerance}, corner.from, corner.to,
                 kBisectionsMax);
    }
    region.push_back(corner.end());
  }
  return region;
}

Region intersection(const Region& region, const Region& with) {
  if (with.size() < 3) return {};
  Region left = region;
  for (std::size_t i = 0; i < with.size(); ++i) {
    const Point along = with[(i + 1) % with.size()] - with[i];
    const auto depth = [&](const Point& p) { return cross<double>(along, p - with[i]); };
    const Region whole = std::exchange(left, {});
    for (std::size_t k = 0; k < whole.size(); ++k) {
      const Point& p = whole[k];
      const Point& q = whole[(k + 1) % whole.size()];
      const double of_p = depth(p);
      const double of_q = depth(q);
      if (of_p >= 0) left.push_back(p);
      if ((of_p > 0 && of_q < 0) || (of_p < 0 && of_q > 0)) {
        left.push_back(p + (q - p) * (of_p / (of_p - of_q)));
      }
    }
  }
  return left;
}

Region intersection(const Region& region, const Box& box) {
  Region kept = intersection(region, Region{{box.x, box.y},
                                            {box.right(), box.y},
                                            {box.right(), box.bottom()},
                                            {box.x, box.bottom()}});
  // What is cut off far outside rounds by more than the box is wide.
  for (Point& p : kept) p = nearest(box, p);
  return kept;
}

double depth_in(const Region& region, const Point& p) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < region.size(); ++i) {
    const Point along = region[(i + 1) % region.size()] - region[i];
    const double edge = length(along);
    if (edge > 0) least = std::min(least, cross<double>(along, p - region[i]) / edge);
  }
  return least;
}

std::optional<Segment> inside(const Segment& segment, const Box& box) {
  const Point along = segment.second - segment.first;
  double begin = 0;
  double end = 1;
  for (const int axis : {0, 1}) {
    const double low = (axis == 0 ? box.x : box.y) - segment.first[axis];
    const double high = (axis == 0 ? box.right() : box.bottom()) - segment.first[axis];
    if (along[axis] == 0) {
      if (low > 0 || high < 0) return std::nullopt;
      continue;
    }
    const auto [enter, leave] = std::minmax({low / along[axis], high / along[axis]});
    begin = std::max(begin, enter);
    end = std::min(end, leave);
  }
  if (!(begin <= end)) return std::nullopt;
  // Far ends are rounded by more than a frame.
  return Segment(nearest(box, segment.first + begin * along),
                 nearest(box, segment.first + end * along));
}

std::optional<Box> nearest_free(const Box& wanted, const std::vector<Box>& taken,
                                const Box& frame) {
  std::optional<Box> nearest;
  for (const bool downwards : {true, false}) {
    Box box = wanted;
    const auto overlaps = [&](const Box& other) { return other.overlaps(box); };
    auto other = std::ranges::find_if(taken, overlaps);
    while (other != taken.end() && frame.contains(box)) {
      box.y = downwards ? other->bottom() + 0.1 : other->y - box.height - 0.1;
      other = std::ranges::find_if(taken, overlaps);
    }
    if (!frame.contains(box)) continue;
    if (!nearest || std::abs(box.y - wanted.y) < std::abs(nearest->y - wanted.y)) nearest = box;
  }
  return nearest;
}

}  // namespace manifuzz
