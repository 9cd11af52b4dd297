// Copied with the bugs planted into the kernels for many pairs, and compiled under a namespace of
// theirs.
#include <memory>
#include <utility>

#include "canary/one_target.hpp"
#include "canary/planted.hpp"
#include "kernel/batch.cpp"
#include "kernel/deepest_contact.cpp"
#include "kernel/packed.cpp"
#include "kernel/pair_stream.cpp"
#include "kernel/round_pairs.cpp"
#include "kernel/shapes.cpp"

namespace manifuzz {
namespace {

/// Arrays, not vectors: those cost more to compile than the kernels.
template <class Scalar>
struct Scene {
  explicit Scene(std::span<const canary::Placed<Scalar>> placed)
      : count(placed.size()),
        bodies(new kernel::Placement<Scalar>[2 * count]),
        pairs(new kernel::BodyPair[count]) {
    for (std::uint32_t i = 0; i < count; ++i) {
      bodies[2 * i] = {shapes.add(placed[i].a), placed[i].pose_a};
      bodies[2 * i + 1] = {shapes.add(placed[i].b), placed[i].pose_b};
      pairs[i] = {2 * i, 2 * i + 1};
    }
  }

  std::size_t count;
  kernel::Shapes<Scalar> shapes;
  std::unique_ptr<kernel::Placement<Scalar>[]> bodies;
  std::unique_ptr<kernel::BodyPair[]> pairs;
};

/// Every eighth pair is said to have touched; others fill a batch.
template <class Scalar>
void from_indices(std::span<const canary::Placed<Scalar>> placed, Scalar tie_bias,
                  Manifold<Scalar>* out) {
  const Scene<Scalar> scene(placed);
  for (std::size_t i = 0; i < scene.count; ++i) out[i].count = i % 8 == 0 ? 1 : 0;
  kernel::collide_pairs_again(scene.shapes, {scene.bodies.get(), 2 * scene.count},
                              {scene.pairs.get(), scene.count}, tie_bias, {out, scene.count});
}

template <class Scalar>
void packed(std::span<const canary::Placed<Scalar>> placed, Scalar tie_bias,
            Manifold<Scalar>* out) {
  const Scene<Scalar> scene(placed);
  const kernel::PackedPairs<Scalar> pairs(scene.shapes, {scene.bodies.get(), 2 * scene.count},
                                          {scene.pairs.get(), scene.count});
  const std::unique_ptr<kernel::ManifoldBlock<Scalar>[]> blocks(
      new kernel::ManifoldBlock<Scalar>[pairs.block_count()]());
  kernel::collide_packed(pairs, tie_bias, {blocks.get(), pairs.block_count()});
  for (std::size_t i = 0; i < scene.count; ++i) {
    const auto column = static_cast<int>(i % kernel::kBlockPairs);
    out[i] = kernel::manifold(blocks[i / kernel::kBlockPairs], column);
  }
}

[[maybe_unused]] const bool planted = canary::add_batches(
    {PLANTED_BUGS}, {from_indices<float>, packed<float>}, {from_indices<double>, packed<double>});

}  // namespace
}  // namespace manifuzz
