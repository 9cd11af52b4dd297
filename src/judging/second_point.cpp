#include "judging/second_point.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "exact/fine_point.hpp"

namespace manifuzz {
namespace {

using exact::DoubleDouble;
using exact::FaceOf;
using exact::FinePoint;

/// An edge as it is seen along a contact's normal.
struct SeenEdge {
  DoubleDouble low;   ///< its first place along the tangent
  DoubleDouble high;  ///< its last
  DoubleDouble height_at_low;
  DoubleDouble height_at_high;
  double cosine = 0;  ///< of the angle between its normal and the contact's, out of its core

  DoubleDouble height_at(const DoubleDouble& place) const {
    const DoubleDouble run = high - low;
    if (!(run.high > 0)) return height_at_low;
    return height_at_low + (height_at_high - height_at_low) * ((place - low) / run);
  }
};

/// Both cores along one normal.
class AlongContact {
 public:
  AlongContact(const exact::Truth& truth, const Bounds& bounds, const Vector2<double>& normal)
      : pair_(truth.stored()), bounds_(bounds), normal_(in_world(pair_, normal)) {}

  DoubleDouble place(const FinePoint& p) const { return cross(normal_, p); }
  DoubleDouble place(const Vector2<double>& local) const {
    return place(turned(pair_.a, exact::widen<DoubleDouble>(local)));
  }
  double total_radius() const { return exact::total_radius<DoubleDouble>(pair_).high; }

  /// The edges of a side that meet in a vertex that is farthest towards the other side within
  /// bound, and are the more perpendicular to the normal within bound; none of a point.
  std::vector<SeenEdge> best_edges(Side side) const {
    std::vector<SeenEdge> best;
    const auto& polygon = pair_[side].polygon;
    if (polygon.face_count() == 0) return best;
    std::vector<double> ahead;
    ahead.reserve(static_cast<std::size_t>(polygon.count));
    for (int i = 0; i < polygon.count; ++i) ahead.push_back(height(side, i).high);
    const double most = *std::ranges::max_element(ahead);
    for (int i = 0; i < polygon.count; ++i) {
      if (ahead[static_cast<std::size_t>(i)] < most - 2 * bounds_.separation) continue;
      const SeenEdge edges[] = {seen({side, polygon.previous(i)}), seen({side, i})};
      const double flattest = std::max(edges[0].cosine, edges[1].cosine);
      for (const SeenEdge& edge : edges) {
        if (edge.cosine >= flattest - bounds_.incident_dot) best.push_back(edge);
      }
    }
    return best;
  }

 private:
  /// Towards the other side.
  DoubleDouble height(Side side, int vertex) const {
    const DoubleDouble up = dot(normal_, exact::vertex<DoubleDouble>(pair_, side, vertex));
    return side == Side::a ? up : -up;
  }
  SeenEdge seen(FaceOf face) const {
    const int next = pair_[face.side].polygon.next(face.index);
    const auto from = exact::vertex<DoubleDouble>(pair_, face.side, face.index);
    const auto to = exact::vertex<DoubleDouble>(pair_, face.side, next);
    const double out = dot(unit_of(exact::outward_from_a<DoubleDouble>(pair_, face)), normal_).high;
    const SeenEdge edge{place(from), place(to), dot(normal_, from), dot(normal_, to), out};
    if ((edge.high - edge.low).high >= 0) return edge;
    return {edge.high, edge.low, edge.height_at_high, edge.height_at_low, out};
  }

  const exact::StoredPair& pair_;
  const Bounds& bounds_;
  FinePoint normal_;
};

/// What the clip of two edges keeps besides the deepest point.
struct Second {
  bool is_allowed = false;   ///< a right collider may give it
  bool is_required = false;  ///< it must
  double run = 0;            ///< between both points, along the tangent, a world length
  double off = 0;            ///< how far a far end may be off, a world length
  double depth = 0;          ///< of the end that is less deep, a world length
};

/// The cosine by which rounding may move a far end along the steeper of two edges. An edge that
/// stands on the other, or nearly so, ends at its own vertices, unless an end of the other is
/// within `reach` of it, a world length: the side plane there may cut it anywhere.
double steepness(const SeenEdge& a, const SeenEdge& b, double reach) {
  constexpr double standing = 1e-3;
  const SeenEdge& steep = a.cosine < b.cosine ? a : b;
  const SeenEdge& flat = a.cosine < b.cosine ? b : a;
  const auto may_cut = [&](const DoubleDouble& end) {
    return (end - steep.low).high >= -reach && (steep.high - end).high >= -reach;
  };
  const bool may_be_cut = may_cut(flat.low) || may_cut(flat.high);
  if (may_be_cut && std::abs(steep.cosine) < standing) return std::abs(steep.cosine);
  return std::max(steep.cosine, standing);
}

/// The second point that a clip of two edges gives. Each edge moves its far end by up to
/// s (1 + 1 / cos).
Second second_of(const AlongContact& along, const SeenEdge& a, const SeenEdge& b,
                 const Bounds& bounds, SecondPoint policy) {
  const DoubleDouble low = (b.low - a.low).high > 0 ? b.low : a.low;
  const DoubleDouble high = (a.high - b.high).high > 0 ? b.high : a.high;
  const double run = (high - low).high;
  const auto depth_at = [&](const DoubleDouble& place) {
    return along.total_radius() + (a.height_at(place) - b.height_at(place)).high;
  };
  const double lesser = run > 0 ? std::min(depth_at(low), depth_at(high)) : 0;
  const double cosine = std::min(a.cosine, b.cosine);
  const double reach = 2 * (bounds.position + bounds.separation);
  const double off = 2 * bounds.separation * (1 + 1 / steepness(a, b, reach));
  const double band = bounds.normal + bounds.incident_dot;
  const bool may_be_edges = cosine >= policy.least_cosine - band;
  const bool are_edges = cosine >= policy.least_cosine + band || policy.least_cosine <= 0;
  return {.is_allowed = may_be_edges && run >= -2 * off && lesser >= -off,
          .is_required = are_edges && run > 2 * (bounds.position + off) && lesser > off,
          .run = run,
          .off = off,
          .depth = lesser};
}

}  // namespace

std::optional<Mismatch> second_point_mismatch(const exact::Truth& truth,
                                              const Declaration& declaration, const Bounds& bounds,
                                              const Manifold<double>& manifold) {
  const AlongContact along(truth, bounds, manifold.normal);
  bool is_allowed = false;
  bool is_required = true;
  Second shortest{.run = INFINITY};
  for (const SeenEdge& a : along.best_edges(Side::a)) {
    for (const SeenEdge& b : along.best_edges(Side::b)) {
      const Second second = second_of(along, a, b, bounds, declaration.second_point);
      is_allowed = is_allowed || second.is_allowed;
      is_required = is_required && second.is_required;
      if (second.run < shortest.run) shortest = second;
    }
  }
  is_required = is_required && is_allowed;
  if (manifold.count > 1 && !is_allowed) return Mismatch{Kind::count, 0, bounds.separation};
  if (!is_required) return std::nullopt;
  if (manifold.count < 2) {
    if (declaration.one_point_enough) return std::nullopt;
    return Mismatch{Kind::count, shortest.run, bounds.position, shortest.depth};
  }
  const double span = std::abs(
      (along.place(manifold.points[1].position) - along.place(manifold.points[0].position)).high);
  const double lost = shortest.run - span;
  const double bound = 2 * (bounds.position + shortest.off);
  if (lost <= bound) return std::nullopt;
  return Mismatch{Kind::extent, lost, bound};
}

}  // namespace manifuzz
