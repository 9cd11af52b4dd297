#include "kernel/pair_stream.hpp"

#include <algorithm>

namespace manifuzz::kernel {

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

template class PairStream<float>;
template class PairStream<double>;

}  // namespace manifuzz::kernel
