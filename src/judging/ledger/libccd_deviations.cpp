#include <algorithm>
#include <cmath>

#include "judging/ledger/differences.hpp"
#include "judging/ledger/gjk_deviations.hpp"

// libccd 2, in world directions seen from A's position.

namespace manifuzz {
namespace {

/// epa_tolerance and mpr_tolerance of CCD_INIT.
constexpr double kTolerance = 1e-4;

/// The mean of a core's vertices: the centre that the adapter gives.
Vector2<double> centre_of(const exact::RoughPolygon& core) {
  Vector2<double> sum(0, 0);
  for (int i = 0; i < core.count; ++i) sum += core.vertices[i];
  return sum / core.count;
}

/// Whether the translation ends on a chord of the difference that is perpendicular to it, and from
/// which its farthest corner is nearer than the root of the tolerance.
bool is_last_corner_near(const ledger_of::Difference& difference,
                         const Vector2<double>& translation, double bound) {
  const Vector2<double> corner = difference.farthest(translation);
  return (corner - translation).dot(translation.normalized()) <= std::sqrt(kTolerance) + bound;
}

}  // namespace

bool tolerance_of_squares(const Deviation& d) {
  if (d.got.count == 0) return false;
  const ledger_of::Difference difference(d.right.pair());
  const Vector2<double> translation = ledger_of::translation_of(d);
  const double depth = translation.norm();
  const double bound = 4 * d.right.bounds.separation;
  if (depth <= bound || depth > ledger_of::least_depth(d) + bound) return false;
  // What nextSupport compares with the tolerance: the corner along the witness, less the witness.
  const double beyond = difference.reach(translation) - depth * depth;
  if (beyond < kTolerance + bound * depth) return true;
  return is_last_corner_near(difference, translation, bound);
}

bool translation_to_face_of_ray(const Deviation& d) {
  if (d.got.count == 0) return false;
  const ledger_of::Difference difference(d.right.pair());
  const exact::RoughPair placed = exact::place_roughly(d.right.pair());
  const Vector2<double> middle = centre_of(placed.a) - centre_of(placed.b);
  const Vector2<double> translation = ledger_of::translation_of(d);
  const double bound = kTolerance + 4 * d.right.bounds.separation;
  const auto& corners = difference.corners();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vector2<double> from = corners[i];
    const Vector2<double> along = difference.after(i) - from;
    const Vector2<double> outward = Vector2<double>(along.y(), -along.x()).normalized();
    // Where the ray from the middle through the origin is on the face's line.
    const double run = outward.dot(-middle);
    if (run <= 0) continue;
    const double share = outward.dot(from - middle) / run;
    const Vector2<double> exit = middle - share * middle;
    if (ledger_of::distance_to_segment(exit, from, difference.after(i)) > bound) continue;
    if (ledger_of::distance_to_segment(translation, from, difference.after(i)) <= bound)
      return true;
  }
  return false;
}

}  // namespace manifuzz
