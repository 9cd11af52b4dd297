#include "judging/round_contact.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace manifuzz {
namespace {

using exact::DoubleDouble;
using exact::FaceOf;
using exact::FinePoint;

/// A vertex as a face of the other core sees it.
struct VertexBeforeFace {
  FinePoint at;       ///< from where the face begins
  double height = 0;  ///< in front of the face, a world length
};

/// A face and all vertices of the other core.
struct BeforeFace {
  BeforeFace(const exact::StoredPair& pair, FaceOf face)
      : along(unit_of(exact::direction<DoubleDouble>(pair, face))) {
    const FinePoint out{along.y, -along.x};
    const auto from = exact::vertex<DoubleDouble>(pair, face.side, face.index);
    const int next = pair[face.side].polygon.next(face.index);
    end = exact::vertex<DoubleDouble>(pair, face.side, next) - from;
    const Side opposing = other(face.side);
    for (int j = 0; j < pair[opposing].polygon.count; ++j) {
      const FinePoint at = exact::vertex<DoubleDouble>(pair, opposing, j) - from;
      vertices.push_back({at, dot(out, at).high});
    }
  }

  double least_height() const {
    return std::ranges::min(vertices, {}, &VertexBeforeFace::height).height;
  }

  FinePoint along;  ///< the face's direction, unit
  FinePoint end;    ///< from where the face begins
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
  const FinePoint from = exact::vertex<DoubleDouble>(pair, Side::a, of_a);
  const FinePoint to = exact::vertex<DoubleDouble>(pair, Side::b, of_b);
  const FinePoint towards_b = unit_of(to - from);
  const auto is_behind = [&](Side side, int k) {
    const FinePoint at = exact::vertex<DoubleDouble>(pair, side, k);
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

double NearestNormal::off(const Vector2<double>& normal, const FinePoint& right) const {
  const FinePoint by = in_world(truth_->stored(), normal) - right;
  return std::sqrt(dot(by, by).high);
}

bool NearestNormal::is_near(const Vector2<double>& normal) const {
  return off(normal, direction_) <= bound() || error(normal) <= bound();
}

double NearestNormal::error(const Vector2<double>& normal) const {
  double least = off(normal, direction_);
  for (const FinePoint& right : as_near()) least = std::min(least, off(normal, right));
  return least;
}

std::vector<FinePoint> NearestNormal::as_near() const {
  std::vector<FinePoint> directions;
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
      const FinePoint between = exact::vertex<DoubleDouble>(pair, Side::b, j) -
                                exact::vertex<DoubleDouble>(pair, Side::a, i);
      directions.push_back(unit_of(between));
    }
  }
  return directions;
}

std::vector<FinePoint> NearestNormal::directions() const {
  std::vector<FinePoint> all = as_near();
  all.insert(all.begin(), direction_);
  return all;
}

double NearestNormal::bound() const {
  return bound_of_normal_ + bound_of_separation_ / (distance_ - bound_of_separation_);
}

}  // namespace manifuzz
