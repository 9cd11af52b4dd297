#include "kernel/pair_stream.hpp"

#include <algorithm>

namespace manifuzz::kernel {

/// Neighbours in the order of keys differ little in their counts: they share batches, the last of
/// which is filled up with its last pair.
template <class Scalar>
void PairStream<Scalar>::finish() {
  PairBatch<Scalar> rest;
  rest.count[0] = rest.count[1] = 0;
  int size = 0;
  for (std::size_t key = 0; key < batches_.size(); ++key) {
    const PairBatch<Scalar>& batch = batches_[key];
    for (int column = 0; column < sizes_[key]; ++column) {
      for (const int p : {0, 1}) rest.body[p][size] = batch.body[p][column];
      rest.out[size++] = batch.out[column];
      if (size < kBlockPairs) continue;
      collide_batch(shapes_, rest, tie_bias_);
      size = 0;
    }
    sizes_[key] = 0;
  }
  if (size == 0) return;
  for (const int p : {0, 1}) {
    std::fill(rest.body[p] + size, rest.body[p] + kBlockPairs, rest.body[p][size - 1]);
  }
  std::fill(rest.out + size, rest.out + kBlockPairs, rest.out[size - 1]);
  collide_batch(shapes_, rest, tie_bias_);
}

template class PairStream<float>;
template class PairStream<double>;

}  // namespace manifuzz::kernel
