#include "judging/round_contact.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace manifuzz {
namespace {

using exact::DoubleDouble;
using exact::FaceOf;
using Place = exact::Point<DoubleDouble>;

// In pairs of doubles: nothing here is compared more finely than with a bound.

Place unit_of(const Place& v) {
  const DoubleDouble length = sqrt(dot(v, v));
  return {v.x / length, v.y / length};
}

DoubleDouble cross(const Place& p, const Place& q) {
  return p.x * q.y - p.y * q.x;
}

/// A normal of A's frame in the world, unit.
Place in_world(const exact::StoredPair& pair, const Vector2<double>& normal) {
  return unit_of(turned(pair.a, exact::widen<DoubleDouble>(normal)));
}

/// A vertex as a face of the other core sees it.
struct VertexBeforeFace {
  Place at;           ///< from where the face begins
  double height = 0;  ///< in front of the face, a world length
};

/// A face and all vertices of the other core.
struct BeforeFace {
  BeforeFace(const exact::StoredPair& pair, FaceOf face)
      : along(unit_of(exact::direction<DoubleDouble>(pair, face))) {
    const Place out{along.y, -along.x};
    const auto from = exact::vertex<DoubleDouble>(pair, face.side, face.index);
    const int next = pair[face.side].polygon.next(face.index);
    end = exact::vertex<DoubleDouble>(pair, face.side, next) - from;
    const Side opposing = other(face.side);
    for (int j = 0; j < pair[opposing].polygon.count; ++j) {
      const Place at = exact::vertex<DoubleDouble>(pair, opposing, j) - from;
      vertices.push_back({at, dot(out, at).high});
    }
  }

  double least_height() const {
    return std::ranges::min(vertices, {}, &VertexBeforeFace::height).height;
  }

  Place along;  ///< the face's direction, unit
  Place end;    ///< from where the face begins
  std::vector<VertexBeforeFace> vertices;
};

/// Whether vertices are in front of the inside of a face, the nearest of all to it within `bound`,
/// and farther than `margin` from its ends: world lengths.
bool is_in_front_of_inside(const BeforeFace& seen, double bound, double margin) {
  const double least = seen.least_height();
  double first = INFINITY;
  double last = -INFINITY;
  for (const auto& [at, height] : seen.vertices) {
    if (height > least + bound) continue;
    first = std::min(first, dot(seen.along, at).high);
    last = std::max(last, dot(seen.along, at).high);
  }
  return std::max(first, margin) <= std::min(last, dot(seen.along, seen.end).high - margin);
}

/// Whether a face separates by `least` or more, a world length, and has a vertex in front of it
/// that rounding, off by `separation`, cannot tell from its nearest: where the cores are as near as
/// that.
bool is_as_near(const BeforeFace& seen, double least, double separation) {
  return seen.least_height() >= least && is_in_front_of_inside(seen, 2 * separation, -separation);
}

/// Whether two vertices would be the nearest of all if each vertex moved by up to `separation`, a
/// world length: each is, within twice that, the farthest of its core towards the other.
bool are_as_near(const exact::StoredPair& pair, int of_a, int of_b, double separation) {
  const Place from = exact::vertex<DoubleDouble>(pair, Side::a, of_a);
  const Place to = exact::vertex<DoubleDouble>(pair, Side::b, of_b);
  const Place towards_b = unit_of(to - from);
  const auto is_behind = [&](Side side, int k) {
    const Place at = exact::vertex<DoubleDouble>(pair, side, k);
    const DoubleDouble ahead =
        side == Side::a ? dot(towards_b, at - from) : dot(towards_b, to - at);
    return ahead.high <= 2 * separation;
  };
  for (const Side side : {Side::a, Side::b}) {
    for (int k = 0; k < pair[side].polygon.count; ++k) {
      if (!is_behind(side, k)) return false;
    }
  }
  return true;
}

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

  DoubleDouble place(const Place& p) const { return cross(normal_, p); }
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
  Place normal_;
};

/// What the clip of two edges keeps besides the deepest point.
struct Second {
  bool is_allowed = false;   ///< a right collider may give it
  bool is_required = false;  ///< it must
  double run = 0;            ///< between both points, along the tangent, a world length
  double off = 0;            ///< how far a far end may be off, a world length
  double depth = 0;          ///< of the end that is less deep, a world length
};

/// The angle's term is that of clips: the far end may move by s / cos along its edge, and anywhere
/// along one that does not face the other.
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
  const double off = cosine > 0 ? 2 * bounds.separation * (1 + 1 / cosine) : INFINITY;
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

NearestNormal::NearestNormal(const exact::Truth& truth, const exact::PenetrationCurve& curve,
                             double separation, double normal)
    : truth_(&truth),
      bound_of_separation_(separation),
      bound_of_normal_(normal),
      is_apart_(curve.are_cores_apart()) {
  if (!is_apart_) return;
  const exact::StoredPair& pair = truth.stored();
  distance_ = total_radius(truth.pair()) - curve.least();
  if (const auto vertices = curve.nearest_vertices()) {
    const auto between = exact::vertex<DoubleDouble>(pair, Side::b, (*vertices)[1]) -
                         exact::vertex<DoubleDouble>(pair, Side::a, (*vertices)[0]);
    if (distance_ > bound_of_separation_) direction_ = unit_of(between);
    return;
  }
  direction_ = unit_of(exact::outward_from_a<DoubleDouble>(pair, curve.face()));
  is_inside_face_ =
      is_in_front_of_inside({pair, curve.face()}, bound_of_separation_, bound_of_separation_);
}

double NearestNormal::off(const Vector2<double>& normal, const Place& right) const {
  const Place by = in_world(truth_->stored(), normal) - right;
  return std::sqrt(dot(by, by).high);
}

bool NearestNormal::is_near(const Vector2<double>& normal) const {
  return off(normal, direction_) <= bound() || error(normal) <= bound();
}

double NearestNormal::error(const Vector2<double>& normal) const {
  double least = off(normal, direction_);
  for (const Place& right : as_near()) least = std::min(least, off(normal, right));
  return least;
}

std::vector<Place> NearestNormal::as_near() const {
  std::vector<Place> directions;
  if (distance_ <= 2 * bound_of_separation_) return directions;
  const exact::StoredPair& pair = truth_->stored();
  for (const FaceOf face : exact::all_faces(pair)) {
    if (is_as_near({pair, face}, distance_ - 2 * bound_of_separation_, bound_of_separation_)) {
      directions.push_back(unit_of(exact::outward_from_a<DoubleDouble>(pair, face)));
    }
  }
  for (int i = 0; i < pair.a.polygon.count; ++i) {
    for (int j = 0; j < pair.b.polygon.count; ++j) {
      if (!are_as_near(pair, i, j, bound_of_separation_)) continue;
      const Place between = exact::vertex<DoubleDouble>(pair, Side::b, j) -
                            exact::vertex<DoubleDouble>(pair, Side::a, i);
      directions.push_back(unit_of(between));
    }
  }
  return directions;
}

std::vector<Place> NearestNormal::directions() const {
  std::vector<Place> all = as_near();
  all.insert(all.begin(), direction_);
  return all;
}

double NearestNormal::bound() const {
  return bound_of_normal_ + bound_of_separation_ / (distance_ - bound_of_separation_);
}

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
