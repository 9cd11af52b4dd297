#include <catch2/catch.hpp>

#include "afresh/afresh.hpp"
#include "generating/regime.hpp"
#include "kernel/batch.hpp"
#include "kernel/pair_stream.hpp"
#include "unit/memory/failing_allocations.hpp"

// Each allocation of what is below scenes fails once.

using namespace manifuzz;

namespace {

/// Runs `act` with each allocation failing, until none is left to fail; how many failed.
template <class Act>
std::size_t let_each_fail(const Act& act) {
  std::size_t after = 0;
  while (test::runs_out(after, act)) ++after;
  return after;
}

std::vector<ConvexPolygon<float>> polygons() {
  std::vector<ConvexPolygon<float>> all;
  for (std::uint64_t i = 0; i < 20; ++i) {
    all.push_back(generate(1, *find_regime("boxes"), i).a.polygon);
  }
  return all;
}

template <class Bodies>
void place_in_row(Bodies& bodies, std::size_t shapes) {
  for (std::uint32_t i = 0; i < 60; ++i) {
    bodies.push_back(
        {static_cast<std::uint32_t>(i % shapes), {{0.4F * static_cast<float>(i), 0}, {1, 0}}});
  }
}

}  // namespace

TEST_CASE("a shape for which there is no memory is not added") {
  const auto all = polygons();
  kernel::Shapes<float> shapes;
  std::size_t failures = 0;
  for (std::uint32_t i = 0; i < all.size(); ++i) {
    std::uint32_t index = 0;
    failures += let_each_fail([&] { index = shapes.add(all[i]); });
    REQUIRE(index == i);
    CHECK(shapes.polygon(i) == all[i]);
    CHECK(shapes.count(i) == static_cast<unsigned>(all[i].count));
  }
  CHECK(failures > 0);
}

TEST_CASE(
    "pairs for which there is no memory are packed when there is some, with the same manifolds") {
  const auto all = polygons();
  kernel::Shapes<float> shapes;
  for (const auto& polygon : all) shapes.add(polygon);
  std::vector<kernel::Placement<float>> bodies;
  place_in_row(bodies, all.size());
  std::vector<kernel::BodyPair> pairs;
  for (std::uint32_t i = 0; i + 1 < bodies.size(); ++i) pairs.push_back({i, i + 1});
  std::vector<Manifold<float>> by_index(pairs.size());
  CHECK(let_each_fail([&] { kernel::collide_pairs(shapes, bodies, pairs, 0, by_index); }) == 0);
  std::optional<kernel::PackedPairs<float>> packed;
  CHECK(let_each_fail([&] { packed.emplace(shapes, bodies, pairs); }) > 0);
  std::vector<kernel::ManifoldBlock<float>> blocks(packed->block_count());
  kernel::collide_packed(*packed, 0, blocks);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    CHECK(kernel::manifold(blocks[i / kernel::kBlockPairs],
                           static_cast<int>(i % kernel::kBlockPairs)) == by_index[i]);
  }
}

TEST_CASE("every pair afresh is right again after memory ran out anywhere") {
  const auto all = polygons();
  std::vector<kernel::Placement<float>> bodies;
  place_in_row(bodies, all.size());
  scene::Afresh right;
  for (const auto& polygon : all) right.add_shape(polygon);
  const auto expected = right.collide(bodies);
  REQUIRE(!expected.empty());
  scene::Afresh with_shapes;
  std::size_t failures = 0;
  for (const auto& polygon : all) {
    failures += let_each_fail([&] { with_shapes.add_shape(polygon); });
  }
  CHECK(failures > 0);
  for (std::size_t after = 0;; ++after) {
    scene::Afresh afresh = with_shapes;
    const bool has_run_out = test::runs_out(after, [&] { afresh.collide(bodies); });
    const auto found = afresh.collide(bodies);
    REQUIRE(found.size() == expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
      CHECK(found[i].manifold == expected[i].manifold);
    }
    if (has_run_out) continue;
    CHECK(after > 0);
    break;
  }
}
