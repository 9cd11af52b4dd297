#pragma once

#include "kernel/packed.hpp"

// Many pairs at once, one a lane of the widest vectors this processor has. Equal to
// `clipping::collide` of the same polygons and poses, bit for bit, on every instruction set: same
// operations in the same order, nothing fused, nothing approximated.

namespace manifuzz::kernel {

/// `out[i]` becomes the manifolds of block i, each in the frame of its pair's A; it holds
/// `pairs.block_count()` of them. Columns beyond the last pair repeat it. `tie_bias` is a length >=
/// 0.
void collide_packed(const PackedPairs<float>& pairs, float tie_bias,
                    std::span<ManifoldBlock<float>> out);
/// Collides packed pairs in double.
void collide_packed(const PackedPairs<double>& pairs, double tie_bias,
                    std::span<ManifoldBlock<double>> out);

/// `out[i]` becomes the manifold of `pairs[i]`, in the frame of its A. Where there are no points,
/// the first one's depth is minus the gap, by which the greatest separation exceeds the total
/// radius (0 if it does not), its features name the face that would clip, with vertex 0 of the
/// other shape (two vertices where no face is known), and the rest is unspecified. `out` is as
/// long as `pairs`. Shapes and poses, which are in the world, are fetched by index, unchecked;
/// pairs go through a `PairStream` (pair_stream.hpp). `tie_bias` is a length >= 0.
void collide_pairs(const Shapes<float>& shapes, std::span<const Placement<float>> bodies,
                   std::span<const BodyPair> pairs, float tie_bias, std::span<Manifold<float>> out);
/// Collides pairs of bodies in double.
void collide_pairs(const Shapes<double>& shapes, std::span<const Placement<double>> bodies,
                   std::span<const BodyPair> pairs, double tie_bias,
                   std::span<Manifold<double>> out);

/// `manifolds[i]`, which was the manifold of `pairs[i]` a step ago, becomes that of now, as
/// `collide_pairs` gives it. Pairs that touched share batches: where all pairs of one are apart,
/// nothing is clipped. Which pairs share a batch changes no manifold. `manifolds` is as long as
/// `pairs`, without points at first. Takes 170 KB of the stack, twice what `collide_pairs` does.
void collide_pairs_again(const Shapes<float>& shapes, std::span<const Placement<float>> bodies,
                         std::span<const BodyPair> pairs, float tie_bias,
                         std::span<Manifold<float>> manifolds);
/// Collides pairs of bodies again in double.
void collide_pairs_again(const Shapes<double>& shapes, std::span<const Placement<double>> bodies,
                         std::span<const BodyPair> pairs, double tie_bias,
                         std::span<Manifold<double>> manifolds);

}  // namespace manifuzz::kernel
