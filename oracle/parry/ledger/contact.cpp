#include "oracle/parry/ledger/ball.hpp"
#include "oracle/parry/ledger/replay.hpp"

// query/contact of parry: contact_ball_ball.rs, contact_ball_convex_polyhedron.rs and
// contact_support_map_support_map.rs.

namespace manifuzz::parry {
namespace {

template <class Real>
void contact_of_balls(Replay<Real>& replay) {
  replay.apart = replay.between.position;
  const Real radii = replay.a.shape.radius + replay.b.shape.radius;
  const Real square = replay.apart.dot(replay.apart);
  if (!(square < radii * radii)) return;
  replay.normal = try_normalize(replay.apart).value_or(Vector2<Real>(1, 0));
  replay.points.push_back({replay.normal * replay.a.shape.radius,
                           normal_of_b(replay) * replay.b.shape.radius, std::sqrt(square) - radii});
}

/// Segment::feature_normal of the side that the centre is on.
template <class Real>
Vector2<Real> normal_of_segment(const Shape<Real>& shape, const Vector2<Real>& centre) {
  const Projection<Real> place = project_on_segment(centre, shape.corners[0], shape.corners[1]);
  const Vector2<Real> along = shape.corners[1] - shape.corners[0];
  const auto direction = try_normalize(along);
  if (!direction) return {0, 1};
  if (place.vertex_count == 1) {
    return place.first == 0 ? *direction : Vector2<Real>(-*direction);
  }
  const bool is_first = cross<Real>(Vector2<Real>(centre - place.point), along) >= 0;
  const Vector2<Real> normal(direction->y(), -direction->x());
  return is_first ? normal : Vector2<Real>(-normal);
}

/// ConvexPolygon::feature_normal of support_feature_id_toward: the first face within a degree, or
/// the farthest corner's.
template <class Real>
std::optional<Vector2<Real>> normal_of_polygon(const Shape<Real>& shape,
                                               const Vector2<Real>& towards) {
  const auto direction = try_normalize(towards);
  if (!direction) return std::nullopt;
  constexpr double degree = 3.14159265358979323846 / 180;
  const auto cosine = static_cast<Real>(std::cos(static_cast<Real>(degree)));
  for (const Vector2<Real>& normal : shape.normals) {
    if (normal.dot(*direction) >= cosine) return normal;
  }
  std::size_t best = 0;
  for (std::size_t i = 1; i < shape.corners.size(); ++i) {
    if (shape.corners[i].dot(*direction) > shape.corners[best].dot(*direction)) best = i;
  }
  const std::size_t before = best == 0 ? shape.normals.size() - 1 : best - 1;
  return try_normalize(Vector2<Real>(shape.normals[before] + shape.normals[best]));
}

/// feature_normal_at_point: none of a shape with a radius.
template <class Real>
std::optional<Vector2<Real>> normal_at(const Replay<Real>& replay, const Shape<Real>& shape,
                                       const Vector2<Real>& centre) {
  if (shape.radius > 0) return std::nullopt;
  if (shape.corners.size() == 2) return normal_of_segment(shape, centre);
  return normal_of_polygon(shape, replay.is_inside ? Vector2<Real>(-replay.apart) : replay.apart);
}

template <class Real>
void contact_of_ball(Replay<Real>& replay) {
  const bool is_flipped = replay.a.shape.is_ball();
  const Shape<Real>& shape = is_flipped ? replay.b.shape : replay.a.shape;
  const Real radius = is_flipped ? replay.a.shape.radius : replay.b.shape.radius;
  const Pose<Real> between = is_flipped ? inverse(replay.between) : replay.between;
  const Vector2<Real>& centre = between.position;
  const ProjectedCentre<Real> nearest = projected(replay, shape, centre);
  replay.apart = centre - nearest.point;
  replay.is_inside = nearest.is_inside;
  replay.is_on_core = nearest.is_on_core;
  const auto [direction, length] = normalize_and_length(Vector2<Real>(nearest.point - centre));
  Real distance = -radius;
  Vector2<Real> normal = direction;
  if (length >= kEpsilon<Real>) {
    distance = nearest.is_inside ? -length - radius : length - radius;
    if (!nearest.is_inside) normal = -normal;
  } else if (const auto of_feature = normal_at(replay, shape, centre)) {
    normal = *of_feature;
  } else {
    normal = try_normalize(nearest.point).value_or(Vector2<Real>(0, 1));
  }
  if (!(distance <= 0)) return;
  const Vector2<Real> of_ball = rotate_back<Real>(between.rotation, Vector2<Real>(-normal));
  const Vector2<Real> on_ball = of_ball * radius;
  replay.normal = is_flipped ? of_ball : normal;
  replay.points.push_back(is_flipped ? TrackedPoint<Real>{on_ball, nearest.point, distance}
                                     : TrackedPoint<Real>{nearest.point, on_ball, distance});
}

}  // namespace

template <class Real>
Replay<Real> replayed_contact(const Placed<Real>& a, const Placed<Real>& b) {
  Replay<Real> replay{
      .route = Route::supports, .a = a, .b = b, .between = composed(inverse(a.pose), b.pose)};
  if (a.shape.is_ball() && b.shape.is_ball()) {
    replay.route = Route::balls;
    contact_of_balls(replay);
  } else if (a.shape.is_ball() || b.shape.is_ball()) {
    replay.route = Route::ball;
    contact_of_ball(replay);
  } else if (const auto places = searched<Real>(replay, true, 0)) {
    const Vector2<Real> apart = (*places)[1] - (*places)[0];
    replay.points.push_back(
        {(*places)[0], inverse_transform(replay.between, (*places)[1]), apart.dot(replay.normal)});
  }
  return replay;
}

template Replay<float> replayed_contact(const Placed<float>&, const Placed<float>&);

}  // namespace manifuzz::parry
