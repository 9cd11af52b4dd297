#pragma once

#include <cstring>

#include "geometry/vector.hpp"

namespace manifuzz {

/// Both coordinates of a vector while they are computed with: they go through the processor at
/// once. Every operation is that of doubles, coordinate by coordinate.
using Both [[gnu::vector_size(2 * sizeof(double))]] = double;
/// Both coordinates of a vector of floats while they are computed with.
using BothFloats [[gnu::vector_size(2 * sizeof(float))]] = float;

inline Both both(double of_each) {
  return Both{of_each, of_each};
}

inline Both both(const Vector2<double>& v) {
  Both b;
  std::memcpy(&b, v.data(), sizeof(b));
  return b;
}

inline void store(const Both& b, Vector2<double>& to) {
  std::memcpy(to.data(), &b, sizeof(b));
}

inline Vector2<double> vector(const Both& b) {
  return {b[0], b[1]};
}

/// Each rounded to float.
inline BothFloats floats(const Both& b) {
  return __builtin_convertvector(b, BothFloats);
}

inline void store(const BothFloats& b, Vector2<float>& to) {
  std::memcpy(to.data(), &b, sizeof(b));
}

/// x and y exchanged.
inline Both exchanged(const Both& b) {
  return Both{b[1], b[0]};
}

/// A rotation (cos, sin) of many vectors: the products and sums of `rotate` and `rotate_back`.
class Turn {
 public:
  explicit Turn(const Vector2<double>& rotation)
      : cos_(both(rotation.x())), sin_{-rotation.y(), rotation.y()} {}

  Both operator()(const Both& v) const { return cos_ * v + sin_ * exchanged(v); }
  Both back(const Both& v) const { return cos_ * v - sin_ * exchanged(v); }

 private:
  Both cos_;
  Both sin_;
};

}  // namespace manifuzz
