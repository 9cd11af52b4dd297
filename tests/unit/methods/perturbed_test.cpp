#include "methods/perturbed.hpp"

#include <catch2/catch.hpp>

#include "judging/extent.hpp"
#include "methods/closest_points.hpp"
#include "unit/methods/placed.hpp"

using namespace manifuzz;
using namespace manifuzz::methods;
using test::box_at;
using test::shape;

namespace {

/// How often a detection was asked, and B's poses.
struct Asked {
  std::vector<Pose<double>> poses;

  Manifold<double> contact(const ConvexPolygon<double>& a, const ConvexPolygon<double>& b,
                           const Pose<double>& b_in_a) {
    return contact_by_perturbing(a, b, b_in_a,
                                 [this](const auto& p, const auto& q, const Pose<double>& q_in_p) {
                                   poses.push_back(q_in_p);
                                   Simplex hint;
                                   return contact_by_gjk(p, q, q_in_p, hint).manifold;
                                 });
  }
};

}  // namespace

TEST_CASE("boxes on each other touch at both ends, whichever was found first") {
  const auto floor = box_at(0, 0);
  const Pose<double> above{{0.5, 1.75}, {1, 0}};
  Asked asked;
  const Manifold<double> found = asked.contact(floor, box_at(0, 0), above);
  REQUIRE(found.count == 2);
  CHECK(found.normal == Vector2<double>(0, 1));
  // In the contract's order: along A's upper face, from right to left.
  CHECK((found.points[0].position - Vector2<double>(1, 0.75)).norm() < 1e-12);
  CHECK((found.points[1].position - Vector2<double>(-0.5, 0.75)).norm() < 1e-12);
  CHECK(found.points[0].depth == Approx(0.25));
  CHECK(found.points[1].depth == Approx(0.25));
  // The point found first is an end: beyond it there is nothing to look for.
  CHECK(asked.poses.size() == 2);
}

TEST_CASE("one shape is turned by the chord, after which the first point just touches") {
  const Pose<double> above{{0, 1.75}, {1, 0}};
  Asked asked;
  asked.contact(box_at(0, 0), box_at(0, 0), above);
  REQUIRE(asked.poses.size() == 2);
  const Vector2<double> rotation = asked.poses[1].rotation;
  CHECK(std::abs(rotation.y() / rotation.x()) == Approx(0.25 / 2));
  const ConvexPolygon<double> turned = transform(asked.poses[1], box_at(0, 0));
  // The corners that were below: one has the other's depth, but for the turn's cosine.
  const double both[] = {turned.vertices[0].y(), turned.vertices[1].y()};
  CHECK(std::max(both[0], both[1]) == Approx(1).epsilon(0.01));
  CHECK(std::min(both[0], both[1]) == Approx(0.75).epsilon(0.01));
}

TEST_CASE("the end of an edge that is short beside both shapes is found, too") {
  // Its lower edge is a tenth as long as the shape, tilted by 0.1; what is beside it rises steeply.
  const auto cut = shape<double>({{-0.1, 0}, {0.1, 0.02}, {1, 1}, {-1, 1}});
  const Pose<double> above{{0, 0.97}, {1, 0}};
  Asked asked;
  const Manifold<double> found = asked.contact(box_at(0, 0), cut, above);
  REQUIRE(found.count == 2);
  CHECK(found.points[0].position.x() == Approx(0.1));
  CHECK(found.points[0].depth == Approx(0.01));
  CHECK(found.points[1].position.x() == Approx(-0.1));
  CHECK(found.points[1].depth == Approx(0.03));
}

TEST_CASE("a tilted edge keeps its end as deep as the end itself is") {
  const double tilt = 0.1;
  const Pose<double> above{{0, 1.9}, {std::cos(tilt), std::sin(tilt)}};
  Asked asked;
  const Manifold<double> found = asked.contact(box_at(0, 0), box_at(0, 0), above);
  REQUIRE(found.count == 2);
  const ConvexPolygon<double> b = transform(above, box_at(0, 0));
  for (const ContactPoint<double>& point : found.points) {
    CHECK(point.depth == Approx(1 - point.position.y()));
    double nearest = 10;
    for (const auto& corner : b.corners()) {
      nearest = std::min(nearest, (corner - point.position).norm());
    }
    // The end past A's corner is where the edge leaves A.
    CHECK(std::min(nearest, 1 - std::abs(point.position.x())) < 1e-12);
  }
}

TEST_CASE("a corner in a face has no second point, since those beside it do not touch") {
  const double half = std::sqrt(0.5);
  const Pose<double> above{{0, 2.25}, {half, half}};
  Asked asked;
  const Manifold<double> found = asked.contact(box_at(0, 0), box_at(0, 0), above);
  CHECK(found.count == 1);
  CHECK(asked.poses.size() == 3);
}

TEST_CASE("a point in the middle of two that are as deep is not needed") {
  const auto floor = box_at(0, 0);
  const auto box = box_at(0, 0);
  const Pose<double> above{{0, 1.75}, {1, 0}};
  int asked = 0;
  const Manifold<double> found = contact_by_perturbing(
      floor, box, above, [&](const auto& a, const auto& b, const Pose<double>& b_in_a) {
        Simplex hint;
        Manifold<double> one = contact_by_gjk(a, b, b_in_a, hint).manifold;
        if (asked++ == 0) one.points[0].position = {0.25, 0.75};
        return one;
      });
  REQUIRE(found.count == 2);
  CHECK(found.points[0].position.x() == Approx(1));
  CHECK(found.points[1].position.x() == Approx(-1));
}

TEST_CASE("what is apart is asked about once") {
  Asked asked;
  CHECK(asked.contact(box_at(0, 0), box_at(0, 0), {{0, 2.5}, {1, 0}}).count == 0);
  CHECK(asked.poses.size() == 1);
}

TEST_CASE("of a line along an edge the outermost place is the edge's farther end") {
  const auto box = box_at(0, 0);
  const Vector2<double> up{0, 1};
  const Vector2<double> right{1, 0};
  CHECK(outermost_place<double>(box, up, right, 1, 1e-9).position == Vector2<double>(1, 1));
  CHECK(outermost_place<double>(box, -up, right, 1, 1e-9).position == Vector2<double>(1, -1));
  const auto inside = outermost_place<double>(box, up, right, 0.25, 1e-9);
  CHECK(inside.position == Vector2<double>(0.25, 1));
  CHECK(inside.feature == clipping::face(2));
}

TEST_CASE("cases of edges along the normal that rounding decided wrongly once are right") {
  const PairCase pair = generate(2, *find_regime("tied_faces"), 4022);
  CHECK(test::is_right(pair, make_perturbed()));
  CHECK(test::is_right(pair, make_perturbed64()));
}

TEST_CASE("over another collider the points are as over gjk itself") {
  const Collider over = make_perturbed_over(make_gjk64());
  CHECK(over.declaration.name == "perturbed+gjk64");
  const Collider built_in = make_perturbed64();
  int twos = 0;
  int differ = 0;
  for (std::uint64_t i = 0; i < 500; ++i) {
    const PairCase pair = generate(3, *find_regime("generic"), i, {.corpus = {}, .radius = 0.0F});
    CHECK(test::is_right(pair, over));
    const auto one = std::get<Manifold<double>>(over.collide(pair));
    const auto other = std::get<Manifold<double>>(built_in.collide(pair));
    // Ends that are no deeper than the rounding of a pose to floats may be found or not.
    differ += one.count != other.count ? 1 : 0;
    twos += one.count == 2 ? 1 : 0;
  }
  CHECK(twos > 50);
  CHECK(differ < 5);
}
