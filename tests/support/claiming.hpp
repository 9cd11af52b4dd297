#pragma once

#include <span>
#include <string>

#include "collider/collider.hpp"

// Right answers of every claim: what a clip finds, in float and in double, rounded in A's frame or
// in the world, said as an engine says it that does not clip.

namespace manifuzz::test {

/// One that is right by its declaration, on polygons without radii: a clip in these, and what it
/// says of that.
struct Claiming {
  ScalarType scalar = ScalarType::float32;
  RoundingFrame frame = RoundingFrame::local;
};
inline constexpr Claiming kClaiming[] = {{ScalarType::float32, RoundingFrame::local},
                                         {ScalarType::float32, RoundingFrame::world},
                                         {ScalarType::float64, RoundingFrame::local},
                                         {ScalarType::float64, RoundingFrame::world}};

/// "float, in the world".
std::string name_of(const Claiming& claiming);

/// The clip's manifold.
Manifold<double> clipped(const PairCase& pair, const Claiming& claiming);

/// What an answer is made of a manifold, and how it declares itself.
struct Claim {
  const char* name;
  Declaration (*declared)(Declaration declaration);
  Answer (*said)(const PairCase& pair, const Manifold<double>& manifold);
};
/// A pair's touching, a minimum translation, one point of GJK on each surface and at a vertex, what
/// clips, midpoints, and points that share one depth.
std::span<const Claim> claims();

/// That collider's declaration, before any claim.
Declaration declaration_of(const Claiming& claiming);

}  // namespace manifuzz::test
