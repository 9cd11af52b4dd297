#include <cmath>

#include <catch2/catch.hpp>

#include "oracle/bullet/ledger/perturbed.hpp"
#include "oracle/repeated_pairs.hpp"

// Bullet's queries of turned shapes as the ledger repeats them, of pairs by hand, and what its
// entries say of their answers.

using namespace manifuzz;
using namespace manifuzz::ledger_of;
using namespace manifuzz::test;

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

TEST_CASE("shapes are turned out of the plane where the first normal is upright") {
  const PairCase pair{body_at(std::array{Vector2<float>{0, -1}, Vector2<float>{0, 2}}, 0, 0, 1.3F),
                      body_at(std::array{Vector2<float>{0, 0}}, 0, 0, 1.96F)};
  const PerturbedAnswer answer = ask_perturbed(prisms_of(pair), {});
  CHECK(std::abs(answer.first.normal.z()) > 0.9F);
  CHECK(deepest_of(answer.points)->query > 0);
  const auto is_it = [](const PairCase& of, const Manifold<double>& got) {
    return explains("bullet-perturbed-out-of-plane", of, got, Kind::inconsistent);
  };
  Manifold<double> got = replayed::in_frame_of_a(pair, seen_in_plane(answer.points));
  CHECK(is_it(pair, got));
  got.points[0].depth += 0.01;
  CHECK_FALSE(is_it(pair, got));
  const PairCase side = squares_side_by_side();
  const PerturbedAnswer of_side = ask_perturbed(prisms_of(side), {});
  CHECK_FALSE(is_it(side, replayed::in_frame_of_a(side, seen_in_plane(of_side.points))));
}

TEST_CASE("shapes are turned out of the plane where the first query ends at a flat simplex") {
  const PairCase pair{
      body_at(std::array{Vector2<float>{0, -32768}, Vector2<float>{0, 65536}}, 0, 0, 42598.4F),
      body_at(std::array{Vector2<float>{0, 0}}, 0, 0, 64225.28F)};
  const PerturbedAnswer answer = ask_perturbed(prisms_of(pair), {});
  REQUIRE(answer.first.loop.end == QueryEnd::degenerate);
  CHECK(std::abs(answer.first.normal.z()) > 0.9F);
  Manifold<double> got = replayed::in_frame_of_a(pair, seen_in_plane(answer.points));
  CHECK(explains("bullet-perturbed-out-of-plane", pair, got, Kind::witness));
  got.normal = -got.normal;
  CHECK_FALSE(explains("bullet-perturbed-out-of-plane", pair, got, Kind::witness));
}

TEST_CASE("shapes are turned out of the plane where the closest point of high prisms is rounded") {
  const auto segment_and_circle = [](float end, float radius) {
    return PairCase{body_at(std::array{Vector2<float>{0, 0}, Vector2<float>{end, 0}}, 0, 0),
                    body_at(std::array{Vector2<float>{0, 0}}, 0, 0, radius)};
  };
  const auto is_it = [](const PairCase& of, const Manifold<double>& got) {
    return explains("bullet-perturbed-out-of-plane", of, got, Kind::inconsistent);
  };
  const auto answer_of = [](const PairCase& of) { return ask_perturbed(prisms_of(of), {}); };
  // The upright edge's other end leaves the distance as it was, or is in the simplex already.
  const PairCase higher = segment_and_circle(131071.984F, 65536);
  CHECK(answer_of(higher).first.loop.end == QueryEnd::no_less);
  const PairCase lower = segment_and_circle(32767.996F, 20000);
  CHECK(answer_of(lower).first.loop.is_closest_rounded);
  for (const PairCase& pair : {higher, lower}) {
    const PerturbedAnswer answer = answer_of(pair);
    CHECK(answer.first.loop.axis.head<2>().isZero(0));
    CHECK(std::abs(answer.first.loop.axis.z()) > 0.001F);
    const Manifold<double> got = replayed::in_frame_of_a(pair, seen_in_plane(answer.points));
    CHECK(is_it(pair, got));
    Manifold<double> other = got;
    other.points[0].depth *= 1.001;
    CHECK_FALSE(is_it(pair, other));
    other = got;
    other.normal = -got.normal;
    CHECK_FALSE(is_it(pair, other));
    // The axis of cores that are apart by 1 is in the plane.
    PairCase apart = pair;
    apart.b.pose.position.y() = 1;
    const auto points = answer_of(apart).points;
    CHECK_FALSE(is_it(apart, replayed::in_frame_of_a(apart, seen_in_plane(points))));
  }
}

TEST_CASE("EPA says nothing where squares overflow, and refreshing closes the gap of 1") {
  const PairCase pair{triangle_of({Vector2<float>{0, 0}, {0, 1e9F}, {-2e9F, 0}}),
                      triangle_of({Vector2<float>{0, 0}, {-1e15F, 1e9F}, {0, -1}})};
  const PerturbedAnswer answer = ask_perturbed(prisms_of(pair), {});
  CHECK(answer.first.is_solver_asked);
  CHECK(answer.first.normal_of == NormalOf::query);
  CHECK(answer.first.distance == 1);
  const Manifold<double> got = replayed::in_frame_of_a(pair, seen_in_plane(answer.points));
  REQUIRE(got.count == 1);
  const auto is_it = [&](const Manifold<double>& other) {
    return explains("bullet-perturbed-refreshed", pair, other, Kind::witness);
  };
  CHECK(is_it(got));
  CHECK_FALSE(is_it({}));
  Manifold<double> other = got;
  other.normal = -got.normal;
  CHECK_FALSE(is_it(other));
  other = got;
  other.points[0].position = {0, 0};
  CHECK_FALSE(is_it(other));
}

TEST_CASE("an answer that the repeated turns do not give is none of theirs") {
  const auto is_one = [](std::string_view id) {
    return is_explained(id, squares_side_by_side(), {1, 0}, 0.29);
  };
  CHECK_FALSE(is_one("bullet-perturbed-replaced"));
  CHECK_FALSE(is_one("bullet-perturbed-refreshed"));
  CHECK_FALSE(is_one("bullet-perturbed-turned-normal"));
  CHECK_FALSE(is_one("bullet-perturbed-turned-point"));
  CHECK_FALSE(is_one("bullet-perturbed-least-distance"));
}
