#pragma once

#include "oracle/parry/ledger/replay.hpp"

namespace manifuzz::parry {

/// PointProjection: the place on a shape's surface that is nearest, as parry finds it.
template <class Real>
struct ProjectedCentre {
  Vector2<Real> point{0, 0};
  bool is_inside = false;
  bool is_on_core = false;  ///< of a capsule: the centre is taken to be on it
};

/// Capsule::project_local_point, not solid.
template <class Real>
ProjectedCentre<Real> on_capsule(const Shape<Real>& shape, const Vector2<Real>& centre) {
  const Vector2<Real>& from = shape.corners[0];
  const Vector2<Real>& to = shape.corners[1];
  const Vector2<Real> on_core = project_on_segment(centre, from, to).point;
  const auto [direction, distance] = normalize_and_length(Vector2<Real>(centre - on_core));
  if (distance >= kEpsilon<Real>) {
    return {on_core + direction * shape.radius, distance <= shape.radius};
  }
  const Vector2<Real> along = to - from;
  const auto [normal, length] = normalize_and_length(Vector2<Real>(along.y(), -along.x()));
  if (length > kEpsilon<Real>) return {on_core + normal * shape.radius, true, true};
  return {on_core + Vector2<Real>(0, shape.radius), true, true};
}

/// local_point_projection_on_support_map, not solid; how its GJK and EPA ended goes to the replay.
template <class Real>
ProjectedCentre<Real> on_support_map(Replay<Real>& replay, const Shape<Real>& shape,
                                     const Vector2<Real>& centre) {
  const Operands<Real> operands{&shape, nullptr, {centre, {1, 0}}, true};
  const auto towards = try_normalize(centre).value_or(Vector2<Real>(1, 0));
  Simplex<Real> simplex(corner_along(operands, towards),
                        replay.is_foot_unrounded ? 0 : kGjkTolerance<Real>);
  replay.gjk =
      Gjk<Real>(operands, std::numeric_limits<Real>::max(), simplex, replay.is_foot_unrounded)
          .run();
  if (!replay.gjk.is_intersection) return {replay.gjk.on_a, false};
  run_epa(replay, operands, simplex);
  if (replay.epa.end == EpaEnd::lost) return {centre, true};
  return {replay.epa.on_a, true};
}

template <class Real>
ProjectedCentre<Real> projected(Replay<Real>& replay, const Shape<Real>& shape,
                                const Vector2<Real>& centre) {
  if (shape.is_capsule()) return on_capsule(shape, centre);
  if (shape.is_polygon()) return on_support_map(replay, shape, centre);
  const Vector2<Real> point = project_on_segment(centre, shape.corners[0], shape.corners[1]).point;
  return {point,
          is_relatively_equal(point.x(), centre.x()) && is_relatively_equal(point.y(), centre.y())};
}

/// The place on the other shape, in its frame, that is nearest to the ball's centre.
template <class Real>
ProjectedCentre<Real> projected_ball(Replay<Real>& replay) {
  const bool is_flipped = replay.a.shape.is_ball();
  const Shape<Real>& shape = is_flipped ? replay.b.shape : replay.a.shape;
  const Pose<Real> between = is_flipped ? inverse(replay.between) : replay.between;
  return projected(replay, shape, between.position);
}

/// contact_manifolds_convex_ball.rs: a ball against any other shape, of which this place is nearest
/// to its centre.
template <class Real>
void collide_ball_at(Replay<Real>& replay, const ProjectedCentre<Real>& nearest) {
  const bool is_flipped = replay.a.shape.is_ball();
  const Real radius = is_flipped ? replay.a.shape.radius : replay.b.shape.radius;
  const Pose<Real> between = is_flipped ? inverse(replay.between) : replay.between;
  replay.apart = between.position - nearest.point;
  replay.is_inside = nearest.is_inside;
  replay.is_on_core = nearest.is_on_core;
  Real distance = length_of(replay.apart);
  Vector2<Real> normal = distance == 0
                             ? try_normalize(between.position).value_or(Vector2<Real>(0, 1))
                             : Vector2<Real>(replay.apart / distance);
  if (nearest.is_inside) {
    normal = -normal;
    distance = -distance;
  }
  if (!(distance <= radius + replay.prediction)) return;
  const Vector2<Real> of_ball = rotate_back<Real>(between.rotation, Vector2<Real>(-normal));
  const Vector2<Real> on_ball = of_ball * radius;
  const Real overlap = distance - radius;
  replay.normal = is_flipped ? of_ball : normal;
  replay.points.push_back(is_flipped ? TrackedPoint<Real>{on_ball, nearest.point, overlap}
                                     : TrackedPoint<Real>{nearest.point, on_ball, overlap});
}

template <class Real>
void collide_ball(Replay<Real>& replay) {
  collide_ball_at(replay, projected_ball(replay));
}

/// The replay of a ball and a segment where the centre is not taken to be inside of it, as it is
/// within epsilon: a segment has no inside.
template <class Real>
Replay<Real> replayed_beside_segment(Replay<Real> replay) {
  ProjectedCentre<Real> nearest = projected_ball(replay);
  nearest.is_inside = false;
  replay.points.clear();
  collide_ball_at(replay, nearest);
  return replay;
}

}  // namespace manifuzz::parry
