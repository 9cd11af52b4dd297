#include "methods/closest_points.hpp"

#include <catch2/catch.hpp>

#include "unit/methods/placed.hpp"

using namespace manifuzz;
using namespace manifuzz::methods;
using test::box_at;
using test::shape;

namespace {

double depth_of(const Manifold<float>& manifold) {
  return manifold.count > 0 ? static_cast<double>(manifold.points[0].depth) : 0;
}

PointContact<float> contact(const PairCase& pair, Simplex& hint) {
  return contact_by_gjk(pair.a.polygon, pair.b.polygon, relative_pose(pair.a.pose, pair.b.pose),
                        hint);
}

}  // namespace

TEST_CASE("circles touch along the line between their centers") {
  const auto a = shape<double>({{0, 0}}, 3);
  Simplex hint;
  const auto found = contact_by_gjk(a, shape<double>({{3, 4}}, 2.5), hint);
  CHECK(found.manifold.normal == Vector2<double>(0.6, 0.8));
  CHECK(found.manifold.points[0].depth == 0.5);
  CHECK(found.manifold.points[0].position.x() == Approx(1.8));
  CHECK(found.manifold.points[0].position.y() == Approx(2.4));
  CHECK(found.epa_iterations == 0);
}

TEST_CASE("mitred skins touch at faces, and past corners no farther than they reach") {
  const double r = 0.5;
  const auto a = shape<double>({{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}, r);
  const auto touching = [&](double x, double y) {
    const auto b = shape<double>({{x, y}, {x + 2, y}, {x + 2, y + 2}, {x, y + 2}}, r);
    Simplex hint;
    return contact_by_gjk(a, b, hint).manifold;
  };
  CHECK(touching(1.5, 0).points[0].depth == 0.5);
  CHECK(touching(1.5, 1.75).count == 1);
  CHECK(touching(1.5, 1.75).points[0].depth == 0.25);
  CHECK(touching(1.5, 2.5).count == 0);
  CHECK(touching(2.5, 0).count == 0);
}

TEST_CASE("cases that rounding decided wrongly once are right") {
  struct Row {
    const char* regime;
    std::uint64_t seed;
    std::uint64_t index;
  };
  const Row row = GENERATE(
      Row{"deep", 102, 64164}, Row{"cores_touch", 102, 115942}, Row{"cores_touch", 102, 112353},
      Row{"micro_edge", 77, 9753}, Row{"micro_edge", 77, 23712}, Row{"large_radii", 77, 69588},
      Row{"large_radii", 77, 93836}, Row{"near_collinear", 1, 2204}, Row{"tied_faces", 1, 673},
      Row{"tied_faces", 1, 4346}, Row{"side_planes", 1, 9947}, Row{"cores_touch", 1, 2144},
      Row{"tied_faces", 1001, 919412}, Row{"tied_faces", 1001, 3197861},
      Row{"off_unit", 1001, 947958}, Row{"side_planes", 1001, 2122216},
      Row{"side_planes", 1001, 1978692});
  CAPTURE(row.regime, row.index);
  const PairCase pair = generate(row.seed, *find_regime(row.regime), row.index);
  CHECK(test::is_right(pair, make_gjk()));
  CHECK(test::is_right(pair, make_gjk64()));
  if (!is_round(pair)) CHECK(test::is_right(pair, make_gjk_clip()));
}

TEST_CASE("any hint leads to the same depth, within bound") {
  const bool holds = rc::check([] {
    const PairCase pair = test::any_pair(regimes());
    const auto within = test::separation_bound(pair);
    if (!within) RC_DISCARD("floats cannot say");
    Simplex none;
    Simplex hint{{}, *rc::gen::inRange(0, 4)};
    for (SupportPair& p : hint.vertices) {
      p = {*rc::gen::inRange<unsigned char>(0, 8), *rc::gen::inRange<unsigned char>(0, 8)};
    }
    const auto fresh = contact(pair, none).manifold;
    const auto hinted = contact(pair, hint).manifold;
    // Where mitred skins end, either may find no place.
    if (!is_round(pair) && fresh.count != hinted.count) return;
    RC_ASSERT(std::abs(depth_of(fresh) - depth_of(hinted)) <= 2 * *within);
  });
  CHECK(holds);
}

TEST_CASE("from step to step of a moving pair the hint changes no depth, within bound") {
  const bool holds = rc::check([] {
    PairCase pair = test::any_pair(regimes());
    const auto from = pair.b.pose.position;
    const float length = static_cast<float>(size(pair));
    Simplex hint;
    for (int step = -8; step < 8; ++step) {
      pair.b.pose.position = from + Vector2<float>(length * static_cast<float>(step) / 8, 0);
      const auto within = test::separation_bound(pair);
      if (!within) RC_DISCARD("floats cannot say");
      Simplex none;
      const auto fresh = contact(pair, none).manifold;
      const auto hinted = contact(pair, hint).manifold;
      if (!is_round(pair) && fresh.count != hinted.count) continue;
      RC_ASSERT(std::abs(depth_of(fresh) - depth_of(hinted)) <= 2 * *within);
    }
  });
  CHECK(holds);
}

TEST_CASE("where sharp polygons overlap, the depth is that of clipping, within bound") {
  const bool holds = rc::check([] {
    PairCase pair = test::any_pair(polygon_regimes());
    pair.a.polygon.radius = 0;
    pair.b.polygon.radius = 0;
    const auto within = test::separation_bound(pair);
    if (!within) RC_DISCARD("floats cannot say");
    Simplex hint;
    const double depth = depth_of(contact(pair, hint).manifold);
    const auto clipped = std::get<Manifold<double>>(make_clip64().collide(pair));
    double deepest = 0;
    for (int i = 0; i < clipped.count; ++i) {
      deepest = std::max(deepest, clipped.points[i].depth);
    }
    RC_ASSERT(std::abs(depth - deepest) <= 2 * *within);
  });
  CHECK(holds);
}

TEST_CASE("a hint loses no contact where the square of its edge underflows") {
  const auto capsule = shape<float>({{0, 0}, {2.6e-23F, 0}}, 100);
  const auto circle = shape<float>({{0, 0}}, 1);
  const Pose<float> pose{{1.3e-23F, 50}, {1, 0}};
  Simplex hint;
  for (int step = 0; step < 3; ++step) {
    CHECK(depth_of(contact_by_gjk(capsule, circle, pose, hint).manifold) == 51);
  }
}

TEST_CASE("a place at a face is off by how much less deep it is, or how far past the ends") {
  const auto box = shape<double>({{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}, 0);
  const auto off = [&](const ConvexPolygon<double>& other, double margin = 0) {
    return least_off_at_face(box, clipping::face_separation(box, 2, other), other, margin);
  };
  const auto before = off(shape<double>({{0.5, 0.5}, {4, 4}, {-4, 4}}, 0));
  CHECK(before.off == 0);
  CHECK(before.place.of_other == clipping::vertex(0));
  const auto past = off(shape<double>({{1.25, 0.5}, {4, 4}, {0.75, 4}}, 0));
  CHECK(past.off == 0.25);
  CHECK(past.place.of_other == clipping::vertex(0));
  CHECK(off(shape<double>({{1.25, 0.5}, {4, 4}, {0.75, 4}}, 0), 0.25).off == 0);
  const auto far = off(shape<double>({{-5, 0.5}, {3, 0.75}, {0, 5}}, 0));
  CHECK(far.off == 0.125);
  CHECK(far.place.of_other == clipping::face(0));
  CHECK(far.place.position == Vector2<double>(-1, 0.625));
}
