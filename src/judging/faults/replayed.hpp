#pragma once

#include <bit>
#include <vector>

#include "judging/ledger.hpp"

namespace manifuzz::replayed {

// An engine's operations repeated on a case: whether they give the answer that it gave, and
// whether they would give a right one with a fault of theirs mended.

/// What an engine answers, in the world: the normal from A to B, points with their depths.
struct Contact {
  struct Point {
    Vector2<double> at{0, 0};
    double depth = 0;
  };
  Vector2<double> normal{0, 0};
  std::vector<Point> points;
  Vector2<double> origin{0, 0};  ///< from where points are measured
};

/// A contact in A's frame.
Manifold<double> in_frame_of_a(const PairCase& pair, const Contact& contact);

/// Whether it is what the engine answered, within the bounds of a right collider's figures.
bool is_same_answer(const Deviation& deviation, const Contact& contact);

/// Whether it would be right of a collider with this declaration.
bool is_right_answer(const Deviation& deviation, const Declaration& declaration,
                     const Contact& contact);

/// Both questions of what an engine says of the pair alone: a normal from A to B in the world, a
/// depth.
bool is_same_separation(const Deviation& deviation, const Vector2<double>& normal, double depth);
bool is_right_separation(const Deviation& deviation, const Declaration& declaration,
                         const Vector2<double>& normal, double depth);

/// The normals, from A to B in the world, of the least depth within a right separation's bound.
std::vector<Vector2<double>> least_normals(const Deviation& deviation);
/// The one of them that is nearest to another normal.
Vector2<double> least_normal_near(const Deviation& deviation, const Vector2<double>& normal);

/// Whether a fault is among some: each is a bit.
template <class Fault>
constexpr bool has(unsigned faults, Fault fault) {
  return (faults & static_cast<unsigned>(fault)) != 0;
}

/// Whether a fault, a bit of `all`, is in one of the smallest sets of these that have to be mended
/// for a right answer. `is_right` tells that of the answer with a set of faults mended.
template <class IsRight>
bool is_needed(unsigned fault, unsigned all, const IsRight& is_right) {
  for (int count = 1, found = 0; found == 0 && count <= std::popcount(all); ++count) {
    for (unsigned mended = 1; mended <= all; ++mended) {
      const bool is_set = (mended & ~all) == 0 && std::popcount(mended) == count;
      if (!is_set || !is_right(mended)) continue;
      if ((mended & fault) != 0) return true;
      ++found;
    }
  }
  return false;
}

}  // namespace manifuzz::replayed
