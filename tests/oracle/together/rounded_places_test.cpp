#include <cmath>

#include <catch2/catch.hpp>

#include "judging/faults/shared_faults.hpp"
#include "oracle/parry/ledger/engines.hpp"
#include "oracle/repeated_pairs.hpp"

// Ways of an engine's fault that the witness of its entry does not show: nearest places that are
// rounded. What the engine answers is explained, and what is wrong otherwise is not.

using namespace manifuzz;
using namespace manifuzz::test;

namespace {

Body circle_at(const Vector2<float>& centre, float radius) {
  return body_at(std::array{centre}, 0, 0, radius);
}

/// A circle whose centre is 5.7e-7 from a triangle's corner, moved away by so much more.
PairCase circle_at_corner(float moved) {
  const std::array<Vector2<float>, 3> corners{Vector2<float>{0.20444617F, 0.71467215F},
                                              Vector2<float>{1, 0}, Vector2<float>{-0.82F, 2.33F}};
  Body triangle = body_at(corners, -0.26420826F, -0.6948011F, 1);
  triangle.polygon.rounding = Rounding::round;
  triangle.pose.rotation = {0.9964109F, -0.08464841F};
  return {triangle, circle_at({-5e-07F - moved, -3e-07F - moved}, 2)};
}

}  // namespace

TEST_CASE("Box2D 3.2's direction from a corner to a centre is that of its roundings") {
  const auto is_it = [](float moved, const Vector2<double>& normal, double depth) {
    return is_explained("box2d3-direction-of-rounded-place", circle_at_corner(moved), normal, depth,
                        Kind::not_minimal);
  };
  const Vector2<double> given(-0.8479983210563659, -0.5299989581108092);
  CHECK(is_it(0, given, 2.99999952));
  CHECK_FALSE(is_it(0, given, 2.99));
  CHECK_FALSE(is_it(0, {-0.9, -0.4358898943540673}, 2.99999952));
  CHECK_FALSE(is_it(0, -given, 2.99999952));
  CHECK_FALSE(is_it(0.01F, given, 2.985858));
}

TEST_CASE("Box2D 3.2 takes a centre within epsilon of a polygon to be inside") {
  // Above the triangle's corner, by so much.
  const auto above = [](float gap, float radius = 0.01F) {
    return PairCase{triangle_of({Vector2<float>{0, 0}, {0, 1e-4F}, {-1e-4F, 0}}),
                    circle_at({0, 1e-4F + gap}, radius)};
  };
  const auto is_it = [](const PairCase& pair, const Vector2<double>& normal, double depth) {
    return is_explained("box2d3-face-within-epsilon", pair, normal, depth);
  };
  const Vector2<double> of_face(-std::sqrt(0.5), std::sqrt(0.5));
  CHECK(is_it(above(1e-7F), of_face, 0.01 - 1e-7 * std::sqrt(0.5)));
  CHECK_FALSE(is_it(above(1e-7F), of_face, 0.01 - 1e-6));
  CHECK_FALSE(is_it(above(1e-7F), {0, 1}, 0.01 - 1e-7));
  CHECK_FALSE(is_it(above(1e-7F), -of_face, 0.01 - 1e-7 * std::sqrt(0.5)));
  // The corner is farther than the radius, the face is not.
  const auto depth_of_face = [](double radius) { return radius - 1e-7 * std::sqrt(0.5); };
  CHECK(is_it(above(1e-7F, 8e-8F), of_face, depth_of_face(8e-8)));
  CHECK_FALSE(is_it(above(1e-7F, 8e-8F), of_face, depth_of_face(9e-8)));
  // Farther, where the normal is the direction from the corner, and inside.
  CHECK_FALSE(is_it(above(2e-7F), of_face, 0.01 - 2e-7 * std::sqrt(0.5)));
  CHECK_FALSE(is_it(above(-1e-7F), of_face, 0.01 + 1e-7 * std::sqrt(0.5)));
}

TEST_CASE("dyn4j's Gjk takes short capsules that are apart for overlapping, the gap for a depth") {
  const auto is_it = [](float moved, const Manifold<double>& got, Lost::How how) {
    const std::array<Vector2<float>, 2> a{Vector2<float>{0, 0.00390625F}, Vector2<float>{0, 0}};
    const std::array<Vector2<float>, 2> b{Vector2<float>{1.953125e-05F, 0.00011328125F},
                                          Vector2<float>{2.734375e-05F, 0.0001171875F}};
    const float radius = 1.10783866e-07F;
    const PairCase pair{body_at(a, 0, 0, radius), body_at(b, moved, 0, radius)};
    return entry_of("dyn4j-gjk-direction-within-epsilon").explains_lost({pair, Answer(got), how});
  };
  const Manifold<double> given = one_point({1, 0}, {1.95e-5, 1e-4}, -1.909180898817537e-05);
  CHECK(is_it(0, given, Lost::How::malformed));
  CHECK_FALSE(is_it(0, given, Lost::How::timed_out));
  CHECK_FALSE(is_it(0, one_point({NAN, NAN}, {1.95e-5, 1e-4}, NAN), Lost::How::malformed));
  CHECK_FALSE(is_it(0, one_point({1, 0}, {1.95e-5, 1e-4}, -1.909e-05), Lost::How::malformed));
  CHECK_FALSE(is_it(1, given, Lost::How::malformed));
  CHECK_FALSE(is_it(-2e-5F, given, Lost::How::malformed));
}

TEST_CASE("cute_c2's GJK ends at corners within epsilon, wherever the edge is") {
  const auto is_it = [](float end, const Manifold<double>& got) {
    const std::array<Vector2<float>, 2> ends{Vector2<float>{0, end}, Vector2<float>{0, -0.002F}};
    const PairCase pair{circle_at({0, 0}, 0.08F), body_at(ends, 0, 0)};
    return explains("cute_c2-nearest-places", pair, got, Kind::inconsistent);
  };
  CHECK(is_it(8e-8F, one_point({0, 1}, {0, 8e-8}, 0.07999992)));
  CHECK_FALSE(is_it(8e-8F, one_point({0, 1}, {0, 8e-8}, 0.07)));
  CHECK_FALSE(is_it(8e-8F, one_point({0, -1}, {0, 8e-8}, 0.07999992)));
  CHECK_FALSE(is_it(1e-5F, one_point({0, 1}, {0, 1e-5}, 0.07999)));
}

TEST_CASE("cute_c2 finds no contact of crossing cores by the roundings of their distance") {
  // The segment begins and ends on both sides of the triangle's corner at the origin.
  const std::array<Vector2<float>, 3> corners{Vector2<float>{0, 0}, Vector2<float>{256, 256},
                                              Vector2<float>{-256, 0}};
  const auto is_it = [&](float from, const Manifold<double>& got) {
    const std::array<Vector2<float>, 2> ends{Vector2<float>{0, from}, Vector2<float>{256, 0}};
    const PairCase pair{body_at(corners, 0, 0), body_at(ends, 0, 0)};
    return explains("cute_c2-inside", pair, got, Kind::missed_contact);
  };
  CHECK(is_it(102.4F, {}));
  CHECK_FALSE(is_it(100, {}));  // no roundings: it finds the origin inside
  CHECK_FALSE(is_it(102.4F, one_point({0.7071067811865476, -0.7071067811865476}, {0, 102}, 1)));
}

TEST_CASE("parry's normal of capsules that are nearly parallel is across either core") {
  const std::array<Vector2<float>, 2> of_a{Vector2<float>{0, 0}, Vector2<float>{0, 0.04375F}};
  const std::array<Vector2<float>, 2> of_b{Vector2<float>{-0.0625F, 0},
                                           Vector2<float>{-0.062499974F, 0.000125F}};
  const PairCase pair{body_at(of_a, 0, 0, 0.0625F), body_at(of_b, 0, 0, 0.0625F)};
  const auto replay = parry::Doubles::replays(exact::stored(pair)).front();
  const Manifold<double> given = parry::Doubles::answer(replay, pair);
  const auto is_it = [&](const Manifold<double>& got) {
    return explains("parry2d-f64-nearly-parallel-capsules", pair, got, Kind::inconsistent,
                    ScalarType::float64);
  };
  CHECK(is_it(given));
  Manifold<double> turned = given;
  turned.normal = rotate<double>({std::cos(1e-3), std::sin(1e-3)}, given.normal);
  CHECK_FALSE(is_it(turned));
}

TEST_CASE("parry's GJK says inside of a gap, of whose chord the foot is rounded") {
  const std::array<Vector2<float>, 2> of_a{Vector2<float>{-0.82047564F, 0},
                                           Vector2<float>{0.7927104F, 0}};
  const std::array<Vector2<float>, 2> of_b{Vector2<float>{-1.45144F, 0},
                                           Vector2<float>{1.1431631F, 0}};
  const PairCase pair{body_at(of_a, 0, 0), body_at(of_b, 0, -2.4874705e-06F, 0.013509961F)};
  const auto replay = parry::Floats::replays(exact::stored(pair)).front();
  const Manifold<double> given = parry::Floats::answer(replay, pair);
  const auto is_it = [&](const Manifold<double>& got) {
    return explains("parry2d-rounded-foot", pair, got, Kind::inconsistent);
  };
  CHECK(replay.gjk.end == parry::GjkEnd::refused_inside);
  CHECK(is_it(given));
  Manifold<double> shallow = given;
  for (ContactPoint<double>& point : shallow.points) point.depth -= 0.001;
  CHECK_FALSE(is_it(shallow));
  CHECK_FALSE(is_it({}));
}

TEST_CASE("parry's EPA takes the far side of a chord within 10 epsilon of the origin") {
  const std::array<Vector2<float>, 2> of_a{Vector2<float>{0.4233569F, 0},
                                           Vector2<float>{-0.4564652F, 0}};
  const std::array<Vector2<float>, 2> of_b{Vector2<float>{0.42095563F, 0},
                                           Vector2<float>{-0.47352F, 0}};
  const auto at = [&](float gap) {
    return PairCase{body_at(of_a, 0, 0, 0.09211564F), body_at(of_b, 0, gap)};
  };
  const auto given_of = [](const PairCase& pair) {
    return parry::Floats::answer(parry::Floats::replays(exact::stored(pair)).front(), pair);
  };
  const auto is_it = [](const PairCase& pair, const Manifold<double>& got) {
    return explains("parry2d-origin-within-tolerance", pair, got, Kind::inconsistent);
  };
  const PairCase within = at(1.0610712e-06F);
  const Manifold<double> given = given_of(within);
  REQUIRE(given.count == 2);
  CHECK(given.normal.y() == -1);
  CHECK(is_it(within, given));
  Manifold<double> shallow = given;
  for (ContactPoint<double>& point : shallow.points) point.depth -= 0.001;
  CHECK_FALSE(is_it(within, shallow));
  Manifold<double> turned = given;
  turned.normal = -given.normal;
  CHECK_FALSE(is_it(within, turned));
  // Beyond the tolerance it is GJK that finds the direction.
  const PairCase beyond = at(1e-5F);
  CHECK(given_of(beyond).normal.y() == 1);
  CHECK_FALSE(is_it(beyond, given_of(beyond)));
}

TEST_CASE("parry's place on an edge nearly along the normal is off by more than roundings") {
  const std::array<Vector2<float>, 2> of_a{Vector2<float>{-0.00057922676F, 0.7916275F},
                                           Vector2<float>{0.00057922676F, -0.7916275F}};
  const std::array<Vector2<float>, 2> of_b{Vector2<float>{-0.47436944F, -0.2837607F},
                                           Vector2<float>{0.47436944F, 0.2837607F}};
  PairCase pair{body_at(of_a, -6.737253F, 1.4622158F, 0.33741593F),
                body_at(of_b, -5.8695445F, 2.3081374F)};
  pair.a.pose.rotation = {0.9089359F, -0.41693586F};
  pair.b.pose.rotation = {0.95268273F, -0.30396643F};
  const auto given_of = [](const PairCase& of) {
    return parry::Floats::answer(parry::Floats::replays(exact::stored(of)).front(), of);
  };
  const auto is_it = [](const PairCase& of, const Manifold<double>& got) {
    return explains("parry2d-edge-along-normal", of, got, Kind::inconsistent);
  };
  const Manifold<double> given = given_of(pair);
  REQUIRE(given.count == 1);
  CHECK(given.points[0].depth == Approx(0.3373906).margin(1e-7));
  CHECK(is_it(pair, given));
  Manifold<double> shallow = given;
  shallow.points[0].depth -= 0.001;
  CHECK_FALSE(is_it(pair, shallow));
  // Not beside its end the edge is as far as it seems.
  PairCase off = pair;
  off.b.pose.position.x() += 0.001F;
  CHECK_FALSE(is_it(off, given_of(off)));
}

TEST_CASE("parry looks at the first ends of capsules that are both shorter than 3e-4") {
  const std::array<Vector2<float>, 2> of_a{Vector2<float>{0, 0}, Vector2<float>{1e-5F, 0}};
  const std::array<Vector2<float>, 2> of_b{Vector2<float>{2e-5F, 1e-5F},
                                           Vector2<float>{-1e-5F, 1e-5F}};
  const auto with = [&](float radius) {
    return PairCase{body_at(of_a, 0, 0, radius), body_at(of_b, 0, 0, radius)};
  };
  const auto given_of = [](const PairCase& pair) {
    return parry::Floats::answer(parry::Floats::replays(exact::stored(pair)).front(), pair);
  };
  const auto is_it = [](const PairCase& pair, const Manifold<double>& got, Kind kind) {
    return explains("parry2d-nearly-parallel-capsules", pair, got, kind);
  };
  // They are 1e-5 from each other, their first ends 2.2e-5.
  REQUIRE(given_of(with(8e-6F)).count == 0);
  CHECK(is_it(with(8e-6F), {}, Kind::missed_contact));
  CHECK_FALSE(is_it(with(1.5e-5F), {}, Kind::missed_contact));  // it finds these
  const Manifold<double> between_ends = given_of(with(1.5e-5F));
  CHECK(is_it(with(1.5e-5F), between_ends, Kind::inconsistent));
}

TEST_CASE("parry takes a centre within epsilon of a segment to be inside of it") {
  const std::array<Vector2<float>, 2> ends{Vector2<float>{0, -0.001F}, Vector2<float>{0, 0.001F}};
  const auto at = [&](float off) {
    return PairCase{body_at(ends, 0, 0), circle_at({off, 0}, 0.005F)};
  };
  const auto is_it = [](const PairCase& pair, const Vector2<double>& normal, double depth) {
    return explains("parry2d-centre-on-surface", pair,
                    one_point(normal, -0.5 * depth * normal, depth));
  };
  CHECK(is_it(at(5e-8F), {-1, 0}, 0.005 + 5e-8));
  CHECK_FALSE(is_it(at(5e-8F), {-1, 0}, 0.005));
  CHECK_FALSE(is_it(at(5e-8F), {1, 0}, 0.005 + 5e-8));
  CHECK_FALSE(is_it(at(2e-7F), {-1, 0}, 0.005 + 2e-7));
}

TEST_CASE("of faces that tie, the end that a circle's centre is beyond is what engines may keep") {
  constexpr auto id = "planck-circle-tied-faces";
  const auto is_it = [&](const PairCase& pair, const Vector2<double>& normal, double depth) {
    return is_explained(id, pair, normal, depth, Kind::inconsistent, ScalarType::float64);
  };
  const auto is_none = [&](const PairCase& pair) {
    return explains(id, pair, {}, Kind::missed_contact, ScalarType::float64);
  };
  // A sliver whose corner in the middle is flat, and a centre beyond its upper one.
  const auto beside_sliver = [](float radius) {
    return PairCase{triangle_of({Vector2<float>{0, 0}, {4e-16F, 2}, {0, 4}}),
                    circle_at({600, 200}, radius)};
  };
  const Vector2<double> from_middle(600, 198);
  const Vector2<double> from_below(600, 200);
  CHECK(is_it(beside_sliver(1000), from_middle, 1000 - from_middle.norm()));
  CHECK_FALSE(is_it(beside_sliver(1000), from_middle, 1000 - from_middle.norm() - 0.1));
  CHECK_FALSE(is_it(beside_sliver(1000), from_below, 1000 - from_below.norm()));
  CHECK(is_none(beside_sliver(631.5F)));
  CHECK_FALSE(is_none(beside_sliver(640)));
  // For a centre on a square's diagonal two faces tie; engines answer these as they should.
  const auto on_square = [](float at, float radius) {
    return PairCase{square_of_two(0, 0), circle_at({at, at}, radius)};
  };
  CHECK_FALSE(is_none(on_square(2, 2)));
  CHECK_FALSE(is_none(on_square(0.5F, 1)));
  CHECK_FALSE(is_none(on_square(0, 0.5F)));
  CHECK_FALSE(is_it(on_square(2, 4), {1, 3}, 4 - std::sqrt(10.0)));
  CHECK_FALSE(is_it(on_square(0, 2), {-1, 1}, 2 - std::sqrt(2.0)));
}
