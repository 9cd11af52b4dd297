#pragma once

#include <array>
#include <vector>

#include "geometry/pair_case.hpp"

namespace manifuzz::ledger_of {

// nape's contactCollide of two polygons, its operations repeated in their order, so that but for
// V8's cosine and sine the numbers are the engine's.

/// The corners that nape keeps of a shape whose corners these are.
std::vector<Vector2<double>> spliced_by_nape(std::vector<Vector2<double>> corners);

/// What nape is given of a body: as much longer as the rotation is longer than unit.
std::vector<Vector2<double>> given_to_nape(const Body& body);

/// The incident edge as nape cuts it.
struct ContactOfNape {
  Side reference = Side::a;
  Vector2<double> normal{0, 0};         ///< from A to B, in the world
  std::array<Vector2<double>, 2> ends;  ///< on the incident side, in the world
  std::array<double, 2> depths{};       ///< below 0 across a gap
  double run = 0;                       ///< of the edge along the face, by which it divides
};

/// How far an end is moved along the incident edge: by any share of it, or, mended, by the whole
/// edge at most.
enum class CutOfNape { of_any_share, within_edge };

/// In either order of both shapes, which decides between features that tie; none of a pair without
/// contact.
std::vector<ContactOfNape> contacts_of_nape(const PairCase& pair, CutOfNape cut);

}  // namespace manifuzz::ledger_of
