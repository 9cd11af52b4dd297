#include "methods/cached_as_bullet.hpp"

#include <catch2/catch.hpp>

#include "unit/methods/kept.hpp"
#include "unit/methods/placed.hpp"

using namespace manifuzz;
using namespace manifuzz::methods;
using test::below_top;
using test::ids;
using test::Kept;
using test::KeptAsBullet;

namespace {

const Pose<double> kThere{};

using Numbers = std::vector<int>;

}  // namespace

TEST_CASE("the threshold is a fiftieth of the smaller disc about a body's own origin") {
  // Its box is 4 by 2 around (3, 4): half a diagonal, and the distance of the middle.
  const auto a = test::shape<double>({{1, 3}, {5, 3}, {5, 5}, {1, 5}}, 0.5);
  const auto b = test::shape<double>({{-20, 0}, {20, 0}, {0, 40}});
  CHECK(bullet_threshold(a, b) == Approx(0.02 * (std::hypot(2.5, 1.5) + 5)));
  CHECK(bullet_threshold(b, a) == bullet_threshold(a, b));
}

TEST_CASE("by Bullet's rules a new point takes the place of one that is near on A, not on B") {
  KeptAsBullet kept;
  kept.frame(kThere, below_top(0, 0.5));
  kept.frame({{0.2, 0}, {1, 0}}, below_top(0.2, 0.5));
  CHECK(ids(kept) == Numbers{0});
  // B's corner is where it was, A's place has moved on: Bullet has another point, and keeps both.
  kept.frame({{0.2, 0}, {1, 0}}, below_top(0, 0.5));
  kept.frame({{0.445, 0}, {1, 0}}, below_top(0.445, 0.5));
  CHECK(ids(kept) == Numbers{0, 1});
}

TEST_CASE("by Bullet's rules the first slot goes where all areas are 0, be it the deepest") {
  KeptAsBullet bullet;
  Kept right;
  const double depths[] = {0.5, 0.25, 0.25, 0.25, 0.25};
  for (int i = 0; i < 5; ++i) {
    bullet.frame(kThere, below_top(i, depths[i]));
    right.frame(kThere, below_top(i, depths[i]));
  }
  CHECK(ids(bullet) == Numbers{4, 1, 2, 3});
  CHECK(ids(right) == Numbers{0, 4});
}

TEST_CASE("by Bullet's rules the slot goes that leaves the largest area, but not the deepest") {
  for (const double depth : {0.5, 0.75}) {
    KeptAsBullet kept;
    const auto add = [&](double x, double y, double deep) {
      kept.frame(kThere, DetectedPoint<double>{{0, 1}, {x, y}, {x, y - deep}, Side::a});
    };
    add(0, 0, 0.5);
    add(1, 1, depth);  // without it the area is largest
    add(4, 0, 0.5);
    add(0, 4, 0.5);
    add(4, 4, 0.5);
    CHECK(ids(kept) == (depth == 0.5 ? Numbers{0, 4, 2, 3} : Numbers{4, 1, 2, 3}));
  }
}

TEST_CASE("by Bullet's rules the last point takes the slot of one that is dropped") {
  KeptAsBullet kept;
  kept.frame(kThere, below_top(0, 0));
  kept.frame(kThere, below_top(1, 0.5));
  kept.frame(kThere, below_top(2, 0.5));
  kept.frame({{0, 0.375}, {1, 0}}, {});
  CHECK(ids(kept) == Numbers{2, 1});
  CHECK(kept.cache.points[0].depth == 0.125);
}

TEST_CASE("by Bullet's rules a gap beyond the threshold is not even added") {
  KeptAsBullet kept;
  kept.frame(kThere, below_top(0, -0.25));
  CHECK(ids(kept) == Numbers{0});
  KeptAsBullet none;
  none.frame(kThere, below_top(0, -0.2500001));
  CHECK(ids(none).empty());
}

TEST_CASE(
    "turning both bodies by a quarter changes nothing of what is kept, but by Bullet's rules") {
  Kept right;
  KeptAsBullet bullet;
  right.frame(kThere, below_top(0, 0.5));
  bullet.frame(kThere, below_top(0, 0.5));
  right.frame(kThere, {});  // in A's frame nothing has moved
  bullet.frame(kThere, {}, {0, 1});
  CHECK(ids(right) == Numbers{0});
  CHECK(ids(bullet).empty());
}

TEST_CASE("by Bullet's rules a depth is too small by the cosine of how far both have turned") {
  KeptAsBullet kept;
  kept.frame(kThere, below_top(0, 0.25));
  kept.frame(kThere, {}, {0.8, 0.6});
  CHECK(kept.cache.points[0].depth == Approx(0.2));
}
