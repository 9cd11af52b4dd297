#include <cmath>

#include <catch2/catch.hpp>

#include "exchange/json.hpp"

using namespace manifuzz;

namespace {

/// A stands turned, away from the origin, and not quite unit.
PairCase roughly_turned_pair() {
  PairCase pair;
  pair.a.pose = {{3, -2}, {0.600003F, 0.800003F}};
  return pair;
}

const Vector2<double> kNormal{0.6, -0.8};

/// Two points in the contract's order for A as the reference.
Manifold<double> manifold_in_order() {
  Manifold<double> manifold;
  manifold.count = 2;
  manifold.normal = kNormal;
  manifold.points[0] = {{0.1, 0.2}, 0.3, {{Feature::Kind::face, 1}, {Feature::Kind::vertex, 0}}};
  manifold.points[1] = {{0.9, 0.8}, 0.1, {{Feature::Kind::vertex, 2}, {Feature::Kind::face, 3}}};
  return manifold;
}

/// The sample with all that there is, in the world.
ReportedManifold reported_in_world(const PairCase& pair) {
  const Manifold<double> sample = manifold_in_order();
  ReportedManifold reported{
      .count = 2, .normal = world_normal(pair, sample.normal), .reference = Side::a};
  for (int i = 0; i < 2; ++i) {
    reported.points[i] = {.world = to_world(pair, sample.points[i].position),
                          .depth = sample.points[i].depth,
                          .features = sample.points[i].features};
  }
  return reported;
}

bool is_near_sample(const Manifold<double>& manifold) {
  const Manifold<double> sample = manifold_in_order();
  double off = (manifold.normal - sample.normal).norm();
  for (int i = 0; i < 2; ++i) {
    off = std::max(off, (manifold.points[i].position - sample.points[i].position).norm());
    if (manifold.points[i].depth != sample.points[i].depth) return false;
    if (!(manifold.points[i].features == sample.points[i].features)) return false;
  }
  return manifold.count == 2 && manifold.reference == sample.reference && off < 1e-15;
}

}  // namespace

TEST_CASE("A manifold of the world is brought into A's frame") {
  const PairCase pair = roughly_turned_pair();
  const PartialManifold partial = in_frame_of_a(reported_in_world(pair), {}, pair);
  CHECK(is_near_sample(partial.manifold));
  CHECK(partial.names_reference);
  CHECK(partial.names_features);
  CHECK_FALSE(partial.has_midpoints);
}

TEST_CASE("A local position counts more than one of the world") {
  const PairCase pair = roughly_turned_pair();
  ReportedManifold reported = reported_in_world(pair);
  reported.points[0].local = {7, 8};
  CHECK(in_frame_of_a(reported, {.is_ordered = true}, pair).manifold.points[0].position ==
        Vector2<double>(7, 8));
}

TEST_CASE("What is declared of a normal is undone, and points are put in order by it") {
  const PairCase pair = roughly_turned_pair();
  ReportedManifold reported = reported_in_world(pair);
  reported.normal = -reported.normal;
  CHECK(is_near_sample(in_frame_of_a(reported, {.normal_from_b = true}, pair).manifold));
  reported.normal = kNormal;
  std::swap(reported.points[0], reported.points[1]);
  CHECK(is_near_sample(in_frame_of_a(reported, {.normal_in_a = true}, pair).manifold));
  reported.normal = -kNormal;
  const Conventions both{.normal_from_b = true, .normal_in_a = true};
  CHECK(is_near_sample(in_frame_of_a(reported, both, pair).manifold));
}

TEST_CASE("Points that are declared in order stay in theirs") {
  const PairCase pair = roughly_turned_pair();
  ReportedManifold reported = reported_in_world(pair);
  std::swap(reported.points[0], reported.points[1]);
  const auto manifold = in_frame_of_a(reported, {.is_ordered = true}, pair).manifold;
  CHECK(manifold.points[0].depth == manifold_in_order().points[1].depth);
}

TEST_CASE("What is not given stays open") {
  const PairCase pair = roughly_turned_pair();
  ReportedManifold reported = reported_in_world(pair);
  reported.reference.reset();
  reported.points[1].features.reset();
  const PartialManifold partial = in_frame_of_a(reported, {.has_midpoints = true}, pair);
  CHECK_FALSE(partial.names_reference);
  CHECK_FALSE(partial.names_features);
  CHECK(partial.has_midpoints);
  CHECK(in_frame_of_a({}, {}, pair).manifold.count == 0);
}
