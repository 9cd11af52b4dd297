#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "clipping/collide.hpp"
#include "generating/regime.hpp"
#include "kernel/batch.hpp"
#include "own_colliders/own_colliders.hpp"

// Scenes of pairs for the kernels, and how many of their answers are wrong.

namespace manifuzz::test {

inline constexpr std::size_t kPairs = 1003;  // no whole number of blocks

/// Pairs as an engine holds them, and what the clean code makes of each.
template <class Scalar>
struct Scene {
  std::vector<ConvexPolygon<Scalar>> polygons;
  kernel::Shapes<Scalar> shapes;
  std::vector<kernel::Placement<Scalar>> bodies;
  std::vector<kernel::BodyPair> pairs;
  std::vector<Manifold<Scalar>> expected;

  void add(const ConvexPolygon<Scalar>& polygon, const Pose<Scalar>& pose) {
    polygons.push_back(polygon);
    bodies.push_back({shapes.add(polygon), pose});
  }

  void expect(Scalar tie_bias) {
    expected.clear();
    for (const auto& [a, b] : pairs) {
      expected.push_back(clipping::collide(
          polygons[a], polygons[b], relative_pose(bodies[a].pose, bodies[b].pose), tie_bias));
    }
  }
};

/// Pairs of these regimes in turn.
template <class Scalar>
Scene<Scalar> scene_of(std::span<const Regime> regimes) {
  Scene<Scalar> scene;
  for (std::uint32_t i = 0; i < kPairs; ++i) {
    const auto placed = clipping::placed_pair<Scalar>(generate(5, regimes[i % regimes.size()], i));
    scene.add(placed.a, placed.pose_a);
    scene.add(placed.b, placed.pose_b);
    scene.pairs.push_back({2 * i, 2 * i + 1});
  }
  return scene;
}

template <class Scalar>
Scene<Scalar> scene_of(const Regime& regime) {
  return scene_of<Scalar>(std::span(&regime, 1));
}

template <class Scalar>
std::size_t wrong_among(const Scene<Scalar>& scene, const std::vector<Manifold<Scalar>>& said) {
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < said.size(); ++i) wrong += said[i] != scene.expected[i];
  return wrong;
}

template <class Scalar>
std::size_t wrong_from_indices(const Scene<Scalar>& scene, Scalar tie_bias) {
  std::vector<Manifold<Scalar>> manifolds(scene.pairs.size());
  kernel::collide_pairs(scene.shapes, scene.bodies, scene.pairs, tie_bias, manifolds);
  return wrong_among(scene, manifolds);
}

}  // namespace manifuzz::test
