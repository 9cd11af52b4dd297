#include <type_traits>

#include "oracle/parry/ledger/engines.hpp"

// scripts/colliders/rust/parry/adapter.rs: what it hands to parry, and what it makes of a manifold.

namespace manifuzz::parry {
namespace {

/// The adapter's shapes of a pair: the case's numbers in parry's scalar.
template <class Real>
Placed<Real> placed_by_parry(const exact::StoredBody& body) {
  // In doubles the stored rotation is unit to 32 bits only: what it lacks goes into the vertices.
  const Vector2<double> stored = body.pose.rotation.cast<double>();
  const double unit = std::is_same_v<Real, double>
                          ? std::sqrt(stored.x() * stored.x() + stored.y() * stored.y())
                          : 1.0;
  Placed<Real> placed;
  const auto turn = [&](double part) { return static_cast<Real>(part) / static_cast<Real>(unit); };
  placed.pose = {body.pose.position.cast<Real>(), {turn(stored.x()), turn(stored.y())}};
  placed.shape.radius = static_cast<Real>(body.polygon.radius);
  std::vector<Vector2<Real>> corners;
  for (int i = 0; i < body.polygon.count; ++i) {
    const Vector2<double>& vertex = body.polygon.vertices[i];
    corners.emplace_back(static_cast<Real>(unit) * static_cast<Real>(vertex.x()),
                         static_cast<Real>(unit) * static_cast<Real>(vertex.y()));
  }
  if (corners.size() == 1) {
    placed.pose.position = transform(placed.pose, corners[0]);
    return placed;
  }
  if (corners.size() > 2) {
    for (std::size_t i = 0; i < corners.size(); ++i) {
      placed.shape.normals.push_back(
          face_normal(corners[i], corners[(i + 1) % corners.size()]).value_or(Vector2<Real>(0, 0)));
    }
  }
  placed.shape.corners = std::move(corners);
  return placed;
}

}  // namespace

template <class Scalar>
Vector2<double> AsAdapters<Scalar>::direction(const Replay<Real>& replay, const PairCase& pair) {
  return local_normal(pair,
                      rotate<Real>(replay.a.pose.rotation, replay.normal).template cast<double>());
}

template <class Scalar>
Manifold<double> AsAdapters<Scalar>::answer(const Replay<Real>& replay, const PairCase& pair) {
  Manifold<double> answer;
  answer.normal = direction(replay, pair);
  for (const TrackedPoint<Real>& point : replay.points) {
    if (point.distance > 0) continue;
    const Vector2<Real> middle =
        (transform(replay.a.pose, point.on_a) + transform(replay.b.pose, point.on_b)) / Real(2);
    auto& to = answer.points[static_cast<std::size_t>(answer.count++)];
    to.position = to_local(pair.a.pose, middle.template cast<double>());
    to.depth = -static_cast<double>(point.distance);
  }
  if (answer.count == 0) answer.normal = {0, 0};
  order_points(answer);
  return answer;
}

template <class Scalar>
const Declaration& AsAdapters<Scalar>::declaration() {
  static const Declaration made =
      declared(std::is_same_v<Real, float> ? ScalarType::float32 : ScalarType::float64,
               static_cast<double>(kEpsilon<Real>));
  return made;
}

template <class Scalar>
std::vector<Replay<Scalar>> AsAdapters<Scalar>::replays(const exact::StoredPair& pair) {
  return {replayed(placed_by_parry<Real>(pair.a), placed_by_parry<Real>(pair.b))};
}

template <class Scalar>
std::vector<Replay<Scalar>> AsAdapters<Scalar>::replays_of_simplified(
    const exact::StoredPair& pair) {
  Placed<Real> a = placed_by_parry<Real>(pair.a);
  Placed<Real> b = placed_by_parry<Real>(pair.b);
  for (Placed<Real>* const placed : {&a, &b}) placed->shape = simplified(placed->shape);
  return {replayed(a, b)};
}

template struct AsAdapters<float>;
template struct AsAdapters<double>;

}  // namespace manifuzz::parry
