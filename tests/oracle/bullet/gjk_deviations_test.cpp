#include <cmath>

#include <catch2/catch.hpp>

#include "judging/by_curve.hpp"
#include "judging/faults/shared_faults.hpp"
#include "oracle/bullet/ledger/deviations.hpp"
#include "oracle/libccd/ledger/deviations.hpp"
#include "oracle/repeated_pairs.hpp"

// The ledger's predicates on Bullet and libccd: what the named fault makes of a pair by hand is
// explained, and what is wrong otherwise is not.

using namespace manifuzz;
using namespace manifuzz::ledger_of;
using namespace manifuzz::test;

namespace {

Manifold<double> manifold_of(const Vector2<double>& normal, double depth) {
  Manifold<double> manifold;
  manifold.count = 1;
  manifold.normal = normal.normalized();
  manifold.points[0].depth = depth;
  return manifold;
}

bool of_fixed_directions(const Deviation& deviation) {
  return is_of_least_direction(deviation, BulletAsked::directions);
}

bool of_flattened_directions(const Deviation& deviation) {
  return is_of_least_direction(deviation, BulletAsked::flat);
}

Manifold<double> none() {
  return {};
}

/// Two that are apart by so much.
PairCase apart_by(float gap) {
  return {square_of_two(0, 0), square_of_two(2 + gap, 0.5F)};
}

}  // namespace

TEST_CASE("a direction of roundings is one where the translation is right and short") {
  const auto is_it = [](const PairCase& pair, const Manifold<double>& got,
                        Kind kind = Kind::not_minimal) {
    return explains(direction_of_short_translation, pair, got, kind);
  };
  const PairCase shallow = apart_by(-0x1p-21F);
  CHECK(is_it(shallow, manifold_of({1, 0.5}, 0x1p-21)));
  CHECK_FALSE(is_it(shallow, manifold_of({1, 0.5}, 0.01)));
  CHECK_FALSE(is_it(shallow, manifold_of({1, 0.5}, 0x1p-21), Kind::witness));
  CHECK_FALSE(is_it(shallow, none()));
  CHECK_FALSE(is_it(squares_side_by_side(), manifold_of({1, 0.1}, 0.3)));
  CHECK_FALSE(is_it(squares_side_by_side(), manifold_of({-1, 0}, 0.3), Kind::reversed));
}

TEST_CASE("below GJK_MIN_DISTANCE both the pair and the answer are") {
  const auto is_it = [](const PairCase& pair, const Manifold<double>& got) {
    return explains(below_gjk_distance, pair, got, Kind::phantom_contact);
  };
  CHECK(is_it(apart_by(6e-5F), manifold_of({1, 0}, 6e-5)));
  CHECK(is_it(apart_by(-6e-5F), none()));
  CHECK_FALSE(is_it(apart_by(6e-5F), manifold_of({1, 0}, 1e-3)));
  CHECK_FALSE(is_it(apart_by(1e-3F), manifold_of({1, 0}, 6e-5)));
  CHECK_FALSE(is_it(apart_by(-1e-3F), none()));
}

TEST_CASE("a gap as a depth is no deeper than the gap") {
  const auto is_it = [](const PairCase& pair, const Manifold<double>& got) {
    return explains(gap_as_depth, pair, got, Kind::phantom_contact);
  };
  CHECK(is_it(apart_by(5e-4F), manifold_of({1, 0}, 5e-4)));
  CHECK_FALSE(is_it(apart_by(5e-4F), manifold_of({1, 0}, 2e-3)));
  CHECK_FALSE(is_it(apart_by(5e-3F), manifold_of({1, 0}, 5e-3)));
  CHECK_FALSE(is_it(squares_side_by_side(), manifold_of({1, 0}, 1e-4)));
}

TEST_CASE("the least of the fixed directions, and the depth of the displaced query") {
  // Along (cos 18, sin 18) they overlap by 0.748829. Moved by 0.5 more, they are apart by
  // 0.8877 along x: 1.248829 - 0.8877.
  const Vector2<double> normal(0.951058, 0.309013);
  const double overlap = normal.dot(Vector2<double>(2 - 1.7F, 1.5));
  const double depth = overlap + 0.5 - (normal.x() * (overlap + 0.5) - (2 - 1.7F));
  const auto is_it = [](const Manifold<double>& got, Kind kind = Kind::inconsistent) {
    return explains(of_fixed_directions, squares_side_by_side(), got, kind);
  };
  CHECK(is_it(manifold_of(normal, depth)));
  CHECK_FALSE(is_it(manifold_of(normal, depth), Kind::witness));
  CHECK_FALSE(is_it(manifold_of(normal, overlap)));
  CHECK_FALSE(is_it(manifold_of({1, 0}, depth)));
  CHECK_FALSE(is_it(manifold_of({0.587786, 0.809017}, depth)));
  CHECK_FALSE(is_it(manifold_of(-normal, depth)));
  CHECK_FALSE(is_it(none(), Kind::missed_contact));
}

TEST_CASE("the least of the flattened directions, which are not unit") {
  // (0.52573, 0) seems to overlap least; moved by 0.3457 they are apart by 0.0457 along x.
  const double overlap = 0.52573 * (2 - 1.7F);
  const double moved = 0.52573 * (overlap + 0.5);
  const double depth = 0.52573 * (overlap + 0.5 - (moved - (2 - 1.7F)));
  const auto is_it = [](const PairCase& pair, const Manifold<double>& got) {
    return explains(of_flattened_directions, pair, got);
  };
  CHECK(is_it(squares_side_by_side(), manifold_of({1, 0}, depth)));
  CHECK_FALSE(is_it(squares_side_by_side(), manifold_of({1, 0}, 0.31)));
  CHECK_FALSE(is_it(squares_side_by_side(), manifold_of({0.425323, 0.309011}, depth)));
  CHECK_FALSE(is_it(squares_side_by_side(), none()));
  // Where they are deeper, the displaced shapes still overlap, and there is no answer.
  const PairCase deep{square_of_two(0, 0), square_of_two(0.5F, 0.25F)};
  CHECK(is_it(deep, none()));
  CHECK_FALSE(is_it(deep, manifold_of({1, 0}, 0.4)));
}

TEST_CASE("zeros of squares are within the root of epsilon, in double") {
  const auto is_it = [](const PairCase& pair, const Manifold<double>& got) {
    return explains(zero_of_squares, pair, got, Kind::not_minimal, ScalarType::float64);
  };
  const PairCase touch = apart_by(0);
  CHECK(is_it(touch, manifold_of({1, 1}, 1e-8)));
  CHECK_FALSE(is_it(touch, manifold_of({1, 1}, 1e-6)));
  CHECK_FALSE(is_it(squares_side_by_side(), manifold_of({1, 0.1}, 0.3)));
}

TEST_CASE("a tolerance of squares leaves the answer on a chord, and the last corner near") {
  // Their difference goes from (-3.7, -2.5) to (0.3, 1.5); the chord from its corner at the lower
  // right to the one at the upper left passes the origin at 0.7778, far from the last corner.
  const auto is_it = [](const PairCase& pair, const Manifold<double>& got) {
    return explains(tolerance_of_squares, pair, got, Kind::inconsistent, ScalarType::float64);
  };
  CHECK_FALSE(is_it(squares_side_by_side(), manifold_of({1, 0}, 0.2999)));
  CHECK_FALSE(is_it(squares_side_by_side(), manifold_of({1, 0.3}, 0.2)));
  // A corner cut by 0.004: without its vertex the face next to it goes on, 0.002 too shallow.
  const std::array<Vector2<float>, 5> cut{Vector2<float>{-1, -1}, Vector2<float>{1, -1},
                                          Vector2<float>{1.004F, 0}, Vector2<float>{1, 1},
                                          Vector2<float>{-1, 1}};
  PairCase pair = squares_side_by_side();
  pair.a.polygon = make_polygon<float>(cut);
  pair.b.pose.position = {1.7F, 0};
  const double short_of = (2 - 1.7F);
  CHECK(is_it(pair, manifold_of({1, 0}, short_of)));
  CHECK_FALSE(is_it(pair, manifold_of({1, 0}, short_of + 0.001)));
  CHECK_FALSE(is_it(pair, manifold_of({1, 0.1}, short_of)));
}
