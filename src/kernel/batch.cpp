#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernel/batch.cpp"
#include <hwy/foreach_target.h>  // includes this file once more for every other target
// after foreach_target
#include <cassert>
#include <hwy/highway.h>

#include "kernel/batch.hpp"
#include "kernel/circles-inl.hpp"
#include "kernel/collide-inl.hpp"
#include "kernel/fetch-inl.hpp"
#include "kernel/round_pairs.hpp"

HWY_BEFORE_NAMESPACE();
namespace manifuzz::kernel::HWY_NAMESPACE {

template <class T>
HWY_INLINE void collide_packed(const PackedPairs<T>& pairs, T tie_bias,
                               std::span<ManifoldBlock<T>> out) {
  for (std::size_t i = 0; i < pairs.block_count(); ++i) {
    const PairBlock<T> block = pairs.block(i);
    if (block.are_circles) {
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
    collide_placed(
        d,
        {rows.of_block, {rows.corners[0], rows.corners[1]}, {count_max[0], count_max[1]}, column},
        tie_bias, block);
  }
  hand_out(block, batch);
}

template <class T>
HWY_INLINE void collide_circle_batch(const Shapes<T>& shapes, const PairBatch<T>& batch) {
  Row<T> rows[kCircleRows];
  for (int column = 0; column < kBlockPairs; ++column) {
    const auto& [a, b] = batch.pair[column].body;
    put_circles(shapes, *a, *b, rows, column);
  }
  ManifoldBlock<T> block;
  collide_circles(rows, block);
  hand_out(block, batch);
}

void collide_circles_float(const Shapes<float>& shapes, const PairBatch<float>& batch) {
  collide_circle_batch(shapes, batch);
}
void collide_circles_double(const Shapes<double>& shapes, const PairBatch<double>& batch) {
  collide_circle_batch(shapes, batch);
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
HWY_EXPORT(collide_circles_float);
HWY_EXPORT(collide_circles_double);

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

void collide_circles(const Shapes<float>& shapes, const PairBatch<float>& batch) {
  HWY_DYNAMIC_DISPATCH(collide_circles_float)(shapes, batch);
}

void collide_circles(const Shapes<double>& shapes, const PairBatch<double>& batch) {
  HWY_DYNAMIC_DISPATCH(collide_circles_double)(shapes, batch);
}

namespace {

template <class Scalar>
void stream_pairs(const Shapes<Scalar>& shapes, std::span<const Placement<Scalar>> bodies,
                  std::span<const BodyPair> pairs, Scalar tie_bias,
                  std::span<Manifold<Scalar>> out) {
  assert(out.size() >= pairs.size());
  PairStream<Scalar> stream(shapes, bodies, tie_bias);
  for (std::size_t i = 0; i < pairs.size(); ++i) stream.push(pairs[i], out[i]);
  stream.finish();
}

}  // namespace

void collide_pairs(const Shapes<float>& shapes, std::span<const Placement<float>> bodies,
                   std::span<const BodyPair> pairs, float tie_bias,
                   std::span<Manifold<float>> out) {
  stream_pairs(shapes, bodies, pairs, tie_bias, out);
}

void collide_pairs(const Shapes<double>& shapes, std::span<const Placement<double>> bodies,
                   std::span<const BodyPair> pairs, double tie_bias,
                   std::span<Manifold<double>> out) {
  stream_pairs(shapes, bodies, pairs, tie_bias, out);
}

}  // namespace manifuzz::kernel
#endif
