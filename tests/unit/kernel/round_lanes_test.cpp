#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "clipping/collide.hpp"
#include "generating/regime.hpp"
#include "kernel/batch.hpp"
#include "kernel/pair_stream.hpp"
#include "own_colliders/own_colliders.hpp"
#include "unit/kernel/every_target.hpp"

// Round shapes in lanes, where a guard decides that hardly any random case reaches: without the
// guard that a test is about, its cases differ from the clean code's.

using namespace manifuzz;
using manifuzz::test::on_every_target;

namespace {

/// A case of a regime, both of its shapes given round corners.
struct Drawn {
  const char* regime;
  std::uint64_t seed;
  std::uint64_t index;
};

template <class Scalar>
ConvexPolygon<Scalar> rounded(const ConvexPolygon<Scalar>& shape, Scalar radius) {
  return make_polygon<Scalar>(shape.corners(), radius, Rounding::round);
}

template <class Scalar>
void check(const std::vector<clipping::PlacedPair<Scalar>>& placed, Scalar tie_bias) {
  kernel::Shapes<Scalar> shapes;
  std::vector<kernel::Placement<Scalar>> bodies;
  std::vector<kernel::BodyPair> pairs;
  for (const auto& pair : placed) {
    const auto first = static_cast<std::uint32_t>(bodies.size());
    bodies.push_back({shapes.add(pair.a), pair.pose_a});
    bodies.push_back({shapes.add(pair.b), pair.pose_b});
    pairs.push_back({first, first + 1});
  }
  on_every_target([&] {
    std::vector<Manifold<Scalar>> manifolds(pairs.size());
    kernel::collide_pairs(shapes, bodies, pairs, tie_bias, manifolds);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      INFO("case " << i);
      const auto b_in_a = relative_pose(placed[i].pose_a, placed[i].pose_b);
      const auto expected = clipping::collide(placed[i].a, placed[i].b, b_in_a, tie_bias);
      CHECK(expected.count > 0);
      CHECK(manifolds[i] == expected);
    }
  });
}

/// With this radius for both shapes, or with what each has.
template <class Scalar>
void check_drawn(const std::vector<Drawn>& drawn, Scalar tie_bias = 0, Scalar radius = 0) {
  std::vector<clipping::PlacedPair<Scalar>> placed;
  for (const auto& [regime, seed, index] : drawn) {
    auto pair = clipping::placed_pair<Scalar>(generate(seed, *find_regime(regime), index));
    pair.a = rounded(pair.a, radius > 0 ? radius : pair.a.radius);
    pair.b = rounded(pair.b, radius > 0 ? radius : pair.b.radius);
    placed.push_back(pair);
  }
  check(placed, tie_bias);
}

/// A box, and a sliver whose tip points at it: so thin, and so far from its own origin, that once
/// turned both of its long edges face away from the box.
clipping::PlacedPair<float> sliver_on_box(const Vector2<float>& position, float radius) {
  const std::vector<Vector2<float>> box{{-0x1.252bbp+15F, 0x1.34395p+15F},
                                        {-0x1.a67b44p+15F, -0x1.8cd14ap+12F},
                                        {-0x1.029f28p+13F, -0x1.65d37ap+14F},
                                        {0x1.029f28p+13F, 0x1.65d37ap+14F}};
  const std::vector<Vector2<float>> sliver{{0x1.000a1p+23F, 0x1.9aa4p+22F},
                                           {0x1.003b5ep+23F, 0x1.9ad624p+22F},
                                           {0x1.003ae8p+23F, 0x1.9ad5acp+22F}};
  return {make_polygon<float>(box, radius, Rounding::round),
          make_polygon<float>(sliver, radius, Rounding::round),
          {{0, 0}, {1, 0}},
          {position, {0x1.5e59c6p-1F, -0x1.755c68p-1F}}};
}

}  // namespace

TEST_CASE("a normal is rounded as if divided, where the reciprocal's roundings would show") {
  const Vector2<float> apart[] = {{0x1.a4a838p+1F, 0x1.000e8cp+0F},
                                  {0x1.d2c36ap+1F, 0x1.fe8108p+1F},
                                  {0x1.bbdefp-2F, 0x1.12d1bcp+1F},
                                  {0x1.d91eeap+1F, 0x1.05b2dp+1F},
                                  {0x1.31ab58p-1F, 0x1.76a848p+0F}};
  const std::vector<Vector2<float>> centre{{0, 0}};
  const auto circle = make_polygon<float>(centre, 4, Rounding::round);
  std::vector<clipping::PlacedPair<float>> placed;
  for (const Vector2<float>& v : apart) {
    placed.push_back({circle, circle, {{0, 0}, {1, 0}}, {v, {1, 0}}});
  }
  check<float>(placed, 0);
}

TEST_CASE("an edge that faces away from the nearest place gives no second point") {
  check<float>(
      {sliver_on_box({-10636710, 1517561}, 16384), sliver_on_box({-10643484, 1515942.5F}, 16384),
       sliver_on_box({-10643952, 1519809.125F}, 16384)},
      0);
}

TEST_CASE("an edge that faces away from a face that it is behind gives no second point") {
  check<float>(
      {sliver_on_box({-0x1.44e2fp+23F, 0x1.7296aap+20F}, 0x1.2aca02p+12F),
       sliver_on_box({-10645589, 1518727.5F}, 16384), sliver_on_box({-10646796, 1515378}, 16384)},
      0);
}

TEST_CASE("a reference edge that runs no farther than rounding gives no second point") {
  check_drawn<float>({{"micro_edge", 11, 5380}});
}

TEST_CASE("a crossing's depth is told from the end of the reference edge, without its slope") {
  check_drawn<float>({{"micro_edge", 5, 736},
                      {"micro_edge", 11, 675},
                      {"large_radii", 5, 1552},
                      {"near_parallel", 11, 755}});
  check_drawn<double>({{"micro_edge", 5, 736},
                       {"micro_edge", 11, 1156},
                       {"large_radii", 5, 1552},
                       {"tie_bias", 11, 3185}});
}

TEST_CASE("a nearest face gives itself, though the face before it looks as flat") {
  check_drawn<float>({{"near_collinear", 5, 671},
                      {"near_collinear", 11, 1357},
                      {"sliver", 5, 112},
                      {"tied_faces", 11, 324}});
  check_drawn<double>(
      {{"near_collinear", 5, 837}, {"near_collinear", 11, 720}, {"near_collinear", 11, 4235}});
}

TEST_CASE("cores whose overlap is lost in large radii and whose clip is empty have a contact") {
  check_drawn<float>({{"sliver", 5, 2014}, {"sliver", 5, 2186}}, 0, 10'000);
  check_drawn<float>({{"tie_bias", 5, 7}, {"tie_bias", 5, 11}, {"corner_corner", 5, 371}}, 0.0005F,
                     10'000);
}

TEST_CASE("cores whose clip is shallower than their overlap have the deepest contact") {
  check_drawn<float>({{"near_collinear", 11, 1158},
                      {"sliver", 5, 1431},
                      {"sliver", 11, 121},
                      {"tied_faces", 5, 2292}});
  check_drawn<double>(
      {{"near_collinear", 11, 960}, {"near_collinear", 11, 1158}, {"ulp", 11, 5230}});
}
