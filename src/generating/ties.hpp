#pragma once

#include <optional>

#include "generating/placing.hpp"

namespace manifuzz {

/// A face of A and one of B that separate alike with B at `place`.
struct Tie {
  int face_a;
  int face_b;
  Vector2<double> place;
};

/// Walks with B round A at the separation it has at `place`, clockwise or not, until the face that
/// separates changes owner.
std::optional<Tie> walk_to_tie(const Faces& faces, Vector2<double> place, double sense);

/// Where face k separates by s and face l by t.
Vector2<double> place_at(const Faces& faces, int k, double s, int l, double t);

}  // namespace manifuzz
