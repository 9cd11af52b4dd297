#include "afresh/afresh.hpp"

#include <algorithm>
#include <numeric>

#include "afresh/boxes.hpp"
#include "kernel/batch.hpp"

namespace manifuzz::scene {
namespace {

/// Pairs that are collided together: enough for the kernel to sort, few enough for the cache.
constexpr std::size_t kChunk = 4096;

}  // namespace

std::span<const Touching> Afresh::collide(std::span<const kernel::Placement<float>> bodies) {
  bodies_.resize(bodies.size());
  std::iota(bodies_.begin(), bodies_.end(), 0U);
  boxes_.resize(bodies.size());
  padded_boxes(shapes_, bodies, bodies_, boxes_);
  cells_.file(bodies_, boxes_, 0);
  cells_.pairs(pairs_);
  touching_.clear();
  manifolds_.resize(kChunk);
  for (std::size_t first = 0; first < pairs_.size(); first += kChunk) {
    const auto chunk = std::span(pairs_).subspan(first, std::min(kChunk, pairs_.size() - first));
    kernel::collide_pairs(shapes_.for_pairs(), bodies, chunk, tie_bias_, manifolds_);
    for (std::size_t i = 0; i < chunk.size(); ++i) {
      if (manifolds_[i].count > 0) touching_.push_back({chunk[i], manifolds_[i]});
    }
  }
  return touching_;
}

}  // namespace manifuzz::scene
