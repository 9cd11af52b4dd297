#include <catch2/catch.hpp>

#include "own_colliders/detected.hpp"
#include "unit/methods/placed.hpp"

using namespace manifuzz;
using test::shape;

namespace {

PairCase boxes(float sine, float radius_a = 0, float radius_b = 0,
               Rounding rounding = Rounding::mitre) {
  const auto box = [rounding](float radius) {
    return shape<float>({{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}, radius, rounding);
  };
  const float cosine = std::sqrt(1 - sine * sine);
  return {{box(radius_a), {{0, 0}, {1, 0}}},
          {box(radius_b), {{0, 1.99F + radius_a + radius_b}, {cosine, sine}}}};
}

std::vector<KeptPoint> points_of(const KeptAnswer& answer) {
  return std::get<KeptManifold>(answer).points;
}

/// A collider of one point that says it lies there, having no more to say.
Collider saying(PointsAt at, const Vector2<double>& position, double depth, bool is_partial = true,
                Side reference = Side::a) {
  Collider collider = make_gjk64();
  collider.declaration.points = at;
  collider.collide = [=](const PairCase&) -> Answer {
    Manifold<double> manifold{1, reference, {0, 1}, {}};
    manifold.points[0] = {position, depth, {}};
    if (!is_partial) return manifold;
    return PartialManifold{.manifold = manifold};
  };
  return collider;
}

/// What is kept of it in the first frame.
KeptPoint first_point(const PairCase& pair, const Collider& collider) {
  return points_of(cached_over(collider).begin()(pair)).at(0);
}

}  // namespace

TEST_CASE("a box that rocks has both its ends after two frames") {
  for (const SequenceCollider& collider : {make_cached(), make_cached64(), make_cached_bullet()}) {
    CAPTURE(collider.declaration.name);
    const auto ask = collider.begin();
    CHECK(points_of(ask(boxes(0.002F))).size() == 1);
    const auto points = points_of(ask(boxes(-0.002F)));
    REQUIRE(points.size() == 2);
    CHECK(points[0].id == 0);
    CHECK(points[0].born == 0);
    CHECK(points[1].born == 1);
    CHECK(points[0].anchor_a.x() == Approx(-1).epsilon(0.01));
    CHECK(points[1].anchor_a.x() == Approx(1).epsilon(0.01));
    CHECK(points_of(collider.begin()(boxes(0.002F))).size() == 1);
  }
}

TEST_CASE("what is not one point a pair is not kept as points are") {
  const auto unsupported = [](const PairCase&) -> Answer { return Unsupported{"no"}; };
  const auto lost = [](const PairCase&) -> Answer { return Lost{Lost::How::timed_out, "late"}; };
  Collider collider = make_gjk64();
  collider.collide = unsupported;
  CHECK(std::holds_alternative<Unsupported>(cached_over(collider).begin()(boxes(0))));
  collider.collide = lost;
  CHECK(std::holds_alternative<Lost>(cached_over(collider).begin()(boxes(0))));
}

TEST_CASE("wherever a collider puts its point, both anchors are on surfaces") {
  const PairCase pair = boxes(0, 0.25F, 0.5F);
  // A's surface is at y = 1.25, B's at 1.24; cores at 1 and 1.74.
  const double depth = 1.25 - (static_cast<double>(pair.b.pose.position.y()) - 1.5);
  const double on_b = 1.25 - depth;
  const Collider colliders[] = {
      saying(PointsAt::surface_a, {0.5, 1.25}, depth),
      saying(PointsAt::surface_b, {0.5, on_b}, depth),
      saying(PointsAt::midpoint, {0.5, 1.25 - depth / 2}, depth),
      saying(PointsAt::clip, {0.5, on_b + 0.5}, depth),
      saying(PointsAt::clip, {0.5, 1}, depth),
      saying(PointsAt::vertex, {0.5, 1}, depth),
      saying(PointsAt::vertex, {0.5, on_b + 0.5}, depth),
      saying(PointsAt::clip, {0.5, on_b + 0.5}, depth, false, Side::a),
      saying(PointsAt::clip, {0.5, 1}, depth, false, Side::b),
  };
  for (const Collider& collider : colliders) {
    const KeptPoint point = first_point(pair, collider);
    CHECK(point.anchor_a.x() == Approx(0.5));
    CHECK(point.anchor_a.y() == Approx(1.25).epsilon(1e-14));
    CHECK(point.anchor_b.x() == Approx(0.5));
    CHECK(point.anchor_b.y() == Approx(-1.5).epsilon(1e-14));
    CHECK(point.depth == Approx(depth).epsilon(1e-12));
  }
}

TEST_CASE("a clip's point on a round surface is on it already") {
  const PairCase pair = boxes(0, 0.25F, 0.5F, Rounding::round);
  const double depth = 1.25 - (static_cast<double>(pair.b.pose.position.y()) - 1.5);
  const KeptPoint point = first_point(pair, saying(PointsAt::clip, {0, 1.25}, depth));
  CHECK(point.anchor_a.y() == 1.25);
  CHECK(point.anchor_b.y() == Approx(-1.5));
}

TEST_CASE("a normal of which nobody says whose it is travels with the body of the likest face") {
  Collider silent = make_gjk64();
  silent.collide = [ask = silent.collide](const PairCase& pair) -> Answer {
    return PartialManifold{.manifold = std::get<Manifold<double>>(ask(pair))};
  };
  const PairCase pair = boxes(0.3F);
  CHECK(first_point(pair, silent).travels_with == TravelsWith::a);
  CHECK(first_point({pair.b, pair.a}, silent).travels_with == TravelsWith::b);
}

TEST_CASE("rotations that are not quite unit are divided by where points are kept in double") {
  PairCase pair = boxes(0);
  const float k = 1.000004F;
  pair.a.pose.rotation *= k;
  const KeptPoint point = first_point(pair, make_gjk64());
  const Vector2<double> on_a = to_world(pair, point.anchor_a);
  const Vector2<double> on_b = transform(
      Pose<double>{pair.b.pose.position.cast<double>(), pair.b.pose.rotation.cast<double>()},
      point.anchor_b);
  CHECK(point.depth == Approx(point.normal.dot(on_a - on_b)).epsilon(1e-13));
  CHECK(point.depth == Approx(static_cast<double>(k) - 0.99).epsilon(1e-6));
  CHECK(point.normal.norm() == Approx(1).epsilon(1e-15));
}

TEST_CASE("what they declare: the limits that points are kept within") {
  const PairCase pair{{shape<float>({{3, 4}, {5, 4}, {5, 6}}), {{0, 0}, {1, 0}}},
                      {shape<float>({{0, 0}, {20, 0}, {0, 20}}), {{0, 0}, {1, 0}}}};
  const Keeping right = make_cached().keeping;
  CHECK(right.points_max == 3);
  CHECK(right.turn == 0.02);
  CHECK(right.gap.of(pair) == Approx(0.02 * std::hypot(5, 6)));
  const Keeping bullet = make_cached_bullet().keeping;
  CHECK(bullet.points_max == 4);
  CHECK(std::isinf(bullet.turn));
  CHECK(bullet.gap.of(pair) == Approx(0.02 * (std::sqrt(2) + std::hypot(4, 5))));
  CHECK(make_cached().declaration.claims == Claims::point);
}
