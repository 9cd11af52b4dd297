#include <cmath>

#include <catch2/catch.hpp>

#include "judging/faults/shared_faults.hpp"
#include "oracle/bullet/ledger/epa.hpp"
#include "oracle/bullet/ledger/repeated_query.hpp"
#include "oracle/repeated_pairs.hpp"

// Bullet's queries as the ledger repeats them, of pairs by hand. That they answer as the engine
// does, the witnesses show.

using namespace manifuzz;
using namespace manifuzz::ledger_of;
using namespace manifuzz::test;

TEST_CASE("the repeated EPA finds the depth of two squares, from B to A") {
  EpaTrace trace;
  const BulletAnswer answer =
      ask_detector(prisms_of(squares_side_by_side()), solve_by_epa, &trace, 1e18F);
  CHECK(answer.normal_of == NormalOf::solver);
  CHECK(trace.end == BulletEpaEnd::accuracy_reached);
  CHECK(answer.normal.x() == Approx(-1));
  CHECK(answer.distance == Approx(-0.3));
  CHECK(answer.on_b.x() == Approx(0.7));
}

TEST_CASE("the repeated directions find the one along which two squares overlap least") {
  MinkowskiTrace trace;
  const BulletAnswer answer =
      ask_detector(prisms_of(squares_side_by_side()), solve_by_directions, &trace, 1e18F);
  CHECK(answer.normal_of == NormalOf::solver);
  CHECK(trace.overlap == Approx(0.748829));
  CHECK(answer.normal.x() == Approx(-0.951058));
}

TEST_CASE("the repeated query finds squares apart") {
  const PairCase pair{square_of_two(0, 0), square_of_two(3, 0.5F)};
  EpaTrace trace;
  const BulletAnswer answer = ask_detector(prisms_of(pair), solve_by_epa, &trace, 1e18F);
  CHECK(answer.normal_of == NormalOf::query);
  CHECK_FALSE(answer.is_solver_asked);
  CHECK(answer.distance == Approx(1));
}

TEST_CASE("EPA ends at an invalid hull of concentric circles, and its answer alone is explained") {
  const PairCase pair{circle_of_half(0, 0), circle_of_half(0, 0)};
  EpaTrace trace;
  const BulletAnswer answer = ask_detector(prisms_of(pair), solve_by_epa, &trace, 1e18F);
  REQUIRE(trace.end == BulletEpaEnd::invalid_hull);
  const Vector2<double> normal(-answer.normal.x(), -answer.normal.y());
  const double depth = -answer.distance * normal.norm();
  const auto is_it = [&](const Vector2<double>& along, double deep) {
    return is_explained("bullet-epa-invalid-hull", pair, along, deep);
  };
  CHECK(is_it(normal, depth));
  CHECK_FALSE(is_it(-normal, depth));
  CHECK_FALSE(is_it(normal, depth - 1e-4));
  CHECK_FALSE(is_explained("bullet-epa-fall-back", pair, normal, depth));
}

TEST_CASE("the axis of circles whose centres are within 0.001 is kept") {
  const PairCase pair{circle_of_half(0, 0), circle_of_half(0, 5e-4F)};
  const auto is_it = [&](const Vector2<double>& normal, double depth) {
    return is_explained("bullet-minkowski-touching-axis", pair, normal, depth);
  };
  CHECK(is_it({0, 1}, 1 - 5e-4));
  CHECK_FALSE(is_it({0, 1}, 1 - 6e-4));
  CHECK_FALSE(is_it({1, 0}, 1 - 5e-4));
  CHECK_FALSE(is_explained("bullet-minkowski-near-corner", pair, {0, 1}, 1 - 5e-4));
}

TEST_CASE("the repeated query of triangles 32768 wide ends at a corner nearer than its point") {
  const Body wide = triangle_of({Vector2<float>{0, 0}, {0, 32768}, {-32768, 0}});
  EpaTrace trace;
  const BulletAnswer answer = ask_detector(prisms_of({wide, wide}), solve_by_epa, &trace, 1e18F);
  CHECK(answer.loop.end == QueryEnd::equal_vertex);
  CHECK(answer.loop.is_closest_rounded);
  CHECK(answer.distance > 0);
  const BulletAnswer small =
      ask_detector(prisms_of(squares_side_by_side()), solve_by_epa, &trace, 1e18F);
  CHECK_FALSE(small.loop.is_closest_rounded);
}

TEST_CASE("EPA's second GJK gives no direction of a circle about the end of a long segment") {
  const PairCase pair{body_at(std::array{Vector2<float>{0, 0}}, 0, 0, 200),
                      body_at(std::array{Vector2<float>{0, 0}, Vector2<float>{0, 10000}}, 0, 0)};
  EpaTrace trace;
  const BulletAnswer answer = ask_detector(prisms_of(pair), solve_by_epa, &trace, 1e18F);
  CHECK(answer.is_solver_asked);
  CHECK(answer.normal_of == NormalOf::nobody);
  const auto is_it = [](const PairCase& of) {
    return explains("bullet-epa-without-axis", of, {}, Kind::missed_contact);
  };
  CHECK(is_it(pair));
  CHECK_FALSE(is_explained("bullet-epa-without-axis", pair, {1, 0}, 200));
  CHECK_FALSE(is_it(squares_side_by_side()));
  CHECK_FALSE(is_it({square_of_two(0, 0), square_of_two(3, 0.5F)}));
}

TEST_CASE("a normal between rounded places is explained where that of EPA's face is right") {
  // They overlap by 0.001 at 100, where floats are 7.6e-6 apart.
  const PairCase far{square_of_two(100, 100), square_of_two(101.999F, 100.5F)};
  EpaTrace trace;
  const BulletAnswer answer = ask_detector(prisms_of(far), solve_by_epa, &trace, 1e18F);
  REQUIRE(trace.end == BulletEpaEnd::accuracy_reached);
  const Vector2<double> normal(-answer.normal.x(), -answer.normal.y());
  const auto is_it = [](const PairCase& pair, const Vector2<double>& along, double depth) {
    return is_explained("bullet-epa-between-places", pair, along, depth, Kind::witness);
  };
  CHECK(is_it(far, normal, -answer.distance));
  CHECK_FALSE(is_it(far, {1, 0.01}, -answer.distance));
  CHECK_FALSE(is_it(far, normal, 0.01 - answer.distance));
  // Where circles are concentric, EPA's own face is wrong.
  const PairCase circles{circle_of_half(0, 0), circle_of_half(0, 0)};
  const BulletAnswer of_circles = ask_detector(prisms_of(circles), solve_by_epa, &trace, 1e18F);
  CHECK_FALSE(
      is_it(circles, {-of_circles.normal.x(), -of_circles.normal.y()},
            -of_circles.distance * std::hypot(of_circles.normal.x(), of_circles.normal.y())));
}

TEST_CASE("a corner before the first is that of flat hulls whose squares overflow") {
  const PairCase huge{triangle_of({Vector2<float>{0, 0}, {4e14F, 0}, {0, 2e13F}}),
                      triangle_of({Vector2<float>{0, 4e-34F}, {2e13F, 2e19F}, {-1e-17F, 0}})};
  CHECK(is_intersection_of_memory(flat_hulls_of(huge)));
  CHECK_FALSE(is_intersection_of_memory(prisms_of(huge)));
  CHECK_FALSE(is_intersection_of_memory(flat_hulls_of(squares_side_by_side())));
  MinkowskiTrace trace;
  const BulletPair hulls = flat_hulls_of(huge);
  const BulletAnswer answer =
      ask_detector_told(true, hulls, solve_by_directions, &trace, farthest_square_of(hulls));
  REQUIRE(answer.normal_of == NormalOf::solver);
  const Vector2<double> normal(-answer.normal.x(), -answer.normal.y());
  const auto is_it = [&](const Vector2<double>& along, double depth) {
    return is_explained("bullet-convex2d-corner-before-first", huge, along, depth, Kind::witness);
  };
  CHECK(is_it(normal, -answer.distance));
  CHECK_FALSE(is_it({normal.x() + 0.01, normal.y()}, -answer.distance));
  CHECK_FALSE(is_it(normal, 1e15));
  CHECK_FALSE(
      is_explained("bullet-convex2d-corner-before-first", squares_side_by_side(), {1, 0}, 0.3));
}

TEST_CASE("a query that ends as no corner is nearer is off by the root of its relative error") {
  // 150 apart, squares do not show which end of a segment of 0.03 is nearer.
  const PairCase pair{
      body_at(std::array{Vector2<float>{-0.045F, 0.081F}, Vector2<float>{-0.07F, 0.071F}}, 0, 0,
              100),
      body_at(std::array{Vector2<float>{-56, 140}}, 0, 0, 60)};
  EpaTrace trace;
  const BulletAnswer answer = ask_detector(prisms_of(pair), solve_by_epa, &trace, 1e18F);
  REQUIRE(answer.loop.end == QueryEnd::no_closer);
  const Vector2<double> normal(-answer.normal.x(), -answer.normal.y());
  const auto is_it = [&](const Vector2<double>& along, Kind kind) {
    return is_explained("bullet-epa-relative-error", pair, along, -answer.distance, kind);
  };
  CHECK(is_it(normal, Kind::normal));
  CHECK_FALSE(is_it(normal, Kind::not_minimal));
  CHECK_FALSE(is_it({normal.x() + 1e-5, normal.y()}, Kind::normal));
}

TEST_CASE("a query that ends at the corner that rounded products chose is off by as much") {
  // The segment's other end is nearer by less than a float tells of the squared distance.
  const std::array<Vector2<float>, 2> ends{Vector2<float>{0.1516F, 0.2791F},
                                           Vector2<float>{0.15159647F, 0.27909133F}};
  const PairCase pair{body_at(ends, 0, 0, 0.0478695F),
                      body_at(std::array{Vector2<float>{0.09638F, 0.3016F}}, 0, 0, 0.0478695F)};
  EpaTrace trace;
  const BulletAnswer answer = ask_detector(prisms_of(pair), solve_by_epa, &trace, 1e18F);
  REQUIRE(answer.loop.end == QueryEnd::equal_vertex);
  CHECK(is_nearest_corner_rounded(pair, BulletAsked::epa, answer.loop));
  const Vector2<double> normal(-answer.normal.x(), -answer.normal.y());
  const auto is_it = [&](const Vector2<double>& along, double depth, Kind kind) {
    return is_explained("bullet-epa-relative-error", pair, along, depth, kind);
  };
  CHECK(is_it(normal, -answer.distance, Kind::normal));
  CHECK_FALSE(is_it(normal, -answer.distance, Kind::not_minimal));
  CHECK_FALSE(is_it(normal, -answer.distance - 1e-4, Kind::normal));
  CHECK_FALSE(is_it({normal.x() + 1e-5, normal.y()}, -answer.distance, Kind::normal));
  // The end that is held is the nearest of a segment that does not lie across the axis.
  PairCase turned = pair;
  turned.a.polygon.vertices[1] = {0.1517F, 0.279F};
  const BulletAnswer of_turned = ask_detector(prisms_of(turned), solve_by_epa, &trace, 1e18F);
  CHECK_FALSE(is_nearest_corner_rounded(turned, BulletAsked::epa, of_turned.loop));
}

TEST_CASE("EPA ends within its accuracy of small round corners, whichever way its face is turned") {
  PairCase pair{body_at(std::array{Vector2<float>{0.0030202842F, -0.0073099104F},
                                   Vector2<float>{-0.0176677F, -0.013545966F}},
                        0.08747759F, -0.113125F, 0.000478381F),
                triangle_of({Vector2<float>{0.0041636336F, -0.004145921F},
                             {0.006042488F, 0.008866736F},
                             {0, -0.009375F}})};
  pair.a.pose.rotation = {0.95744765F, -0.28860697F};
  pair.b.polygon.radius = 0.000478381F;
  pair.b.polygon.rounding = Rounding::round;
  pair.b.pose = {{0.09176803F, -0.11602688F}, {0.14290474F, -0.98973644F}};
  EpaTrace trace;
  const BulletAnswer answer = ask_detector(prisms_of(pair), solve_by_epa, &trace, 1e18F);
  REQUIRE(trace.end == BulletEpaEnd::accuracy_reached);
  const Vector2<double> in_world(-answer.normal.x(), -answer.normal.y());
  const Vector2<double> turn = pair.a.pose.rotation.cast<double>();
  const Vector2<double> normal = rotate<double>({turn.x(), -turn.y()}, in_world);
  const double depth = -answer.distance * in_world.norm();
  const auto is_it = [&](const Vector2<double>& along, double deep, Kind kind) {
    return is_explained("bullet-epa-chord", pair, along, deep, kind);
  };
  CHECK(is_it(normal, depth, Kind::normal));
  CHECK_FALSE(is_it(normal, depth, Kind::inconsistent));
  CHECK_FALSE(is_it(-normal, depth, Kind::normal));
  CHECK_FALSE(is_it(rotate<double>({0.9999, 0.01}, normal), depth, Kind::normal));
  CHECK_FALSE(is_it(normal, depth + 1e-5, Kind::normal));
}

TEST_CASE("a point far off is left out since a rotation that is not unit moves it in A's frame") {
  const std::array<Vector2<float>, 2> ends{Vector2<float>{0, 0}, Vector2<float>{0, 40000}};
  const auto is_it = [&](float cos, float far, const Manifold<double>& got) {
    const std::array<Vector2<float>, 1> centre{Vector2<float>{far, 0}};
    PairCase pair{body_at(ends, 0, 0), body_at(centre, 0, 0, 5e9F)};
    pair.a.pose.rotation.x() = cos;
    return explains("bullet-convex2d-refreshed", pair, got, Kind::missed_contact);
  };
  CHECK(is_it(1.0000005F, 4e9F, {}));
  CHECK_FALSE(is_it(1, 4e9F, {}));
  CHECK_FALSE(is_it(1.0000005F, 4e9F, one_point({1, 0}, {0, 0}, 1e9)));
  // Nearer by so much that the place moves by less than the threshold.
  CHECK_FALSE(is_it(1.0000005F, 4e7F, {}));
}
