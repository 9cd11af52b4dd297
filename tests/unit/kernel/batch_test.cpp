#include "kernel/batch.hpp"

#include <cmath>
#include <string>

#include <catch2/catch.hpp>

#include "clipping/collide.hpp"
#include "unit/kernel/every_target.hpp"
#include "unit/kernel/pairs_scene.hpp"

// The kernels against the clean code, bit for bit, on every instruction set that this machine has.

using namespace manifuzz;
using namespace manifuzz::test;

namespace {

template <class Scalar>
std::size_t wrong_packed(const Scene<Scalar>& scene, Scalar tie_bias) {
  const kernel::PackedPairs<Scalar> packed(scene.shapes, scene.bodies, scene.pairs);
  std::vector<kernel::ManifoldBlock<Scalar>> blocks(packed.block_count());
  kernel::collide_packed(packed, tie_bias, blocks);
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < scene.pairs.size(); ++i) {
    const auto column = static_cast<int>(i % kernel::kBlockPairs);
    wrong += kernel::manifold(blocks[i / kernel::kBlockPairs], column) != scene.expected[i];
  }
  return wrong;
}

template <class Scalar>
void check_scene(Scene<Scalar> scene) {
  for (const Scalar tie_bias : {Scalar{0}, Scalar{0.0005F}}) {
    scene.expect(tie_bias);
    INFO("tie bias " << tie_bias);
    on_every_target([&] {
      CHECK(wrong_from_indices(scene, tie_bias) == 0);
      CHECK(wrong_packed(scene, tie_bias) == 0);
    });
  }
}

template <class Scalar>
void check_regimes() {
  for (const auto& regimes : {polygon_regimes(), round_regimes()}) {
    for (const Regime& regime : regimes) {
      INFO(regime.name);
      check_scene(scene_of<Scalar>(regime));
    }
  }
}

}  // namespace

TEST_CASE("batch equals clip bit for bit on every target, in every regime") {
  check_regimes<float>();
}

TEST_CASE("batch64 equals clip64 bit for bit on every target, in every regime") {
  check_regimes<double>();
}

TEST_CASE("shapes of every kind in one scene are answered as alone") {
  std::vector<Regime> regimes{*find_regime("generic")};
  regimes.insert(regimes.end(), round_regimes().begin(), round_regimes().end());
  check_scene(scene_of<float>(regimes));
  check_scene(scene_of<double>(regimes));
}

TEST_CASE("round shapes are answered where none of a scene has a radius") {
  Scene<float> scene;
  const Regime& regime = *find_regime("capsules");
  for (std::uint64_t i = 0; scene.pairs.size() < 100; ++i) {
    const auto placed = clipping::placed_pair<float>(generate(5, regime, i));
    if (placed.a.radius + placed.b.radius > 0) continue;
    scene.add(placed.a, placed.pose_a);
    scene.add(placed.b, placed.pose_b);
    const auto count = static_cast<std::uint32_t>(scene.bodies.size());
    scene.pairs.push_back({count - 2, count - 1});
  }
  check_scene(scene);
}

namespace {

/// A gap is no more than how far apart the cores are, less the radii, and no less than by their
/// faces, each but for rounding.
bool is_gap(const ConvexPolygon<float>& a, const ConvexPolygon<float>& b, float gap) {
  constexpr float no_limit = std::numeric_limits<float>::infinity();
  const float total_radius = a.radius + b.radius;
  const float rounding = 4 * (clipping::separation_roundoff(a, b) + 0x1p-23F * total_radius);
  const auto cores = static_cast<float>(std::sqrt(clipping::squared_between_outlines(a, b)));
  float by_faces = -no_limit;
  if (a.count > 1) by_faces = clipping::greatest_separation(a, b, no_limit).separation;
  if (b.count > 1) {
    by_faces = std::max(by_faces, clipping::greatest_separation(b, a, no_limit).separation);
  }
  return gap >= 0 && gap <= std::max(cores - total_radius, 0.0F) + rounding &&
         gap >= by_faces - total_radius - rounding;
}

}  // namespace

TEST_CASE("the gap of round shapes is no more than what is between them, in every regime") {
  for (const Regime& regime : round_regimes()) {
    INFO(regime.name);
    Scene<float> scene = scene_of<float>(regime);
    scene.expect(0);
    on_every_target([&] {
      std::vector<Manifold<float>> manifolds(scene.pairs.size());
      kernel::collide_pairs(scene.shapes, scene.bodies, scene.pairs, 0.0F, manifolds);
      std::size_t wrong = 0;
      for (std::size_t i = 0; i < manifolds.size(); ++i) {
        if (manifolds[i].count > 0) continue;
        const auto& [a, b] = scene.pairs[i];
        const auto b_in_a = relative_pose(scene.bodies[a].pose, scene.bodies[b].pose);
        wrong += !is_gap(scene.polygons[a], transform(b_in_a, scene.polygons[b]),
                         -manifolds[i].points[0].depth);
      }
      CHECK(wrong == 0);
    });
  }
}

TEST_CASE("round shapes that do not touch have the gap that is between them") {
  kernel::Shapes<float> shapes;
  const Vector2<float> corners[] = {{0, 0}, {1, 0}, {0, 1}};
  std::vector<kernel::Placement<float>> bodies;
  for (const int count : {1, 2, 3}) {
    const auto shape = make_polygon<float>(
        std::span(corners).first(static_cast<std::size_t>(count)), 0.5F, Rounding::round);
    const auto index = shapes.add(shape);
    bodies.push_back({index, {{0, 0}, {1, 0}}});
    bodies.push_back({index, {{5, 0}, {0, 1}}});  // its leftmost vertex is at x = 4 or 5
  }
  std::vector<kernel::BodyPair> pairs;
  for (std::uint32_t a = 0; a < 6; a += 2) {
    for (std::uint32_t b = 1; b < 6; b += 2) pairs.push_back({a, b});
  }
  std::vector<Manifold<float>> manifolds(pairs.size());
  kernel::collide_pairs(shapes, bodies, pairs, 0.0F, manifolds);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const float right = pairs[i].a == 0 ? 0.0F : 1.0F;
    const float left = pairs[i].b == 5 ? 4.0F : 5.0F;
    INFO(pairs[i].a << " and " << pairs[i].b);
    CHECK(manifolds[i].count == 0);
    CHECK(-manifolds[i].points[0].depth == left - right - 1);
  }
}

TEST_CASE("where separations overflow, face 0 stands in, as in the clean code") {
  const Scene<float> scene = scene_of<float>(*find_regime("generic"));
  Scene<float> huge;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    ConvexPolygon<float> polygon = scene.polygons[i];
    float reach = 0;
    for (const auto& v : polygon.corners()) reach = std::max(reach, v.cwiseAbs().maxCoeff());
    for (int k = 0; k < polygon.count; ++k) polygon.vertices[k] *= 3e38F / reach;
    huge.add(polygon, {{0, 0}, scene.bodies[i].pose.rotation});
  }
  huge.pairs = scene.pairs;
  huge.expect(0);
  const auto is_finite = [](const Manifold<float>& m) {
    bool finite = true;
    for (int k = 0; k < m.count; ++k) {
      finite = finite && m.points[k].position.allFinite() && std::isfinite(m.points[k].depth);
    }
    return finite;
  };
  on_every_target([&] {
    std::vector<Manifold<float>> manifolds(huge.pairs.size());
    kernel::collide_pairs(huge.shapes, huge.bodies, huge.pairs, 0.0F, manifolds);
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < manifolds.size(); ++i) {
      const Manifold<float>& right = huge.expected[i];
      wrong += is_finite(right) ? manifolds[i] != right : manifolds[i].count != right.count;
    }
    CHECK(wrong == 0);
  });
}

TEST_CASE("any number of pairs, of any bodies, is answered in order") {
  Scene<float> scene = scene_of<float>(*find_regime("generic"));
  const auto all = scene.pairs;
  for (const std::size_t count : {0, 1, 2, 15, 16, 17, 33}) {
    scene.pairs.assign(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(count));
    for (kernel::BodyPair& pair : scene.pairs) pair.b = 1;  // one body in every pair
    scene.expect(0);
    INFO(count);
    on_every_target([&] {
      CHECK(wrong_from_indices(scene, 0.0F) == 0);
      CHECK(wrong_packed(scene, 0.0F) == 0);
    });
  }
}
