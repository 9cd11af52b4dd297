#include "oracle/libccd/ledger/deviations.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "judging/faults/differences.hpp"

// libccd 2, in world directions seen from A's position.

namespace manifuzz {
namespace {

/// epa_tolerance of CCD_INIT.
constexpr double kTolerance = 1e-4;

/// Whether the translation ends on a chord of the difference, where an edge or a side of the
/// polytope seems to be, from which `corner` is by so much at most.
bool is_on_chord(const ledger_of::Difference& difference, const Vector2<double>& translation,
                 const Vector2<double>& corner, double distance_max, double bound) {
  const auto& corners = difference.corners();
  return std::ranges::any_of(corners, [&](const Vector2<double>& from) {
    return std::ranges::any_of(corners, [&](const Vector2<double>& to) {
      return ledger_of::distance_to_segment(translation, from, to) <= bound &&
             ledger_of::distance_to_segment(corner, from, to) <= distance_max;
    });
  });
}

}  // namespace

bool tolerance_of_squares(const Deviation& d) {
  if (d.got.count == 0) return false;
  const ledger_of::Difference difference(d.right.pair());
  const Vector2<double> translation = ledger_of::translation_of(d);
  const double depth = translation.norm();
  const double bound = 4 * d.right.bounds.separation;
  if (depth <= bound || depth > ledger_of::least_depth(d) + bound) return false;
  const Vector2<double> corner = difference.farthest(translation);
  // What nextSupport compares with the tolerance: the corner along the witness, less the witness.
  const double beyond = corner.dot(translation) - depth * depth;
  const double distance_max = beyond < kTolerance + bound * depth
                                  ? std::numeric_limits<double>::infinity()
                                  : std::sqrt(kTolerance) + bound;
  return is_on_chord(difference, translation, corner, distance_max, bound);
}

bool zero_of_squares(const Deviation& d) {
  const double root_of_epsilon = std::sqrt(std::numeric_limits<double>::epsilon());
  return ledger_of::is_translation_right(d, root_of_epsilon + 4 * d.right.bounds.separation);
}

}  // namespace manifuzz
