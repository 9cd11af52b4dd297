#include "methods/gjk.hpp"

#include <catch2/catch.hpp>

#include "unit/methods/placed.hpp"

using namespace manifuzz;
using namespace manifuzz::methods;
using test::box_at;
using test::shape;

namespace {

const ConvexPolygon<double> kBox = box_at(0, 0);

/// The distance, from the nearest feature.
double distance(const GjkResult& found, const ConvexPolygon<double>& a,
                const ConvexPolygon<double>& b) {
  return std::sqrt(nearest_of_simplex(Difference<double>(a, b), found.simplex).squared);
}

}  // namespace

TEST_CASE("faces that are nearest give the direction across them") {
  const auto b = box_at(5, 0.5);
  const GjkResult found = gjk(kBox, b);
  CHECK(found.apartness == Apartness::apart);
  CHECK(found.simplex.count == 2);
  CHECK(found.direction.x() > 0);
  CHECK(found.direction.y() == 0);
  CHECK(distance(found, kBox, b) == 3);
}

TEST_CASE("corners that are nearest give the direction between them") {
  const auto b = box_at(5, 6);
  const GjkResult found = gjk(kBox, b);
  CHECK(found.apartness == Apartness::apart);
  CHECK(found.simplex == Simplex{{{{2, 0}, {}, {}}}, 1});
  CHECK(found.direction == Vector2<double>(3, 4));
}

TEST_CASE("a direction that separates by more than the limit ends the search") {
  const auto b = box_at(5, 0);
  CHECK(gjk(kBox, b, {}, 2.9).apartness == Apartness::separated);
  CHECK(gjk(kBox, b, {}, 3.1).apartness == Apartness::apart);
  CHECK(gjk(kBox, b, {}, 0).iterations <= gjk(kBox, b).iterations);
}

TEST_CASE("cores that touch overlap") {
  CHECK(gjk(kBox, box_at(2, 0)).apartness == Apartness::overlapping);
  CHECK(gjk(kBox, box_at(2, 2)).apartness == Apartness::overlapping);
  CHECK(gjk(kBox, kBox).apartness == Apartness::overlapping);
}

TEST_CASE("segments that cross overlap, and those on one line only where they meet") {
  const auto a = shape<double>({{-1, 0}, {1, 0}});
  CHECK(gjk(a, shape<double>({{0, -1}, {0, 1}})).apartness == Apartness::overlapping);
  CHECK(gjk(a, shape<double>({{0.5, 0}, {3, 0}})).apartness == Apartness::overlapping);
  const GjkResult found = gjk(a, shape<double>({{4, 0}, {1.5, 0}}));
  CHECK(found.apartness == Apartness::apart);
  CHECK(found.direction == Vector2<double>(0.5, 0));
}

TEST_CASE("what is left as a hint needs one support where nothing moved") {
  for (const auto& b : {box_at(5, 0.5), box_at(5, 6)}) {
    const GjkResult found = gjk(kBox, b);
    const GjkResult again = gjk(kBox, b, found.simplex);
    CHECK(again.iterations == 1);
    CHECK(again.simplex == found.simplex);
  }
  const auto b = box_at(1, 1);
  CHECK(gjk(kBox, b, gjk(kBox, b).simplex).iterations == 0);
}

TEST_CASE("a hint of other shapes' vertices is no hint") {
  const Simplex bad{{{{7, 0}, {0, 7}, {3, 3}}}, 3};
  CHECK(gjk(kBox, box_at(5, 6), bad).direction == Vector2<double>(3, 4));
  CHECK(gjk(kBox, box_at(5, 6), Simplex{{}, 200}).direction == Vector2<double>(3, 4));
}

TEST_CASE("the last direction tells that cores are still apart, and not that they touch") {
  const auto spike = shape<double>({{-1, 0}, {1, -1}, {1, 1}});
  const Simplex face = gjk(kBox, transform<double>({{5, 0.5}, {1, 0}}, spike)).simplex;
  CHECK(is_face(kBox, spike, face));
  CHECK(separates<double>(face, kBox, spike, {{2.5, 0.5}, {1, 0}}, 0.4));
  CHECK_FALSE(separates<double>(face, kBox, spike, {{2.5, 0.5}, {1, 0}}, 0.6));
  CHECK_FALSE(separates<double>(face, kBox, spike, {{1.5, 0.5}, {1, 0}}, 0.0));
  CHECK(separates<double>(face, kBox, spike, {{2.5, 0.5}, {0, 1}}, 0.4));
  const Simplex corner = gjk(kBox, box_at(5, 6)).simplex;
  CHECK_FALSE(is_face(kBox, kBox, corner));
  CHECK(separates<double>(corner, kBox, kBox, {{5, 6}, {1, 0}}, 4.9));
  CHECK_FALSE(separates<double>(corner, kBox, kBox, {{5, 6}, {1, 0}}, 5.1));
  CHECK_FALSE(separates<double>({}, kBox, kBox, {{5, 6}, {1, 0}}, 0.0));
}

TEST_CASE("any hint leads to the same distance") {
  const bool holds = rc::check([] {
    const PairCase pair = test::any_pair(regimes());
    const auto placed = clipping::placed_pair<double>(pair);
    const auto b = transform(relative_pose(placed.pose_a, placed.pose_b), placed.b);
    Simplex hint{{}, *rc::gen::inRange(0, 4)};
    for (SupportPair& p : hint.vertices) {
      p = {*rc::gen::inRange<unsigned char>(0, 8), *rc::gen::inRange<unsigned char>(0, 8)};
    }
    const GjkResult fresh = gjk(placed.a, b);
    const GjkResult hinted = gjk(placed.a, b, hint);
    const double off = 0x1p-48 * extent(pair);
    const auto apart = [&](const GjkResult& found) {
      return found.apartness == Apartness::overlapping ? 0 : distance(found, placed.a, b);
    };
    RC_ASSERT(std::abs(apart(fresh) - apart(hinted)) <= off);
  });
  CHECK(holds);
}
