#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernel/batch.cpp"
#include <hwy/foreach_target.h>  // includes this file once more for every other target
// after foreach_target
#include <cassert>
#include <hwy/highway.h>

#include "kernel/batch.hpp"
#include "kernel/circle_core-inl.hpp"
#include "kernel/circles-inl.hpp"
#include "kernel/collide-inl.hpp"
#include "kernel/core_contact-inl.hpp"
#include "kernel/fetch-inl.hpp"
#include "kernel/round_pairs.hpp"

HWY_BEFORE_NAMESPACE();
namespace manifuzz::kernel::HWY_NAMESPACE {

/// A strip with round shapes. Apart, so that sharp ones keep the registers to themselves.
template <class D>
HWY_NOINLINE void collide_round_strip(D d, const Strip<D>& s, PairKind kind, hn::TFromD<D> tie_bias,
                                      ManifoldBlock<hn::TFromD<D>>& out) {
  switch (kind) {
    case PairKind::cores:
      return collide_cores(d, s, tie_bias, out);
    case PairKind::circles:
      return collide_circles(d, s.load2(s.corner(0, 0)), s.load2(s.corner(1, 0)),
                             s.load(s.radii[0]), s.load(s.radii[1]), s.column, out);
    default:
      return collide_circle_and_core(d, s, kind == PairKind::core_and_circle ? 0 : 1, out);
  }
}

/// The manifolds of a strip whose B stands in A's frame.
template <class D>
HWY_INLINE void collide_strip(D d, const Strip<D>& s, PairKind kind, hn::TFromD<D> tie_bias,
                              ManifoldBlock<hn::TFromD<D>>& out) {
  if (HWY_LIKELY(kind == PairKind::sharp)) return collide_placed(d, s, tie_bias, out);
  collide_round_strip(d, s, kind, tie_bias, out);
}

/// The manifolds of a block of pairs.
template <class T>
HWY_INLINE void collide_block(const PairBlock<T>& block, T tie_bias, ManifoldBlock<T>& out) {
  using D = hn::CappedTag<T, kBlockPairs>;
  const D d;
  const Row<T>* const a = block.rows + kCorners;
  const Row<T>* const b = a + polygon_rows(block.count_a);
  const Row<T>* const radii = b + polygon_rows(block.count_b);
  Row<T> placed[polygon_rows(kMaxVertices)];
  for (int column = 0; column < kBlockPairs; column += static_cast<int>(hn::Lanes(d))) {
    Strip<D> strip{block.rows, {a, b}, {block.count_a, block.count_b}, column, radii};
    place(d, strip, placed);
    strip.corners[1] = placed;
    collide_strip(d, strip, block.kind, tie_bias, out);
  }
}

template <class T>
HWY_INLINE void collide_packed(const PackedPairs<T>& pairs, T tie_bias,
                               std::span<ManifoldBlock<T>> out) {
  for (std::size_t i = 0; i < pairs.block_count(); ++i) {
    const PairBlock<T> block = pairs.block(i);
    if (block.kind == PairKind::circles) {
      collide_circles(block.rows, out[i]);
      continue;
    }
    if (block.round.size() < kBlockPairs) collide_block(block, tie_bias, out[i]);
    for (const RoundPair<T>& pair : block.round) {
      put(collide_round_pair_or_gap(pair.a, pair.b, pair.b_in_a, tie_bias), out[i], pair.column);
    }
  }
}

void collide_packed_float(const PackedPairs<float>& pairs, float tie_bias,
                          std::span<ManifoldBlock<float>> out) {
  collide_packed<float>(pairs, tie_bias, out);
}
void collide_packed_double(const PackedPairs<double>& pairs, double tie_bias,
                           std::span<ManifoldBlock<double>> out) {
  collide_packed<double>(pairs, tie_bias, out);
}

template <class T>
HWY_INLINE void collide_batch(const Shapes<T>& shapes, const PairBatch<T>& batch, T tie_bias) {
  const hn::CappedTag<T, kBlockPairs> d;
  BatchRows<T> rows;
  int count_max[2];
  fetch(shapes, batch, rows, count_max);
  ManifoldBlock<T> block;
  for (int column = 0; column < kBlockPairs; column += static_cast<int>(hn::Lanes(d))) {
    collide_strip(d,
                  {rows.of_block,
                   {rows.corners[0], rows.corners[1]},
                   {count_max[0], count_max[1]},
                   column,
                   rows.radii},
                  batch.kind, tie_bias, block);
  }
  hand_out(block, batch);
}

void collide_batch_float(const Shapes<float>& shapes, const PairBatch<float>& batch,
                         float tie_bias) {
  collide_batch<float>(shapes, batch, tie_bias);
}
void collide_batch_double(const Shapes<double>& shapes, const PairBatch<double>& batch,
                          double tie_bias) {
  collide_batch<double>(shapes, batch, tie_bias);
}

}  // namespace manifuzz::kernel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace manifuzz::kernel {

HWY_EXPORT(collide_packed_float);
HWY_EXPORT(collide_packed_double);
HWY_EXPORT(collide_batch_float);
HWY_EXPORT(collide_batch_double);

void collide_packed(const PackedPairs<float>& pairs, float tie_bias,
                    std::span<ManifoldBlock<float>> out) {
  assert(out.size() >= pairs.block_count());
  HWY_DYNAMIC_DISPATCH(collide_packed_float)(pairs, tie_bias, out);
}

void collide_packed(const PackedPairs<double>& pairs, double tie_bias,
                    std::span<ManifoldBlock<double>> out) {
  assert(out.size() >= pairs.block_count());
  HWY_DYNAMIC_DISPATCH(collide_packed_double)(pairs, tie_bias, out);
}

void collide_batch(const Shapes<float>& shapes, const PairBatch<float>& batch, float tie_bias) {
  HWY_DYNAMIC_DISPATCH(collide_batch_float)(shapes, batch, tie_bias);
}

void collide_batch(const Shapes<double>& shapes, const PairBatch<double>& batch, double tie_bias) {
  HWY_DYNAMIC_DISPATCH(collide_batch_double)(shapes, batch, tie_bias);
}

namespace {

/// A stream that is told takes it from what stands in `out` which pairs touched.
template <bool kIsTold, class Scalar>
void stream_pairs(const Shapes<Scalar>& shapes, std::span<const Placement<Scalar>> bodies,
                  std::span<const BodyPair> pairs, Scalar tie_bias,
                  std::span<Manifold<Scalar>> out) {
  assert(out.size() >= pairs.size());
  PairStream<Scalar, kIsTold> stream(shapes, bodies, tie_bias);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    stream.push(pairs[i], out[i], kIsTold && out[i].count > 0);
  }
  stream.finish();
}

}  // namespace

void collide_pairs(const Shapes<float>& shapes, std::span<const Placement<float>> bodies,
                   std::span<const BodyPair> pairs, float tie_bias,
                   std::span<Manifold<float>> out) {
  stream_pairs<false>(shapes, bodies, pairs, tie_bias, out);
}

void collide_pairs(const Shapes<double>& shapes, std::span<const Placement<double>> bodies,
                   std::span<const BodyPair> pairs, double tie_bias,
                   std::span<Manifold<double>> out) {
  stream_pairs<false>(shapes, bodies, pairs, tie_bias, out);
}

void collide_pairs_again(const Shapes<float>& shapes, std::span<const Placement<float>> bodies,
                         std::span<const BodyPair> pairs, float tie_bias,
                         std::span<Manifold<float>> manifolds) {
  stream_pairs<true>(shapes, bodies, pairs, tie_bias, manifolds);
}

void collide_pairs_again(const Shapes<double>& shapes, std::span<const Placement<double>> bodies,
                         std::span<const BodyPair> pairs, double tie_bias,
                         std::span<Manifold<double>> manifolds) {
  stream_pairs<true>(shapes, bodies, pairs, tie_bias, manifolds);
}

}  // namespace manifuzz::kernel
#endif
