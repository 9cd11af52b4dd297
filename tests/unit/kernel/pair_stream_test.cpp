#include "kernel/pair_stream.hpp"

#include <catch2/catch.hpp>

#include "unit/kernel/every_target.hpp"
#include "unit/kernel/pairs_scene.hpp"

// Pairs on their way to the kernel for many: which share a batch changes no manifold.

using namespace manifuzz;
using namespace manifuzz::test;

namespace {

/// Every pair's A, B or both are given the first one's shape.
template <class Scalar>
void check_shared(const std::vector<int>& sides) {
  Scene<Scalar> scene = scene_of<Scalar>(*find_regime("generic"));
  for (std::size_t i = 0; i < scene.pairs.size(); ++i) {
    for (const int side : sides) {
      scene.polygons[2 * i + side] = scene.polygons[side];
      scene.bodies[2 * i + side].shape = scene.bodies[side].shape;
    }
  }
  scene.expect(0);
  on_every_target([&] { CHECK(wrong_from_indices(scene, Scalar{0}) == 0); });
}

}  // namespace

TEST_CASE("pairs that share a shape on either side are answered as others") {
  for (const auto& sides : std::vector<std::vector<int>>{{0}, {1}, {0, 1}}) {
    INFO("sides from " << sides.front() << " to " << sides.back());
    check_shared<float>(sides);
    check_shared<double>(sides);
  }
}

namespace {

/// Pairs that touched, or are said to have, share batches with their like.
template <class Scalar>
void check_again(Scalar tie_bias) {
  const Regime regimes[] = {*find_regime("generic"), *find_regime("mixed_shapes")};
  Scene<Scalar> scene = scene_of<Scalar>(regimes);
  scene.expect(tie_bias);
  on_every_target([&] {
    std::vector<Manifold<Scalar>> manifolds(scene.pairs.size());
    const auto wrong = [&] {
      kernel::collide_pairs_again(scene.shapes, scene.bodies, scene.pairs, tie_bias, manifolds);
      return wrong_among(scene, manifolds);
    };
    CHECK(wrong() == 0);  // none is known to touch
    CHECK(wrong() == 0);
    for (std::size_t i = 0; i < manifolds.size(); ++i) manifolds[i].count = i % 3 == 0 ? 2 : 0;
    CHECK(wrong() == 0);
  });
}

}  // namespace

TEST_CASE("pairs are answered again whatever is known of who touched") {
  check_again<float>(0);
  check_again<double>(0);
  check_again<float>(0.0005F);
}

namespace {

/// A few or many before each finish.
template <bool kIsTold>
void check_pushed() {
  Scene<float> scene = scene_of<float>(*find_regime("generic"));
  scene.expect(0);
  on_every_target([&] {
    kernel::PairStream<float, kIsTold> stream(scene.shapes, scene.bodies, 0.0F);
    std::size_t next = 0;
    std::size_t wrong = 0;
    for (const std::size_t count : {0, 1, 0, 5, 400, 597}) {
      std::vector<Manifold<float>> manifolds(count);
      for (std::size_t i = 0; i < count; ++i) {
        stream.push(scene.pairs[next + i], manifolds[i], kIsTold && i % 3 == 0);
      }
      stream.finish();
      for (std::size_t i = 0; i < count; ++i) wrong += manifolds[i] != scene.expected[next + i];
      next += count;
    }
    CHECK(next == scene.pairs.size());
    CHECK(wrong == 0);
  });
}

}  // namespace

TEST_CASE("pairs are answered as they are pushed, a few or many before each finish") {
  check_pushed<false>();
  check_pushed<true>();
}
