#include "judging/extent.hpp"

#include <algorithm>

namespace manifuzz {
namespace {

using exact::Clip;
using exact::ClipPoint;

/// Whether a right answer has the point: it is deeper than rounding, and the edge does not miss.
bool must_be_there(const Bounds& bounds, const Clip& clip, const ClipPoint& point) {
  return compare_depth(clip, point, depth_bound(bounds, clip, point)) > 0 &&
         compare_gap(clip, -bounds.separation) < 0 && compare_width(clip, bounds.separation) > 0;
}

/// How much of the way from one place to another, along a line, is between a manifold's points.
double spanned(const Manifold<double>& manifold, const Vector2<double>& along, double low,
               double high) {
  if (manifold.count < 2) return 0;
  const auto [first, last] =
      std::minmax({along.dot(manifold.points[0].position), along.dot(manifold.points[1].position)});
  return std::max(std::min(high, last) - std::max(low, first), 0.0);
}

ExtentLeftOut against(const Clip& clip, const Bounds& bounds, const Manifold<double>& manifold) {
  ExtentLeftOut left;
  int there = 0;
  for (const ClipPoint& point : points_of(clip)) {
    there += must_be_there(bounds, clip, point) ? 1 : 0;
  }
  if (there == 2) {
    const auto& [first, last] = clip.points;
    // Each of the points, and what is right for it, may be off by as much.
    left.bound = 2 * (position_bound(bounds, clip, first) + position_bound(bounds, clip, last));
    if (compare_apart(clip, left.bound) <= 0) {
      there = 1;
    } else {
      const Vector2<double> along = counter_clockwise_quarter(clip.normal);
      const auto [low, high] =
          std::minmax({along.dot(first.position()), along.dot(last.position())});
      left.run = high - low;
      left.depth = std::min(first.depth(), last.depth());
      left.lost = left.run - spanned(manifold, along, low, high);
    }
  }
  left.points = std::max(there - manifold.count, 0);
  return left;
}

bool leaves_less(const ExtentLeftOut& one, const ExtentLeftOut& other) {
  return std::pair(one.points, one.lost) < std::pair(other.points, other.lost);
}

}  // namespace

std::optional<double> ExtentLeftOut::share() const {
  if (run <= bound) return std::nullopt;
  return lost <= bound ? 0 : lost / run;
}

ExtentLeftOut extent_left_out(const exact::Truth& truth, const TieBias& tie_bias,
                              const Bounds& bounds, const Manifold<double>& manifold) {
  std::optional<ExtentLeftOut> least;
  for (const Side side : {Side::a, Side::b}) {
    if (!may_be_reference(truth, tie_bias, side, bounds.separation)) continue;
    for (const Clip* const clip : clips_within(truth, side, bounds)) {
      const ExtentLeftOut left = against(*clip, bounds, manifold);
      if (!least || leaves_less(left, *least)) least = left;
    }
  }
  return least.value_or(ExtentLeftOut{});
}

std::optional<Mismatch> extent_mismatch(const exact::Truth& truth, const Declaration& declaration,
                                        const Bounds& bounds, double tolerance,
                                        const Manifold<double>& manifold) {
  if (declaration.clips || declaration.one_point_enough) return std::nullopt;
  Bounds of_faces = bounds;
  of_faces.separation *= 2;  // so much more than the least depth a face may have that it takes
  const ExtentLeftOut left = extent_left_out(truth, declaration.tie_bias, of_faces, manifold);
  const double bound = left.bound + 2 * tolerance;
  if (left.lost <= bound) return std::nullopt;
  return Mismatch{manifold.count < 2 ? Kind::count : Kind::extent, left.lost, bound, left.depth};
}

}  // namespace manifuzz
