#include <cmath>

#include <catch2/catch.hpp>

#include "judging/by_curve.hpp"
#include "judging/judge.hpp"
#include "judging/ledger/bullet/bullet_epa.hpp"
#include "judging/ledger/bullet/bullet_perturbed.hpp"
#include "judging/ledger/bullet/perturbed_deviations.hpp"
#include "judging/ledger/bullet/query_deviations.hpp"
#include "judging/ledger/gjk_deviations.hpp"
#include "judging/ledger/libccd/ccd_deviations.hpp"
#include "judging/ledger/libccd/ccd_polytope.hpp"
#include "judging/ledger/libccd/ccd_portal.hpp"
#include "judging/ledger/libccd/libccd_ray.hpp"
#include "own_colliders/own_colliders.hpp"

// Bullet's and libccd's queries as the ledger repeats them, of pairs by hand. That they answer as
// the engines do, the witnesses show.

using namespace manifuzz;
using namespace manifuzz::ledger_of;

namespace {

Body body_at(std::span<const Vector2<float>> corners, float x, float y, float radius = 0) {
  Body body;
  body.polygon = make_polygon<float>(corners);
  body.polygon.radius = radius;
  if (corners.size() < 3) body.polygon.rounding = Rounding::round;
  body.pose.position = {x, y};
  return body;
}

Body square_of_two(float x, float y) {
  const std::array<Vector2<float>, 4> corners{Vector2<float>{-1, -1}, Vector2<float>{1, -1},
                                              Vector2<float>{1, 1}, Vector2<float>{-1, 1}};
  return body_at(corners, x, y);
}

Body circle_of_half(float x, float y) {
  const std::array<Vector2<float>, 1> middle{Vector2<float>{0, 0}};
  return body_at(middle, x, y, 0.5F);
}

/// Two squares that overlap by 0.3 along x, and by 1.5 along y.
PairCase squares_side_by_side() {
  return {square_of_two(0, 0), square_of_two(1.7F, 0.5F)};
}

Body triangle_of(const std::array<Vector2<float>, 3>& corners) {
  return body_at(corners, 0, 0);
}

/// A corner of one is on a corner of the other, and that is all.
PairCase triangles_corner_on_corner() {
  return {triangle_of({Vector2<float>{0, 0}, {0, 1}, {-1, 0}}),
          triangle_of({Vector2<float>{0, 0}, {0, -1}, {1, 0}})};
}

/// What a predicate says of a manifold.
bool explains(bool (*predicate)(const Deviation&), const PairCase& pair,
              const Manifold<double>& manifold, Kind kind,
              ScalarType scalar = ScalarType::float32) {
  Declaration declaration;
  declaration.scalar = scalar;
  declaration.frame = RoundingFrame::world;
  declaration.min_vertices = 1;
  declaration.takes_round = true;
  const Admissible right = admissible(pair, declaration);
  return predicate({right, manifold, kind});
}

/// The same of one point.
bool is_explained(bool (*predicate)(const Deviation&), const PairCase& pair,
                  const Vector2<double>& normal, double depth, Kind kind = Kind::inconsistent,
                  ScalarType scalar = ScalarType::float32) {
  Manifold<double> manifold;
  manifold.count = 1;
  manifold.normal = normal.normalized();
  manifold.points[0].depth = depth;
  return explains(predicate, pair, manifold, kind, scalar);
}

}  // namespace

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
    return is_explained(epa_at_invalid_hull, pair, along, deep);
  };
  CHECK(is_it(normal, depth));
  CHECK_FALSE(is_it(-normal, depth));
  CHECK_FALSE(is_it(normal, depth - 1e-4));
  CHECK_FALSE(is_explained(epa_falls_back, pair, normal, depth));
}

TEST_CASE("the axis of circles whose centres are within 0.001 is kept") {
  const PairCase pair{circle_of_half(0, 0), circle_of_half(0, 5e-4F)};
  const auto is_it = [&](const Vector2<double>& normal, double depth) {
    return is_explained(axis_of_touching_cores<BulletAsked::directions>, pair, normal, depth);
  };
  CHECK(is_it({0, 1}, 1 - 5e-4));
  CHECK_FALSE(is_it({0, 1}, 1 - 6e-4));
  CHECK_FALSE(is_it({1, 0}, 1 - 5e-4));
  CHECK_FALSE(
      is_explained(stopped_at_near_corner<BulletAsked::directions>, pair, {0, 1}, 1 - 5e-4));
}

TEST_CASE("the repeated polytope ends at the nearest face of two squares") {
  const CcdAnswer answer = ccd_penetration(squares_side_by_side());
  CHECK(answer.end == CcdEnd::along);
  CHECK(answer.nearest.place.x() == Approx(0.3));
  CHECK_FALSE(is_explained(polytope_left_by_squares, squares_side_by_side(), {1, 0}, 0.3,
                           Kind::inconsistent, ScalarType::float64));
  CHECK(ccd_penetration({square_of_two(0, 0), square_of_two(3, 0.5F)}).end == CcdEnd::none);
}

TEST_CASE("the corner of the ray is the one beyond the middle, where the origin is on the way") {
  // The origin is on the diagonal of the difference, whose corner is (1.5, 1.5) away.
  const PairCase diagonal{square_of_two(0, 0), square_of_two(0.5F, 0.5F)};
  const auto is_it = [](const PairCase& pair, const Vector2<double>& normal, double depth) {
    return is_explained(translation_to_corner_of_ray, pair, normal, depth, Kind::not_minimal,
                        ScalarType::float64);
  };
  CHECK(is_it(diagonal, {1, 1}, std::hypot(1.5, 1.5)));
  CHECK_FALSE(is_it(diagonal, {1, 1}, 1.5));
  CHECK_FALSE(is_it(diagonal, {1, 0}, 1.5));
  CHECK_FALSE(is_it(squares_side_by_side(), {0.3, 1.5}, std::hypot(0.3, 1.5)));
}

TEST_CASE("the repeated portal is that of the face by which the ray leaves") {
  const CcdPortalAnswer answer = ccd_portal_penetration(squares_side_by_side());
  CHECK(answer.end == CcdPortalEnd::tolerance);
  CHECK(answer.translation.x() == Approx(0.3));
  CHECK_FALSE(answer.is_on_edge);
  CHECK(ccd_portal_penetration({square_of_two(0, 0), square_of_two(3, 0.5F)}).end ==
        CcdPortalEnd::none);
}

TEST_CASE("the translation is to the portal that the ray from the centres leaves through") {
  // Long ones, side by side: the ray leaves through the far end.
  const std::array<Vector2<float>, 4> corners{Vector2<float>{-4, -1}, Vector2<float>{4, -1},
                                              Vector2<float>{4, 1}, Vector2<float>{-4, 1}};
  const PairCase pair{body_at(corners, 0, 0), body_at(corners, 5, 0.5F)};
  const auto is_it = [&](const Vector2<double>& normal, double depth) {
    return is_explained(translation_to_portal, pair, normal, depth, Kind::not_minimal,
                        ScalarType::float64);
  };
  CHECK(is_it({1, 0}, 3));
  CHECK_FALSE(is_it({3, 0.5}, std::hypot(3, 0.5)));
  CHECK_FALSE(is_it({1, 0}, 2.5));
  CHECK_FALSE(is_it({0, -1}, 2.5));
  CHECK_FALSE(explains(translation_to_portal, pair, {}, Kind::missed_contact));
}

TEST_CASE("what is right of a translation is explained where the repeated engine answers it") {
  // Corner on corner, where any direction is right of a depth of 0.
  const PairCase pair = triangles_corner_on_corner();
  const auto is_it = [&](bool (*predicate)(const Deviation&), const Vector2<double>& normal) {
    return is_explained(predicate, pair, normal, 1e-9, Kind::not_minimal, ScalarType::float64);
  };
  CHECK(is_it(zero_of_squares, {1, -1}));
  CHECK_FALSE(is_it(by_ccd<zero_of_squares>, {1, -1}));
  // Bullet's, of squares 6e-5 apart: below GJK_MIN_DISTANCE, and its own answer alone.
  const PairCase touch{square_of_two(0, 0), square_of_two(2.00006F, 0.5F)};
  EpaTrace trace;
  const BulletAnswer answer = ask_detector(prisms_of(touch), solve_by_epa, &trace, 1e18F);
  const Vector2<double> normal(-answer.normal.x(), -answer.normal.y());
  REQUIRE(trace.is_near);
  CHECK(is_explained(below_gjk_distance, touch, {0, 1}, 5e-5));
  CHECK_FALSE(is_explained(epa_below_least_distance, touch, {0, 1}, 5e-5));
  CHECK(is_explained(epa_below_least_distance, touch, normal, -answer.distance));
}

TEST_CASE("eight triangles about two corners of a difference are folded beside the origin") {
  const PairCase pair{triangle_of({Vector2<float>{0, 0}, {-1, 0}, {0, -1}}),
                      triangle_of({Vector2<float>{0, 0}, {1, -1}, {1, 0}})};
  const CcdAnswer answer = ccd_penetration(pair);
  REQUIRE(answer.first.size() == 4);
  const Vector2<double> translation(answer.nearest.place.x(), answer.nearest.place.y());
  const auto is_it = [&](double depth) {
    return is_explained(polytope_folded, pair, translation, depth, Kind::not_minimal,
                        ScalarType::float64);
  };
  CHECK(is_it(translation.norm()));
  CHECK_FALSE(is_it(translation.norm() + 1e-6));
  CHECK(ccd_penetration(squares_side_by_side()).first.size() < 4);
}

TEST_CASE("triangles 1e14 wide are expanded in a cycle, others to an end") {
  const PairCase pair{triangle_of({Vector2<float>{0, 0}, {-1e14F, 1e8F}, {0, -1}}),
                      triangle_of({Vector2<float>{0, 0}, {0, 2e8F}, {-1e8F, 0}})};
  const Answer none = Lost{Lost::How::timed_out};
  CHECK(polytope_expanded_for_ever({pair, none, Lost::How::timed_out}));
  CHECK_FALSE(polytope_expanded_for_ever({pair, none, Lost::How::crashed}));
  CHECK_FALSE(polytope_expanded_for_ever({squares_side_by_side(), none, Lost::How::timed_out}));
}

TEST_CASE("a direction of no length is known where the ledger repeats it, and malformed else") {
  Declaration libccd;
  libccd.name = "libccd-gjk";
  libccd.claims = Claims::separation;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Answer nonsense = Penetration{.touches = true, .normal = {{nan, nan}}, .depth = nan};
  const auto judged = [&](const PairCase& pair, const Answer& subject, const Answer& oracle) {
    return judge(pair, {make_clip64().declaration, subject}, {libccd, oracle});
  };
  const PairCase pair = triangles_corner_on_corner();
  const Answer right = make_clip64().collide(pair);
  const Judgement known = judged(pair, right, nonsense);
  CHECK(to_string(known.bucket) == "oracle/known/none/none/a");
  REQUIRE(known.explanation != nullptr);
  CHECK(known.explanation->id == "libccd-gjk-no-direction");
  CHECK(is_of_lost(known.bucket));

  const Answer late = Lost{Lost::How::timed_out};
  CHECK(judged(pair, right, late).bucket.verdict == Verdict::timed_out);
  const PairCase deep = squares_side_by_side();
  CHECK(judged(deep, make_clip64().collide(deep), nonsense).bucket.verdict == Verdict::malformed);
  Manifold<double> wrong = std::get<Manifold<double>>(right);
  wrong.count = 1;
  wrong.points[0].depth = 1;
  CHECK(judged(pair, wrong, nonsense).bucket.verdict == Verdict::malformed);
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

TEST_CASE("the repeated turns find points of two squares beside the first, along turned normals") {
  const BulletPair pair = prisms_of(squares_side_by_side());
  const PerturbedAnswer alone = ask_perturbed(pair, {.has_turned = false});
  REQUIRE(alone.points.size() == 1);
  CHECK(alone.points[0].query == 0);
  CHECK(alone.points[0].distance == Approx(-0.3));
  const PerturbedAnswer all = ask_perturbed(pair, {});
  REQUIRE(all.points.size() > 1);
  // The smaller disc is above 2, so that they are turned by less than 0.01.
  for (const BulletPoint& point : all.points) {
    CHECK(point.normal.x() == Approx(-1).margin(1e-4));
    CHECK(std::abs(point.normal.y()) < 0.01F);
    CHECK(point.distance == Approx(-0.3).margin(0.03));
  }
}

TEST_CASE("EPA's second GJK gives no direction of a circle about the end of a long segment") {
  const PairCase pair{body_at(std::array{Vector2<float>{0, 0}}, 0, 0, 200),
                      body_at(std::array{Vector2<float>{0, 0}, Vector2<float>{0, 10000}}, 0, 0)};
  EpaTrace trace;
  const BulletAnswer answer = ask_detector(prisms_of(pair), solve_by_epa, &trace, 1e18F);
  CHECK(answer.is_solver_asked);
  CHECK(answer.normal_of == NormalOf::nobody);
  const auto is_it = [](const PairCase& of) {
    return explains(epa_without_axis, of, {}, Kind::missed_contact);
  };
  CHECK(is_it(pair));
  CHECK_FALSE(is_explained(epa_without_axis, pair, {1, 0}, 200));
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
    return is_explained(epa_normal_between_places, pair, along, depth, Kind::witness);
  };
  CHECK(is_it(far, normal, -answer.distance));
  CHECK_FALSE(is_it(far, {1, 0.01}, -answer.distance));
  CHECK_FALSE(is_it(far, normal, 0.01 - answer.distance));
  // Of concentric circles EPA's own face is wrong.
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
    return is_explained(corner_before_first, huge, along, depth, Kind::witness);
  };
  CHECK(is_it(normal, -answer.distance));
  CHECK_FALSE(is_it({normal.x() + 0.01, normal.y()}, -answer.distance));
  CHECK_FALSE(is_it(normal, 1e15));
  CHECK_FALSE(is_explained(corner_before_first, squares_side_by_side(), {1, 0}, 0.3));
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
    return is_explained(stopped_by_relative_error<BulletAsked::epa>, pair, along, -answer.distance,
                        kind);
  };
  CHECK(is_it(normal, Kind::normal));
  CHECK_FALSE(is_it(normal, Kind::not_minimal));
  CHECK_FALSE(is_it({normal.x() + 1e-5, normal.y()}, Kind::normal));
}

TEST_CASE("shapes are turned out of the plane where the first normal is upright") {
  const PairCase pair{body_at(std::array{Vector2<float>{0, -1}, Vector2<float>{0, 2}}, 0, 0, 1.3F),
                      body_at(std::array{Vector2<float>{0, 0}}, 0, 0, 1.96F)};
  const PerturbedAnswer answer = ask_perturbed(prisms_of(pair), {});
  CHECK(std::abs(answer.first.normal.z()) > 0.9F);
  CHECK(deepest_of(answer.points)->query > 0);
  const auto is_it = [](const PairCase& of, const Manifold<double>& got) {
    return explains(turned_out_of_plane, of, got, Kind::inconsistent);
  };
  Manifold<double> got = replayed::in_frame_of_a(pair, seen_in_plane(answer.points));
  CHECK(is_it(pair, got));
  got.points[0].depth += 0.01;
  CHECK_FALSE(is_it(pair, got));
  const PairCase side = squares_side_by_side();
  const PerturbedAnswer of_side = ask_perturbed(prisms_of(side), {});
  CHECK_FALSE(is_it(side, replayed::in_frame_of_a(side, seen_in_plane(of_side.points))));
}

TEST_CASE("an answer that the repeated turns do not give is none of theirs") {
  const auto is_one = [](bool (*predicate)(const Deviation&)) {
    return is_explained(predicate, squares_side_by_side(), {1, 0}, 0.29);
  };
  CHECK_FALSE(is_one(point_replaced_by_turned));
  CHECK_FALSE(is_one(changed_by_refresh));
  CHECK_FALSE(is_one(normal_of_turned_query));
  CHECK_FALSE(is_one(point_of_turned_query));
  CHECK_FALSE(is_one(of_first_query<below_gjk_distance>));
}
