#include "methods/epa.hpp"

#include <catch2/catch.hpp>

#include "methods/closest_points.hpp"
#include "unit/methods/placed.hpp"

using namespace manifuzz;
using namespace manifuzz::methods;
using test::box_at;
using test::shape;

namespace {

Manifold<double> contact(const ConvexPolygon<double>& a, const ConvexPolygon<double>& b) {
  Simplex hint;
  return contact_by_gjk(a, b, hint).manifold;
}

}  // namespace

TEST_CASE("the nearest face of an overlap is the answer, whichever corner GJK began with") {
  const auto a = box_at(0, 0);
  const auto b = box_at(1.5, 0.25);
  for (unsigned char i = 0; i < 4; ++i) {
    for (unsigned char j = 0; j < 4; ++j) {
      Simplex hint{{{{i, j}, {}, {}}}, 1};
      const PointContact<double> found = contact_by_gjk(a, b, hint);
      CHECK(found.epa_iterations > 0);
      CHECK(found.manifold.normal == Vector2<double>(1, 0));
      CHECK(found.manifold.points[0].depth == 0.5);
      CHECK(found.manifold.points[0].position.x() == 0.5);
    }
  }
}

TEST_CASE("crossing segments leave each other across a face of either") {
  const auto a = shape<double>({{-4, 0}, {4, 0}}, 0.5);
  const auto found = contact(a, shape<double>({{0, -1}, {0, 3}}));
  CHECK(found.normal == Vector2<double>(0, 1));
  CHECK(found.points[0].depth == 1.5);
  CHECK(found.points[0].position == Vector2<double>(0, -1));
}

TEST_CASE("a point in a segment, segments on one line, and a point on a point touch at depth 0") {
  const auto segment = shape<double>({{-4, 0}, {4, 0}});
  const auto point = shape<double>({{1, 0}}, 0.25);
  CHECK(contact(segment, point).points[0].depth == 0.25);
  CHECK(std::abs(contact(segment, point).normal.y()) == 1);
  CHECK(contact(segment, shape<double>({{1, 0}, {9, 0}}, 0.5)).points[0].depth == 0.5);
  const auto same = contact(point, point);
  CHECK(same.normal == Vector2<double>(1, 0));
  CHECK(same.points[0].depth == 0.5);
}

TEST_CASE("a tiny edge far from the origin is told by its own normal") {
  // A chamfer of 2^-20 at the corner where B's corner is.
  const double e = 0x1p-20;
  const auto a = shape<double>({{-1e3, -1e3}, {0, -1e3}, {0, -e}, {-e, 0}, {-1e3, 0}});
  const auto b = shape<double>({{-e / 2, -e / 2}, {5, 0}, {5, 5}, {0, 5}});
  const auto found = contact(a, b);
  CHECK(found.normal.x() == Approx(std::sqrt(0.5)).epsilon(1e-15));
  CHECK(found.points[0].depth <= e);
}

TEST_CASE("one shape twice, of any kind, is right") {
  const bool holds = rc::check([] {
    PairCase pair = test::any_pair(regimes());
    pair.b = pair.a;
    RC_ASSERT(test::is_right(pair, make_gjk()));
    RC_ASSERT(test::is_right(pair, make_gjk64()));
  });
  CHECK(holds);
}
