#include <cmath>

#include "exact/curve.hpp"
#include "judging/faults/epsilon_deviations.hpp"
#include "oracle/box2d3/capsule_editions.hpp"
#include "oracle/phaser-box2d/deviations.hpp"

// phaser-box2d on circles and capsules.

namespace manifuzz {

using namespace ledger_of;

namespace {

constexpr double kEpsilonOfPhaserFaces = 1e-10;

}  // namespace

bool slips_in_phaser_capsules(const Deviation& d) {
  const auto cores = capsule_cores(d.right.pair());
  if (!cores) return false;
  const double radius = total_radius(d.right.pair());
  return is_given(d, capsules_by_phaser((*cores)[0], (*cores)[1], radius, false), as_rounded(d)) &&
         !is_given(d, capsules_by_phaser((*cores)[0], (*cores)[1], radius, true), as_about(d));
}

bool slop_in_phaser_capsules(const Deviation& d) {
  const auto cores = capsule_cores(d.right.pair());
  if (!cores) return false;
  const FoundByPhaser found =
      capsules_by_phaser((*cores)[0], (*cores)[1], total_radius(d.right.pair()), false);
  // No contact is the slop's doing only where it let the edges be clipped.
  return (d.got.count > 0 || found.is_clipped) && is_given(d, found, as_rounded(d));
}

bool direction_of_rounded_places(const Deviation& d) {
  const auto cores = capsule_cores(d.right.pair());
  // A missing point is another fault's, however the normal is rounded.
  if (!cores || d.got.count != 1 || d.kind == Kind::count) return false;
  const Bounds& bounds = d.right.bounds;
  const FoundByPhaser found =
      capsules_by_phaser((*cores)[0], (*cores)[1], total_radius(d.right.pair()), false);
  if (found.is_clipped || !is_given(d, found, as_rounded(d))) return false;
  const exact::PenetrationCurve curve(*d.right.truth, exact::Skin::round);
  if (!curve.are_cores_apart()) return false;
  const double distance = total_radius(d.right.pair()) - curve.least();
  const double off = (found.normal - curve.minima(0).front()).norm();
  return off > bounds.normal / 2 && off * distance <= 4 * bounds.separation;
}

bool no_normal_within_phaser_epsilon(const Deviation& d) {
  return has_no_normal_within(d, kEpsilonOfPhaser, ledger_of::least_depth(d));
}

bool face_within_phaser_epsilon(const Deviation& d) {
  return ledger_of::is_face_within(d, kEpsilonOfPhaserFaces);
}

}  // namespace manifuzz
