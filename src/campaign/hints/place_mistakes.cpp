#include "campaign/hints/place_mistakes.hpp"

#include <algorithm>
#include <cmath>

namespace manifuzz {
namespace {

/// The answer's manifold with what it names; none where it has no points.
std::optional<PartialManifold> partial_of(const Answer& answer) {
  const Manifold<double>* const manifold = manifold_in(answer);
  if (manifold == nullptr || manifold->count < 1 || manifold->count > 2) return std::nullopt;
  if (const auto* const partial = std::get_if<PartialManifold>(&answer)) return *partial;
  return PartialManifold{.manifold = *manifold, .names_reference = true, .names_features = true};
}

/// How nearly a direction in A's frame is that of a face's normal out of this side: the cosine.
double likeness(const PairCase& pair, Side side, const Vector2<double>& direction) {
  double most = -1;
  for (int i = 0; i < pair[side].polygon.face_count(); ++i) {
    const Vector2<double> normal = pair[side].polygon.normals[i].cast<double>();
    const Vector2<double> in_world =
        rotate<double>(pair[side].pose.rotation.cast<double>(), normal);
    most = std::max(most, local_normal(pair, in_world).dot(direction));
  }
  return most;
}

/// The one that is named, or whose face has the normal that is given, or of both the best.
Side reference_of(const PartialManifold& partial, const AskedCase& asked) {
  const Vector2<double>& normal = partial.manifold.normal;
  if (partial.names_reference || !asked.truth.has_faces()) return partial.manifold.reference;
  const double of_a = likeness(asked.pair(), Side::a, normal);
  const double of_b = likeness(asked.pair(), Side::b, -normal);
  constexpr double kAlike = 1e-5;
  if (std::abs(of_a - of_b) > kAlike) return of_a > of_b ? Side::a : Side::b;
  return asked.truth.greatest().side;
}

/// A clip's points taken from this body's surface to the incident core.
MaybeUndone moved_to_incident(PartialManifold partial, Side surface, const AskedCase& asked) {
  const PairCase& pair = asked.pair();
  const Side incident = other(reference_of(partial, asked));
  const double outwards = surface == Side::a ? 1 : -1;
  const double unit = pair.a.pose.rotation.cast<double>().norm();
  Manifold<double>& manifold = partial.manifold;
  for (int i = 0; i < manifold.count; ++i) {
    ContactPoint<double>& point = manifold.points[i];
    const auto radius = static_cast<double>(pair[incident].polygon.radius);
    const double inwards = incident == surface ? radius : point.depth - radius;
    point.position -= outwards * inwards / unit * manifold.normal;
  }
  if (std::holds_alternative<PartialManifold>(asked.answer)) {
    return Undone{asked.declaration, partial};
  }
  order_points(manifold);
  return Undone{asked.declaration, manifold};
}

}  // namespace

MaybeUndone from_midpoints(const AskedCase& asked) {
  if (asked.declaration.points == PointsAt::midpoint) return std::nullopt;
  auto partial = partial_of(asked.answer);
  if (!partial) return std::nullopt;
  Undone undone{asked.declaration, asked.answer};
  undone.declaration.points = PointsAt::midpoint;
  if (is_judged_by_curve(asked.declaration, asked.pair())) return undone;
  partial->has_midpoints = true;
  undone.answer = *partial;
  return undone;
}

MaybeUndone from_surface_of(Side side, const AskedCase& asked) {
  const PointsAt points = side == Side::a ? PointsAt::surface_a : PointsAt::surface_b;
  if (asked.declaration.points == points) return std::nullopt;
  auto partial = partial_of(asked.answer);
  if (!partial) return std::nullopt;
  if (!is_judged_by_curve(asked.declaration, asked.pair())) {
    return moved_to_incident(*partial, side, asked);
  }
  Undone undone{asked.declaration, asked.answer};
  undone.declaration.points = points;
  return undone;
}

MaybeUndone from_reference(const AskedCase& asked) {
  const auto partial = partial_of(asked.answer);
  return partial ? from_surface_of(reference_of(*partial, asked), asked) : std::nullopt;
}

}  // namespace manifuzz
