#include "kernel/pair_stream.hpp"

#include <algorithm>

namespace manifuzz::kernel {

/// Neighbours in the order of groups differ little in their counts: those of a kind share batches,
/// the last of which is filled up with its last pair.
template <class Scalar>
void PairStream<Scalar>::finish() {
  std::array<PairBatch<Scalar>, kPairKinds> rests;
  std::array<int, kPairKinds> rest_sizes{};
  for (unsigned group = 0; group < kPairGroups; ++group) {
    PairBatch<Scalar>& batch = batches_[group];
    const auto filled = next_[group] - batch.pair;
    if (filled == 0) continue;
    const PairKind kind = kind_of_group(group);
    PairBatch<Scalar>& rest = rests[static_cast<unsigned>(kind)];
    int& size = rest_sizes[static_cast<unsigned>(kind)];
    rest.kind = kind;
    rest.count[0] = rest.count[1] = 0;
    for (int column = 0; column < filled; ++column) {
      rest.pair[size++] = batch.pair[column];
      if (size < kBlockPairs) continue;
      collide_batch(shapes_, rest, tie_bias_);
      size = 0;
    }
    next_[group] = batch.pair;
  }
  for (unsigned kind = 0; kind < kPairKinds; ++kind) {
    PairBatch<Scalar>& rest = rests[kind];
    const int size = rest_sizes[kind];
    if (size == 0) continue;
    std::fill(rest.pair + size, rest.pair + kBlockPairs, rest.pair[size - 1]);
    collide_batch(shapes_, rest, tie_bias_);
  }
}

template class PairStream<float>;
template class PairStream<double>;

}  // namespace manifuzz::kernel
