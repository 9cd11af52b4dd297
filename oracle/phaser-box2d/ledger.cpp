#include <algorithm>
#include <cmath>

#include "engines/engine.hpp"
#include "exact/curve.hpp"
#include "judging/faults/circle_faults.hpp"
#include "judging/faults/shared_faults.hpp"
#include "judging/manifold_error.hpp"
#include "oracle/box2d3/capsule_editions.hpp"
#include "oracle/phaser-box2d/polygons.hpp"

// phaser-box2d: what it makes of the case is computed in double.

namespace manifuzz {

using namespace ledger_of;

namespace {

constexpr double kEpsilonOfPhaserFaces = 1e-10;

/// Two capsules: the answer is what b2CollideCapsules makes with u1X for u2X and
/// the greater of two ends for the lesser, and not what it makes without.
bool slips_in_phaser_capsules(const Deviation& d) {
  const auto cores = capsule_cores(d.right.pair());
  if (!cores) return false;
  const double radius = total_radius(d.right.pair());
  return is_given(d, capsules_by_phaser((*cores)[0], (*cores)[1], radius, false), as_rounded(d)) &&
         !is_given(d, capsules_by_phaser((*cores)[0], (*cores)[1], radius, true), as_about(d));
}

/// Two capsules: the answer is what b2CollideCapsules makes with or without these:
/// an edge's normal within 0.005 of the distance, points clipped along it, and one point alone
/// where a core's ends are both beyond the other's.
bool slop_in_phaser_capsules(const Deviation& d) {
  const auto cores = capsule_cores(d.right.pair());
  if (!cores) return false;
  const FoundByPhaser found =
      capsules_by_phaser((*cores)[0], (*cores)[1], total_radius(d.right.pair()), false);
  // No contact is the slop's doing only where it let the edges be clipped.
  return (d.got.count > 0 || found.is_clipped) && is_given(d, found, as_rounded(d));
}

/// Two capsules whose cores are apart: the normal is the direction between their
/// nearest places as doubles have them, off by their roundings over the distance.
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

/// A circle whose centre is within 1e-10 of another core: the normal has no length.
bool no_normal_within_phaser_epsilon(const Deviation& d) {
  return has_no_normal_within(d, kEpsilonOfPhaser, ledger_of::least_depth(d));
}

/// A circle whose centre is within 1e-10 of a polygon: the normal is a face's, beyond its corner
/// too.
bool face_within_phaser_epsilon(const Deviation& d) {
  return ledger_of::is_face_within(d, kEpsilonOfPhaserFaces);
}

/// An incident edge that misses the slab, prolonged to it: a point off the polygon, or contact
/// across a gap.
bool edge_extended_to_slab(const Deviation& d) {
  const bool fits = d.kind == Kind::position || d.kind == Kind::depth || d.kind == Kind::count ||
                    d.kind == Kind::phantom_contact;
  const Bounds& bounds = d.right.bounds;
  const auto misses = [&](const exact::Clip* clip) {
    return compare_gap(*clip, -bounds.separation) > 0;
  };
  return fits && (std::ranges::any_of(clips_within(*d.right.truth, Side::a, bounds), misses) ||
                  std::ranges::any_of(clips_within(*d.right.truth, Side::b, bounds), misses));
}

/// The incident edge, along the reference face, is too short to be clipped.
bool incident_edge_unclipped(const Deviation& d) {
  constexpr double too_short = 1e-10;  // manifold_c.js: eps
  const bool fits = d.kind == Kind::position || d.kind == Kind::depth || d.kind == Kind::count;
  return fits && any_candidate(d, [](const exact::Clip& clip) {
           return clip.edge_length * clip.cosine <= too_short;
         });
}

constexpr LedgerRow kPhaserBox2dRows[] = {
    {"capsule-slips", slips_in_phaser_capsules},
    {"direction-of-rounded-places", direction_of_rounded_places},
    {"capsule-slop", slop_in_phaser_capsules},
    {"no-normal-within-epsilon", no_normal_within_phaser_epsilon},
    {"face-within-epsilon", face_within_phaser_epsilon},
    {"face-within-slop", face_within_phaser_slop},
    {"nearest-by-roundings", nearest_by_phaser_roundings},
    {"normal-over-rounded-distance", normal_over_rounded_distance},
    {"one-point-between-corners", one_point_between_corners},
    {"direction-of-roundings", direction_to_place_on_segment},
    {"edge-extended-to-slab", edge_extended_to_slab},
    {"no-contact-on-tied-features", no_contact_on_tied_features},
    {"tiny-edge-unclipped", incident_edge_unclipped},
    {"circle-tied-faces", ledger_of::is_end_of_tied_face},
};

}  // namespace

Engine engine_phaser_box2d() {
  return {.name = "phaser-box2d", .ledger = {{"phaser-box2d", kPhaserBox2dRows}}};
}

}  // namespace manifuzz
