#pragma once

#include <optional>

#include "generating/placing.hpp"

namespace manifuzz {

/// A face of A and one of B that can separate alike.
struct Tie {
  int face_a = 0;  ///< numbered as in `Faces`
  int face_b = 0;
  double separation = 0;  ///< of B's face there
};

/// Walks with B round A, at the separation that the pair has, until the face that separates changes
/// owner: clockwise where `sense` is 1, the other way where it is -1. None where there is no such
/// place.
std::optional<Tie> find_tie(const PairCase& pair, double sense);

/// B's place, from A, where B's face of the tie leads A's by `lead`.
Vector2<double> place_at(const Faces& faces, const Tie& tie, double lead);

}  // namespace manifuzz
