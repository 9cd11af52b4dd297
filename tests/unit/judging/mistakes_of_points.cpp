#include <cmath>

#include "exact/witness.hpp"
#include "mistakes.hpp"

namespace manifuzz::mistakes {
namespace {

Declaration point() {
  return of(Claims::point);
}
Declaration on_a() {
  return of(Claims::point, PointsAt::surface_a);
}
Declaration on_b() {
  return of(Claims::point, PointsAt::surface_b);
}
Declaration midpoint() {
  return of(Claims::point, PointsAt::midpoint);
}
Declaration at_vertex() {
  return of(Claims::point, PointsAt::vertex);
}
Declaration points() {
  return of(Claims::manifold);
}
Declaration shared() {
  Declaration declaration = points();
  declaration.shares_depth = true;
  return declaration;
}

Given moved(const Right& right, const Vector2<double>& by, int of_point, int count) {
  Manifold<double> manifold = count == 1 ? right.only(right.deepest) : right.manifold;
  if (of_point >= manifold.count) return std::nullopt;
  manifold.points[of_point].position += by;
  return manifold;
}

Given with_depth(const Right& right, double depth) {
  Manifold<double> manifold = right.only(right.deepest);
  manifold.points[0].depth = depth;
  return manifold;
}

/// The ends of the incident edge, each with its depth to the reference face's plane: nothing is
/// clipped.
Given unclipped(const Right& right, const Declaration& by) {
  const auto& m = right.manifold;
  const auto front = right.truth->greatest(m.reference);
  const int incident = right.truth->incident_edges(front, 0).front();
  const exact::Clip& clip = right.truth->clip(front, incident);
  Manifold<double> whole = m;
  bool hangs = false;
  for (int end = 0; end < 2; ++end) {
    const auto at = exact::vertex<double>(right.pair(), other(m.reference), clip.vertex(end));
    const Vector2<double> position =
        rotate_inverse<double>(right.pair().a.pose.rotation.cast<double>(), {at.x, at.y});
    const double rise = (m.reference == Side::a ? 1 : -1) *
                        (right.manifold.points[0].position - position).dot(m.normal);
    const double scale = right.pair().a.pose.rotation.cast<double>().norm();
    whole.points[end] = {position, m.points[0].depth + rise * scale, {}};
    const double outside = std::max(-clip.along[end].value, (clip.along[end] - clip.width).value);
    if (outside > kClearly * right.bounds(by).along && whole.points[end].depth > 0) hangs = true;
  }
  whole.count = 2;
  if (!hangs || whole.points[0].depth < 0 || whole.points[1].depth < 0) return std::nullopt;
  return whole;
}

/// Both points' depths differ clearly.
bool differ(const Right& right, const Declaration& by) {
  return right.manifold.count == 2 &&
         right.is_clear(right.manifold.points[0].depth - right.manifold.points[1].depth, by);
}

}  // namespace

std::vector<Mistake> of_points() {
  return {
      {"no point for an overlap",
       point,
       [](const Right&, const Declaration&) -> Given { return Manifold<double>{}; },
       {Kind::missed_contact}},
      {"a point with a reversed normal",
       point,
       [](const Right& r, const Declaration& by) -> Given {
         if (!r.can_be_reversed(by)) return std::nullopt;
         Manifold<double> reversed = r.only(r.deepest);
         reversed.normal = -reversed.normal;
         return reversed;
       },
       {Kind::reversed}},
      {"a point ten bounds too deep",
       point,
       [](const Right& r, const Declaration& by) {
         return with_depth(r, r.depth + kClearly * r.bounds(by).consistency);
       },
       {Kind::inconsistent}},
      {"a point ten bounds too shallow",
       point,
       [](const Right& r, const Declaration& by) {
         return with_depth(r, r.depth - kClearly * r.bounds(by).consistency);
       },
       {Kind::inconsistent}},
      {"a point beside both",
       point,
       [](const Right& r, const Declaration&) {
         return moved(r, r.beyond() * turned(r.normal, 1.57), 0, 1);
       },
       {Kind::witness}},
      {"a point in front of both",
       point,
       [](const Right& r, const Declaration&) { return moved(r, r.beyond() * r.normal, 0, 1); },
       {Kind::witness}},
      {"the shallower of two points",
       point,
       [](const Right& r, const Declaration& by) -> Given {
         if (!differ(r, by)) return std::nullopt;
         return r.only(1 - r.deepest);
       },
       {Kind::inconsistent}},
      {"a point on B that should be on A",
       on_a,
       [](const Right& r, const Declaration& by) -> Given {
         if (r.manifold.reference == Side::b || !r.overlaps(by)) return std::nullopt;
         return r.only(r.deepest);
       },
       {Kind::witness}},
      {"a point on A that should be on B",
       on_b,
       [](const Right& r, const Declaration& by) -> Given {
         if (r.manifold.reference == Side::a || !r.overlaps(by)) return std::nullopt;
         return r.only(r.deepest);
       },
       {Kind::witness}},
      {"a midpoint beyond B's surface",
       midpoint,
       [](const Right& r, const Declaration&) {
         return moved(r, -(r.depth + r.truth->extent()) * r.normal, 0, 1);
       },
       {Kind::witness}},
      {"a point between vertices that should be at one",
       at_vertex,
       [](const Right& r, const Declaration& by) -> Given {
         if (r.manifold.count < 2) return std::nullopt;
         Manifold<double> between = r.only(r.deepest);
         ContactPoint<double>& point = between.points[0];
         const double radii = total_radius(r.pair());
         point.position = (r.manifold.points[0].position + r.manifold.points[1].position) / 2;
         if (exact::is_at_vertex(*r.truth, point.position,
                                 kClearly * r.bounds(by).across + radii)) {
           return std::nullopt;
         }
         if (differ(r, by)) return std::nullopt;
         return between;
       },
       {Kind::witness}},
      {"an edge that is not clipped",
       points,
       [](const Right& r, const Declaration& by) { return unclipped(r, by); },
       {Kind::inconsistent, Kind::witness}},
      {"one depth for two that differ",
       points,
       [](const Right& r, const Declaration& by) -> Given {
         if (!differ(r, by) || r.is_clear(r.manifold.points[r.deepest].depth - r.depth, by)) {
           return std::nullopt;
         }
         Manifold<double> same = r.manifold;
         same.points[1 - r.deepest].depth = same.points[r.deepest].depth;
         return same;
       },
       {Kind::witness}},
      {"the shallower depth for both",
       shared,
       [](const Right& r, const Declaration& by) -> Given {
         if (!differ(r, by)) return std::nullopt;
         Manifold<double> same = r.manifold;
         same.points[r.deepest].depth = same.points[1 - r.deepest].depth;
         return same;
       },
       {Kind::inconsistent}},
      {"depths exchanged",
       points,
       [](const Right& r, const Declaration& by) -> Given {
         if (!differ(r, by)) return std::nullopt;
         Manifold<double> exchanged = r.manifold;
         std::swap(exchanged.points[0].depth, exchanged.points[1].depth);
         return exchanged;
       },
       {Kind::witness}},
      {"a second point beside both",
       points,
       [](const Right& r, const Declaration&) {
         return moved(r, r.beyond() * turned(r.normal, 1.57), 1, 2);
       },
       {Kind::witness}},
      {"points in B's frame",
       points,
       [](const Right& r, const Declaration&) -> Given {
         Manifold<double> theirs = r.manifold;
         for (int i = 0; i < theirs.count; ++i) {
           const Vector2<double> world = to_world(r.pair(), theirs.points[i].position);
           theirs.points[i].position = to_local(r.pair().b.pose, world);
           const Vector2<double> off = theirs.points[i].position - r.manifold.points[i].position;
           if (!(std::abs(off.dot(r.normal)) > 2 * r.depth)) return std::nullopt;
         }
         return theirs;
       },
       {Kind::witness}},
  };
}

}  // namespace manifuzz::mistakes
