#include <catch2/catch.hpp>

#include "geometry/pair_case.hpp"

using namespace manifuzz;

namespace {

constexpr Feature face(unsigned char index) {
  return {Feature::Kind::face, index};
}

constexpr Feature vertex(unsigned char index) {
  return {Feature::Kind::vertex, index};
}

/// Two points under A's bottom face.
Manifold<float> two_points() {
  Manifold<float> m;
  m.count = 2;
  m.reference = Side::a;
  m.normal = {0, -1};
  m.points[0] = {{-1, -0.75F}, 0.25F, {face(0), vertex(2)}};
  m.points[1] = {{1, -0.5F}, 0.5F, {vertex(1), face(2)}};
  return m;
}

PairCase pair_at(const Pose<float>& a) {
  PairCase pair;
  pair.a.pose = a;
  return pair;
}

}  // namespace

TEST_CASE("manifolds differ by each of their parts") {
  const Manifold<float> m = two_points();
  CHECK(m == two_points());
  const auto differs = [&m](auto change) {
    Manifold<float> other = m;
    change(other);
    return !(other == m);
  };
  CHECK(differs([](auto& o) { o.count = 1; }));
  CHECK(differs([](auto& o) { o.reference = Side::b; }));
  CHECK(differs([](auto& o) { o.normal.x() = 0.5F; }));
  CHECK(differs([](auto& o) { o.points[0].position.x() = -2; }));
  CHECK(differs([](auto& o) { o.points[1].position.y() = 7; }));
  CHECK(differs([](auto& o) { o.points[0].depth = 1; }));
  CHECK(differs([](auto& o) { o.points[1].features.a = face(1); }));
  CHECK(differs([](auto& o) { o.points[1].features.b = face(3); }));
}

TEST_CASE("what is not there is not compared") {
  Manifold<float> none;
  Manifold<float> also_none = two_points();
  also_none.count = 0;
  CHECK(none == also_none);
  CHECK_FALSE(none == two_points());
  Manifold<float> one = two_points();
  one.count = 1;
  Manifold<float> also_one = one;
  also_one.points[1].depth = 9;
  CHECK(one == also_one);
}

TEST_CASE("a cast to double and back keeps everything") {
  const Manifold<double> wide = manifold_cast<double>(two_points());
  CHECK(wide.count == 2);
  CHECK(wide.points[1].depth == 0.5);
  CHECK(wide.points[1].position == Vector2<double>(1, -0.5));
  CHECK(wide.points[1].features == FeaturePair{vertex(1), face(2)});
  CHECK(manifold_cast<float>(wide) == two_points());
}

TEST_CASE("points are ordered along the reference face") {
  // A's bottom face runs towards +x; B's face above A has the normal (0, -1) turned, runs towards
  // -x.
  Manifold<float> m = two_points();
  order_points(m);
  CHECK(m == two_points());
  std::swap(m.points[0], m.points[1]);
  order_points(m);
  CHECK(m == two_points());
  m.reference = Side::b;
  order_points(m);
  CHECK(m.points[0] == two_points().points[1]);
  CHECK(m.points[1] == two_points().points[0]);
  m.count = 1;
  m.reference = Side::a;
  order_points(m);
  CHECK(m.points[0] == two_points().points[1]);
}

TEST_CASE("a local point of A in the world, and back") {
  const Pose<float> quarter{{10, 20}, {0, 1}};
  CHECK(to_world(pair_at(quarter), {1, 0}) == Vector2<double>(10, 21));
  CHECK(to_local(quarter, {10, 21}) == Vector2<double>(1, 0));
  const Pose<float> not_quite_unit{{-3, 7}, {0.6F, 0.800003F}};
  const Vector2<double> local(1.5, -2.25);
  const Vector2<double> world = to_world(pair_at(not_quite_unit), local);
  CHECK((to_local(not_quite_unit, world) - local).norm() < 1e-14);
}

TEST_CASE("a normal in the world is unit, whatever the rotation's length") {
  const Pose<float> quarter{{10, 20}, {0, 1}};
  CHECK(world_normal(pair_at(quarter), {1, 0}) == Vector2<double>(0, 1));
  const Pose<float> not_quite_unit{{-3, 7}, {0.6F, 0.800003F}};
  const Vector2<double> normal = world_normal(pair_at(not_quite_unit), {0, 1});
  CHECK(std::abs(normal.norm() - 1) < 1e-15);
  CHECK(normal.x() == Approx(-0.8));
  CHECK(normal.y() == Approx(0.6));
}
