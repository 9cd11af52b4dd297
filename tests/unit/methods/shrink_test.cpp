#include "methods/shrink.hpp"

#include <catch2/catch.hpp>

#include "unit/methods/placed.hpp"

using namespace manifuzz;
using namespace manifuzz::methods;
using test::box_at;
using test::shape;

TEST_CASE("a box shrinks to a box with its corners round") {
  const auto shrunk = shrink(box_at(0, 0), 0.25);
  CHECK(inradius(box_at(0, 0)) == 1);
  CHECK(shrunk.is_round());
  CHECK(shrunk.radius == 0.25);
  REQUIRE(shrunk.count == 4);
  CHECK(shrunk.vertices[0] == Vector2<double>(-0.75, -0.75));
  CHECK(shrunk.vertices[2] == Vector2<double>(0.75, 0.75));
}

TEST_CASE("a face that is too short vanishes, and its neighbours meet") {
  // The chamfer of 0.1 turns by half a right angle at both ends: it is gone after 0.17.
  const auto chamfered = shape<double>({{-1, -1}, {1, -1}, {1, 0.9}, {0.9, 1}, {-1, 1}});
  CHECK(shrink(chamfered, 0.15).count == 5);
  const auto shrunk = shrink(chamfered, 0.5);
  REQUIRE(shrunk.count == 4);
  CHECK(shrunk.vertices[2].x() == Approx(0.5));
  CHECK(shrunk.vertices[2].y() == Approx(0.5));
}

TEST_CASE("at the inradius a triangle is a point, and a rectangle a segment") {
  const auto triangle = shape<double>({{0, 0}, {4, 0}, {0, 3}});
  CHECK(inradius(triangle) == Approx(1));
  const auto rectangle = shape<double>({{0, 0}, {6, 0}, {6, 2}, {0, 2}}, 0.5);
  CHECK(inradius(rectangle) == 1);
  const auto segment = shrink(rectangle, 7.0);
  REQUIRE(segment.count == 2);
  CHECK(segment.radius == 1.5);
  CHECK((segment.vertices[1] - segment.vertices[0]).norm() == Approx(4));
}

TEST_CASE("what has no inside stays as it is") {
  const auto capsule = shape<double>({{0, 0}, {1, 0}}, 0.5);
  CHECK(inradius(capsule) == 0);
  CHECK(shrink(capsule, 0.25) == capsule);
  CHECK(shrink(box_at(0, 0), 0.0) == box_at(0, 0));
}

TEST_CASE("a shrunk polygon has its faces where the polygon has them, and reaches over none") {
  const bool holds = rc::check([] {
    const auto polygon = test::any_pair(polygon_regimes()).a.polygon;
    const double part = *rc::gen::inRange(1, 100) / 100.0;
    const auto by = static_cast<float>(part * inradius(polygon));
    if (by == 0) RC_DISCARD("nothing to take off");
    const auto shrunk = shrink(polygon, by);
    RC_ASSERT(shrunk.radius == polygon.radius + by);
    RC_ASSERT(shrunk.count < kMinVertices || !find_defect(shrunk.corners()));
    const double off = 0x1p-21 * reach(polygon);
    for (int i = 0; i < polygon.count; ++i) {
      const Vector2<double> from = polygon.vertices[i].cast<double>();
      const Vector2<double> to = polygon.vertices[polygon.next(i)].cast<double>();
      const Vector2<double> normal = outward_normal(from, to);
      for (const Vector2<float>& corner : shrunk.corners()) {
        RC_ASSERT(normal.dot(corner.cast<double>() - from) <= off - static_cast<double>(by));
      }
    }
    for (int k = 0; k < shrunk.face_count(); ++k) {
      bool is_face = shrunk.count < kMinVertices;
      for (int i = 0; i < polygon.count; ++i) {
        const Vector2<double> from = polygon.vertices[i].cast<double>();
        const Vector2<double> to = polygon.vertices[polygon.next(i)].cast<double>();
        const auto gap = [&](int corner) {
          const Vector2<double> place = shrunk.vertices[corner].cast<double>() - from;
          return std::abs(outward_normal(from, to).dot(place) + static_cast<double>(by));
        };
        is_face = is_face || (gap(k) <= off && gap(shrunk.next(k)) <= off);
      }
      RC_ASSERT(is_face);
    }
  });
  CHECK(holds);
}

TEST_CASE("a collider of shrunk polygons is right by the shapes that it says it used") {
  const bool holds =
      rc::check([] { RC_ASSERT(test::is_right(test::any_pair(regimes()), make_gjk_shrunk())); });
  CHECK(holds);
}
