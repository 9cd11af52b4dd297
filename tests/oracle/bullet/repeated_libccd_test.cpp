#include <cmath>

#include <catch2/catch.hpp>

#include "judging/by_curve.hpp"
#include "judging/faults/shared_faults.hpp"
#include "judging/judge.hpp"
#include "oracle/bullet/ledger/deviations.hpp"
#include "oracle/bullet/ledger/epa.hpp"
#include "oracle/libccd/ledger/deviations.hpp"
#include "oracle/libccd/ledger/polytope.hpp"
#include "oracle/libccd/ledger/portal.hpp"
#include "oracle/repeated_pairs.hpp"
#include "own_colliders/own_colliders.hpp"

// libccd's queries as the ledger repeats them, of pairs by hand, and what is of both engines. That
// they answer as the engine does, the witnesses show.

using namespace manifuzz;
using namespace manifuzz::ledger_of;
using namespace manifuzz::test;

TEST_CASE("the repeated polytope ends at the nearest face of two squares") {
  const CcdAnswer answer = ccd_penetration(squares_side_by_side());
  CHECK(answer.end == CcdEnd::along);
  CHECK(answer.nearest.place.x() == Approx(0.3));
  CHECK_FALSE(is_explained("libccd-gjk-left-by-squares", squares_side_by_side(), {1, 0}, 0.3,
                           Kind::inconsistent, ScalarType::float64));
  CHECK(ccd_penetration({square_of_two(0, 0), square_of_two(3, 0.5F)}).end == CcdEnd::none);
}

TEST_CASE("the corner of the ray is the one beyond the middle, where the origin is on the way") {
  // The origin is on the diagonal of the difference, whose corner is (1.5, 1.5) away.
  const PairCase diagonal{square_of_two(0, 0), square_of_two(0.5F, 0.5F)};
  const auto is_it = [](const PairCase& pair, const Vector2<double>& normal, double depth) {
    return is_explained("libccd-mpr-corner-of-ray", pair, normal, depth, Kind::not_minimal,
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
    return is_explained("libccd-mpr-face-of-ray", pair, normal, depth, Kind::not_minimal,
                        ScalarType::float64);
  };
  CHECK(is_it({1, 0}, 3));
  CHECK_FALSE(is_it({3, 0.5}, std::hypot(3, 0.5)));
  CHECK_FALSE(is_it({1, 0}, 2.5));
  CHECK_FALSE(is_it({0, -1}, 2.5));
  CHECK_FALSE(explains("libccd-mpr-face-of-ray", pair, {}, Kind::missed_contact));
}

TEST_CASE("eight triangles about two corners of a difference are folded beside the origin") {
  const PairCase pair{triangle_of({Vector2<float>{0, 0}, {-1, 0}, {0, -1}}),
                      triangle_of({Vector2<float>{0, 0}, {1, -1}, {1, 0}})};
  const CcdAnswer answer = ccd_penetration(pair);
  REQUIRE(answer.first.size() == 4);
  const Vector2<double> translation(answer.nearest.place.x(), answer.nearest.place.y());
  const auto is_it = [&](double depth) {
    return is_explained("libccd-gjk-folded", pair, translation, depth, Kind::not_minimal,
                        ScalarType::float64);
  };
  CHECK(is_it(translation.norm()));
  CHECK_FALSE(is_it(translation.norm() + 1e-6));
  CHECK(ccd_penetration(squares_side_by_side()).first.size() < 4);
}

TEST_CASE("a triangle by the origin is expanded by a corner that is not beyond it") {
  // Below B's edge from (-6e-4, 0) to (4e-5, 0), by so much.
  const auto below = [](float depth) {
    return PairCase{triangle_of({Vector2<float>{0, depth}, {-1, -1}, {-44, -1000}}),
                    triangle_of({Vector2<float>{4e-5F, 0}, {-80, 1000}, {-6e-4F, 0}})};
  };
  // Held against the repeated answer, longer by that.
  const auto is_it = [](const PairCase& pair, double longer) {
    const CcdAnswer answer = ccd_penetration(pair);
    const Vector2<double> translation(answer.nearest.place.x(), answer.nearest.place.y());
    return is_explained("libccd-gjk-expanded-inwards", pair, translation,
                        translation.norm() + longer, Kind::not_minimal, ScalarType::float64);
  };
  CHECK(is_it(below(1e-10F), 0));
  CHECK_FALSE(is_it(below(1e-10F), 1e-6));
  // Farther inside, where the polytope is expanded outwards, or not at all.
  for (const float depth : {1e-8F, 1e-4F, 1.0F}) CHECK_FALSE(is_it(below(depth), 0));
  CHECK_FALSE(is_it(squares_side_by_side(), 0));
  // Outside from the first.
  CHECK_FALSE(is_it({triangle_of({Vector2<float>{0, 0}, {-1, 0}, {0, -1}}),
                     triangle_of({Vector2<float>{0, 0}, {1, -1}, {1, 0}})},
                    0));
}

TEST_CASE("triangles 1e14 wide are expanded in a cycle, others to an end") {
  const PairCase pair{triangle_of({Vector2<float>{0, 0}, {-1e14F, 1e8F}, {0, -1}}),
                      triangle_of({Vector2<float>{0, 0}, {0, 2e8F}, {-1e8F, 0}})};
  const auto is_endless = entry_of("libccd-gjk-endless").explains_lost;
  const Answer none = Lost{Lost::How::timed_out};
  CHECK(is_endless({pair, none, Lost::How::timed_out}));
  CHECK_FALSE(is_endless({pair, none, Lost::How::crashed}));
  CHECK_FALSE(is_endless({squares_side_by_side(), none, Lost::How::timed_out}));
  // A triangle and its corner come twice in each cycle.
  const auto turned = [](float width) {
    PairCase twice{triangle_of({Vector2<float>{0, 0}, {2000, 0}, {0, 0.9999999F}}),
                   triangle_of({Vector2<float>{0, 0}, {width, 1}, {0, 1}})};
    twice.b.pose.rotation = {0, 0.9999998F};
    return twice;
  };
  CHECK(is_endless({turned(7e7F), none, Lost::How::timed_out}));
  CHECK_FALSE(is_endless({turned(7e6F), none, Lost::How::timed_out}));
}

TEST_CASE("what is right of a translation is explained where the repeated engine answers it") {
  // Corner on corner, where any direction is right of a depth of 0.
  const PairCase pair = triangles_corner_on_corner();
  const Manifold<double> got = one_point(Vector2<double>(1, -1).normalized(), {0, 0}, 1e-9);
  CHECK(explains(zero_of_squares, pair, got, Kind::not_minimal, ScalarType::float64));
  CHECK_FALSE(
      explains("libccd-gjk-zero-of-squares", pair, got, Kind::not_minimal, ScalarType::float64));
  // Bullet's, of squares 6e-5 apart: below GJK_MIN_DISTANCE, and its own answer alone.
  const PairCase touch{square_of_two(0, 0), square_of_two(2.00006F, 0.5F)};
  EpaTrace trace;
  const BulletAnswer answer = ask_detector(prisms_of(touch), solve_by_epa, &trace, 1e18F);
  const Vector2<double> normal(-answer.normal.x(), -answer.normal.y());
  REQUIRE(trace.is_near);
  CHECK(explains(below_gjk_distance, touch, one_point({0, 1}, {0, 0}, 5e-5)));
  CHECK_FALSE(is_explained("bullet-epa-least-distance", touch, {0, 1}, 5e-5));
  CHECK(is_explained("bullet-epa-least-distance", touch, normal, -answer.distance));
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
