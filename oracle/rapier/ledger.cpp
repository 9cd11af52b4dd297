#include "engines/engine.hpp"
#include "oracle/parry/ledger/rows.hpp"
#include "oracle/rapier/angles.hpp"

// bodies.mjs with manifold.mjs and contact.mjs: what they hand to Rapier, what Rapier hands to the
// parry2d inside it, and what is made of a manifold.

namespace manifuzz::parry {
namespace {

/// rapier2d-compat asked for contact manifolds.
struct Rapier {
  using Real = float;
  /// As of `AsAdapters`.
  static std::vector<Replay<Real>> replays(const exact::StoredPair& pair);
  static std::vector<Replay<Real>> replays_of_simplified(const exact::StoredPair& pair);
  static Vector2<double> direction(const Replay<Real>& replay, const PairCase& pair);
  static Manifold<double> answer(const Replay<Real>& replay, const PairCase& pair);
  static const Declaration& declaration();
};

/// Rapier asked by contactCollider.
struct RapierContact {
  using Real = float;
  /// As of `AsAdapters`.
  static std::vector<Replay<Real>> replays(const exact::StoredPair& pair);
  static Vector2<double> direction(const Replay<Real>& replay, const PairCase& pair);
  static Manifold<double> answer(const Replay<Real>& replay, const PairCase& pair);
  static const Declaration& declaration();
};

/// normalized_prediction_distance of integration_parameters.rs, times a length unit of 1.
constexpr float kPrediction = 0.02F;

double angle_of(const exact::StoredBody& body) {
  return std::atan2(static_cast<double>(body.pose.rotation.y()),
                    static_cast<double>(body.pose.rotation.x()));
}

/// A collider's frame in that of the case's body.
struct FrameByAdapter {
  double turn = 0;
  Vector2<double> origin{0, 0};
};

FrameByAdapter frame_of(const exact::StoredBody& body) {
  const auto& corners = body.polygon.vertices;
  if (body.polygon.count == 1) return {-angle_of(body), corners[0]};
  if (body.polygon.count > 2 || body.polygon.radius == 0) return {};
  const Vector2<double>& p = corners[0];
  const Vector2<double>& q = corners[1];
  return {std::atan2(p.x() - q.x(), q.y() - p.y()), (p + q) / 2};
}

Vector2<double> turned_by(double angle, const Vector2<double>& v) {
  return rotate<double>({std::cos(angle), std::sin(angle)}, v);
}

/// Where a place of a body is in the world, as its numbers have it.
Vector2<double> in_world(const exact::StoredBody& body, const Vector2<double>& v) {
  return rotate<double>(body.pose.rotation.cast<double>(), v) + body.pose.position.cast<double>();
}

Placed<float> placed_by_rapier(const exact::StoredBody& body) {
  const FrameByAdapter frame = frame_of(body);
  const int count = body.polygon.count;
  Placed<float> placed;
  placed.shape.radius = static_cast<float>(body.polygon.radius);
  Vector2<double> position = body.pose.position.cast<double>();
  double angle = angle_of(body);
  const auto& corners = body.polygon.vertices;
  if (count == 1) {
    position = in_world(body, corners[0]);
    angle = 0;
  } else if (count == 2 && body.polygon.radius > 0) {
    position = (in_world(body, corners[0]) + in_world(body, corners[1])) / 2;
    angle = frame.turn + angle;
    const Vector2<double> along = corners[1] - corners[0];
    const auto half = static_cast<float>(std::hypot(along.x(), along.y()) / 2);
    placed.shape.corners = {{-0.0F, -half}, {0.0F, half}};
  } else {
    for (int i = 0; i < count; ++i) {
      placed.shape.corners.push_back(corners[static_cast<std::size_t>(i)].cast<float>());
    }
  }
  const auto rounded = static_cast<double>(static_cast<float>(angle));
  placed.pose = {position.cast<float>(), {cosine_of_wasm(rounded), sine_of_wasm(rounded)}};
  const auto& made = placed.shape.corners;
  for (std::size_t i = 0; made.size() > 2 && i < made.size(); ++i) {
    placed.shape.normals.push_back(
        face_normal(made[i], made[(i + 1) % made.size()]).value_or(Vector2<float>(0, 0)));
  }
  return placed;
}

std::vector<Replay<float>> in_both_orders(const Placed<float>& a, const Placed<float>& b) {
  std::vector<Replay<float>> both{replayed(a, b, kPrediction), replayed(b, a, kPrediction)};
  both[1].is_swapped = true;
  return both;
}

Vector2<double> Rapier::direction(const Replay<float>& replay, const PairCase& pair) {
  const Vector2<float> outward = replay.is_swapped ? normal_of_b(replay) : replay.normal;
  const exact::StoredPair stored = exact::stored(pair);
  const Vector2<double> turned = turned_by(frame_of(stored.a).turn, outward.cast<double>());
  const Vector2<double> rotation = pair.a.pose.rotation.cast<double>();
  return local_normal(pair, rotate<double>(rotation / rotation.norm(), turned));
}

Manifold<double> Rapier::answer(const Replay<float>& replay, const PairCase& pair) {
  const exact::StoredPair stored = exact::stored(pair);
  const FrameByAdapter frame = frame_of(stored.a);
  Manifold<double> answer;
  for (const TrackedPoint<float>& point : replay.points) {
    if (point.distance > 0) continue;
    auto& to = answer.points[static_cast<std::size_t>(answer.count++)];
    const Vector2<float>& local = replay.is_swapped ? point.on_b : point.on_a;
    to.position = turned_by(frame.turn, local.cast<double>()) + frame.origin;
    to.depth = -static_cast<double>(point.distance);
  }
  if (answer.count > 0) answer.normal = direction(replay, pair);
  order_points(answer);
  return answer;
}

const Declaration& Rapier::declaration() {
  static const Declaration made = [] {
    Declaration rapier = declared(ScalarType::float32, static_cast<double>(kEpsilon<float>));
    rapier.takes_angles = true;
    rapier.points = PointsAt::surface_a;
    rapier.one_point_enough = true;
    return rapier;
  }();
  return made;
}

std::vector<Replay<float>> Rapier::replays(const exact::StoredPair& pair) {
  return in_both_orders(placed_by_rapier(pair.a), placed_by_rapier(pair.b));
}

std::vector<Replay<float>> Rapier::replays_of_simplified(const exact::StoredPair& pair) {
  Placed<float> a = placed_by_rapier(pair.a);
  Placed<float> b = placed_by_rapier(pair.b);
  for (Placed<float>* const placed : {&a, &b}) placed->shape = simplified(placed->shape);
  return in_both_orders(a, b);
}

Vector2<double> RapierContact::direction(const Replay<float>& replay, const PairCase& pair) {
  const Vector2<float> in_world = rotate<float>(replay.a.pose.rotation, replay.normal);
  return local_normal(pair, in_world.cast<double>());
}

Manifold<double> RapierContact::answer(const Replay<float>& replay, const PairCase& pair) {
  Manifold<double> answer;
  if (replay.points.empty() || replay.points[0].distance > 0) return answer;
  answer.count = 1;
  answer.normal = direction(replay, pair);
  const Vector2<float> in_world = transform(replay.a.pose, replay.points[0].on_a);
  answer.points[0].position = to_local(pair.a.pose, in_world.cast<double>());
  answer.points[0].depth = -static_cast<double>(replay.points[0].distance);
  return answer;
}

const Declaration& RapierContact::declaration() {
  static const Declaration made = [] {
    Declaration rapier = Rapier::declaration();
    rapier.claims = Claims::point;
    rapier.one_point_enough = false;
    return rapier;
  }();
  return made;
}

std::vector<Replay<float>> RapierContact::replays(const exact::StoredPair& pair) {
  return {replayed_contact(placed_by_rapier(pair.a), placed_by_rapier(pair.b))};
}

constexpr LedgerRow kRowsOfContact[] = {
    {"corner-cones", normal_of_corner_cones<RapierContact>},
    {"lost-by-epa", contact_lost_by_epa<RapierContact>},
    {"step-back", step_back_of_gjk<RapierContact>},
    {"touching-within-tolerance", touching_of_gjk<RapierContact>},
    {"origin-within-tolerance", origin_within_tolerance<RapierContact>},
    {"equal-corners", equal_corners_of_gjk<RapierContact>},
    {"rounded-foot", rounded_foot_of_gjk<RapierContact>},
    {"corner-of-chord", corner_of_epa_chord<RapierContact>},
    {"centre-on-surface", centre_on_surface<RapierContact>},
    {"circle-by-gjk", circle_by_gjk_stop<RapierContact>},
    {"epa-chord", chord_of_epa<RapierContact>},
};

}  // namespace

}  // namespace manifuzz::parry

namespace manifuzz {

Engine engine_rapier() {
  static const auto rows = rows_but_for({"squared-length"}, parry::kRowsOfManifolds<parry::Rapier>);
  return {.name = "rapier",
          .ledger = {{"rapier2d", rows}, {"rapier2d-contact", parry::kRowsOfContact}}};
}

}  // namespace manifuzz
