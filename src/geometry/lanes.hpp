#pragma once

#include <array>
#include <cstring>

#include "geometry/convex_polygon.hpp"

namespace manifuzz {

/// A number for each vertex, or face, of a polygon, in memory.
using LaneArray = std::array<double, kMaxVertices>;

/// The same while it is computed with. Every operation is that of doubles, lane by lane. Two lanes
/// go through the processor at once, which g++ does not make of a plain loop: it unrolls the loop
/// first, and then sees single numbers.
class Lanes {
 public:
  /// The same in every lane.
  explicit Lanes(double all) { pairs_.fill(Pair{all, all}); }
  explicit Lanes(const LaneArray& from) { std::memcpy(&pairs_, &from, sizeof(pairs_)); }

  LaneArray array() const {
    LaneArray to;
    std::memcpy(&to, &pairs_, sizeof(to));
    return to;
  }

  friend Lanes operator+(Lanes a, const Lanes& b) {
    for (int i = 0; i < kPairs; ++i) a.pairs_[i] += b.pairs_[i];
    return a;
  }
  friend Lanes operator-(Lanes a, const Lanes& b) {
    for (int i = 0; i < kPairs; ++i) a.pairs_[i] -= b.pairs_[i];
    return a;
  }
  friend Lanes operator*(Lanes a, const Lanes& b) {
    for (int i = 0; i < kPairs; ++i) a.pairs_[i] *= b.pairs_[i];
    return a;
  }
  /// `std::min` of each lane.
  friend Lanes min(Lanes a, const Lanes& b) {
    for (int i = 0; i < kPairs; ++i) {
      a.pairs_[i] = b.pairs_[i] < a.pairs_[i] ? b.pairs_[i] : a.pairs_[i];
    }
    return a;
  }

 private:
  using Pair [[gnu::vector_size(2 * sizeof(double))]] = double;
  static constexpr int kPairs = kMaxVertices / 2;

  std::array<Pair, kPairs> pairs_;
};

}  // namespace manifuzz
