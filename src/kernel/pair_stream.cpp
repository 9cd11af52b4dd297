#include "kernel/pair_stream.hpp"

#include <algorithm>

namespace manifuzz::kernel {

/// Neighbours in the order of groups differ little in their counts: those of a kind share batches,
/// the last of which is filled up with its last pair. Pairs that touched come after all others.
template <class Scalar, bool kIsTold>
void PairStream<Scalar, kIsTold>::finish() {
  std::array<PairBatch<Scalar>, kPairKinds> rests;
  std::array<int, kPairKinds> rest_sizes{};
  for (unsigned key = 0; key < kKeys; ++key) {
    PairBatch<Scalar>& batch = batches_[key];
    const auto filled = next_[key] - batch.pair;
    if (filled == 0) continue;
    const PairKind kind = kind_of_group(key % kPairGroups);
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
    next_[key] = batch.pair;
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
template class PairStream<float, true>;
template class PairStream<double, true>;

}  // namespace manifuzz::kernel
