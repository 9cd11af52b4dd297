#include "kernel/pair_stream.hpp"

#include <algorithm>

#include "kernel/round_pairs.hpp"

namespace manifuzz::kernel {

/// All have both kinds of shapes in common.
template <class Scalar>
void collide_round(const Shapes<Scalar>& shapes,
                   std::span<const typename PairBatch<Scalar>::Pair> pairs, Scalar tie_bias) {
  if (pairs.empty()) return;
  const auto is_circle = [&](const Placement<Scalar>* body) {
    return shapes.kind(body->shape) == kCircle;
  };
  if (std::ranges::all_of(pairs.front().body, is_circle)) {
    PairBatch<Scalar> batch;
    std::ranges::copy(pairs, batch.pair);
    std::fill(batch.pair + pairs.size(), std::end(batch.pair), pairs.back());
    return collide_circles(shapes, batch);
  }
  for (const auto& [body, corners, out] : pairs) {
    *out = collide_round_pair_or_gap(shapes.polygon(body[0]->shape), shapes.polygon(body[1]->shape),
                                     relative_pose(body[0]->pose, body[1]->pose), tie_bias);
  }
}

/// Sharp neighbours in the order of keys differ little in their counts: they share batches, the
/// last of which is filled up with its last pair.
template <class Scalar>
void PairStream<Scalar>::finish() {
  PairBatch<Scalar> rest;
  rest.count[0] = rest.count[1] = 0;
  int size = 0;
  for (unsigned key = 0; key < kKeys; ++key) {
    const PairBatch<Scalar>& batch = batches_[key];
    if (is_round(key)) {
      collide_round<Scalar>(shapes_, std::span(batch.pair).first(sizes_[key]), tie_bias_);
      sizes_[key] = 0;
    }
    for (int column = 0; column < sizes_[key]; ++column) {
      rest.pair[size++] = batch.pair[column];
      if (size < kBlockPairs) continue;
      collide_batch(shapes_, rest, tie_bias_);
      size = 0;
    }
    sizes_[key] = 0;
  }
  if (size == 0) return;
  std::fill(rest.pair + size, rest.pair + kBlockPairs, rest.pair[size - 1]);
  collide_batch(shapes_, rest, tie_bias_);
}

template void collide_round(const Shapes<float>&, std::span<const PairBatch<float>::Pair>, float);
template void collide_round(const Shapes<double>&, std::span<const PairBatch<double>::Pair>,
                            double);
template class PairStream<float>;
template class PairStream<double>;

}  // namespace manifuzz::kernel
