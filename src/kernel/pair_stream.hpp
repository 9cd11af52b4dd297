#pragma once

#include <array>
#include <cassert>

#include "kernel/packed.hpp"

// Pairs as they are found, one after another. Each goes to the batch of its group, and a full batch
// is collided. Who knows which pairs touched a step ago has twice as many batches, and where all
// pairs of one are apart, nothing is clipped.

namespace manifuzz::kernel {

/// Up to sixteen pairs of bodies, and where their manifolds go.
template <class Scalar>
struct PairBatch {
  /// One of them.
  struct Pair {
    const Placement<Scalar>* body[2];  ///< A, B
    const Scalar* corners[2];          ///< of their shapes, corner by corner
    Manifold<Scalar>* out;             ///< becomes theirs
  };

  Pair pair[kBlockPairs];  ///< a column each
  int count[2];            ///< every A's corners and every B's; 0 where they differ
  PairKind kind;           ///< of all of them
};

/// Collides sixteen pairs of a kind, equal to `clipping::collide` of each, bit for bit. `tie_bias`
/// is a length >= 0.
void collide_batch(const Shapes<float>& shapes, const PairBatch<float>& batch, float tie_bias);
/// Collides sixteen pairs of a kind in double.
void collide_batch(const Shapes<double>& shapes, const PairBatch<double>& batch, double tie_bias);

/// A scene's pairs on their way to the kernel for many. Shapes and bodies stay where and as they
/// are until `finish`, and so do the manifolds: they may be written at any `push`, in any order.
/// `kIsTold`: `push` is told which pairs touched. Takes 85 KB, or 170 KB if it is told.
template <class Scalar, bool kIsTold = false>
class PairStream {
 public:
  /// Shapes and poses, which are in the world, are fetched by index, unchecked. `tie_bias` is a
  /// length >= 0.
  PairStream(const Shapes<Scalar>& shapes, std::span<const Placement<Scalar>> bodies,
             Scalar tie_bias)
      : shapes_(shapes), bodies_(bodies), tie_bias_(tie_bias) {
    for (unsigned key = 0; key < kKeys; ++key) next_[key] = batches_[key].pair;
  }
  PairStream(const PairStream&) = delete;  ///< it points into itself

  /// `out` becomes the manifold of the pair, as `collide_pairs` gives it, until `finish` returns.
  /// Pairs that `touched` a step ago have batches of their own, which changes no manifold; only a
  /// stream that is told may be given any.
  void push(const BodyPair& pair, Manifold<Scalar>& out, bool touched = false) {
    assert(kIsTold || !touched);
    const Placement<Scalar>& a = bodies_[pair.a];
    const Placement<Scalar>& b = bodies_[pair.b];
    const unsigned group = shapes_.group(a.shape, b.shape);
    const auto corners = [&](const Placement<Scalar>& body) {
      const ShapeCorners<Scalar>& fetched = shapes_.corners(body.shape);
      __builtin_prefetch(&fetched);
      __builtin_prefetch(&fetched.scalars[fetched.scalars.size() / 2]);
      return fetched.scalars.data();
    };
    const unsigned key = group + (kIsTold && touched ? kPairGroups : 0);
    PairBatch<Scalar>& batch = batches_[key];
    auto* const next = next_[key]++;
    *next = {{&a, &b}, {corners(a), corners(b)}, &out};
    if (next < batch.pair + kBlockPairs - 1) return;
    next_[key] = batch.pair;
    batch.kind = kind_of_group(group);
    batch.count[0] = static_cast<int>(shapes_.count(a.shape));
    batch.count[1] = static_cast<int>(shapes_.count(b.shape));
    collide_batch(shapes_, batch, tie_bias_);
  }

  /// Collides what is left in batches that are not full; the stream is empty then.
  void finish();

 private:
  static constexpr unsigned kKeys = (kIsTold ? 2 : 1) * kPairGroups;

  const Shapes<Scalar>& shapes_;
  std::span<const Placement<Scalar>> bodies_;
  Scalar tie_bias_;
  std::array<PairBatch<Scalar>, kKeys> batches_;               // most are never written
  std::array<typename PairBatch<Scalar>::Pair*, kKeys> next_;  // a batch's next column
};

}  // namespace manifuzz::kernel
