#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "engines/engine.hpp"
#include "exact/curve.hpp"
#include "exact/placed.hpp"
#include "judging/faults/differences.hpp"
#include "judging/faults/shared_faults.hpp"
#include "oracle/box2d3/capsule_editions.hpp"
#include "oracle/box2d3/circles.hpp"
#include "oracle/box2d3/replay.hpp"

// Box2D 3.2 on shapes with edges, and its table of causes.

namespace manifuzz {
namespace {

/// What it finds of two shapes with edges, if that is the answer: the same floats, but for their
/// way through the world, by a rotation that is not unit.
std::optional<ledger_of::ContactOfBox2d3> found_by_box2d3(const Deviation& d) {
  const PairCase& pair = d.right.pair();
  const Bounds& bounds = d.right.bounds;
  auto found = ledger_of::contact_of_box2d3(pair);
  if (!found || d.got.count != static_cast<int>(found->points.size())) return std::nullopt;
  const Vector2<double> turn = pair.a.pose.rotation.cast<double>().normalized();
  if (d.got.count > 0 &&
      (rotate<double>(turn, d.got.normal) - found->normal).norm() > bounds.normal) {
    return std::nullopt;
  }
  // The judge has moved the points of two sharp polygons to the incident edge.
  const auto is_same = [&](const ContactPoint<double>& p,
                           const ledger_of::ContactOfBox2d3::Point& q) {
    return std::abs(p.depth - q.depth) <= bounds.separation &&
           (!is_round(pair) || (to_world(pair, p.position) - q.at).norm() <= bounds.position);
  };
  const auto is_given = [&](const ledger_of::ContactOfBox2d3::Point& q) {
    return std::any_of(d.got.points.begin(), d.got.points.begin() + d.got.count,
                       [&](const ContactPoint<double>& p) { return is_same(p, q); });
  };
  if (!std::ranges::all_of(found->points, is_given)) return std::nullopt;
  return found;
}

/// Whether round shapes' cores are apart, and nearest at a vertex of each.
bool are_nearest_at_vertices(const Deviation& d) {
  if (!is_round(d.right.pair())) return false;
  const exact::PenetrationCurve curve(*d.right.truth, exact::Skin::round);
  return curve.are_cores_apart() && curve.nearest_vertices().has_value();
}

/// Two capsules: the answer is what b2CollideCapsules makes, which is as
/// phaser-box2d's without the slips, but that A's edge is kept up to 0.0005.
bool slop_in_box2d3_capsules(const Deviation& d) {
  const PairCase& pair = d.right.pair();
  const auto cores = ledger_of::capsule_cores(pair);
  if (!cores) return false;
  // b2CollideSegmentAndCapsule has the segment first.
  const bool is_swapped = pair.a.polygon.radius > 0 && pair.b.polygon.radius == 0;
  ledger_of::FoundByPhaser found = ledger_of::capsules_by_phaser(
      (*cores)[is_swapped ? 1 : 0], (*cores)[is_swapped ? 0 : 1], total_radius(pair), true,
      {0.1 * ledger_of::kSlopOfPhaser, ledger_of::kEpsilonOfBox2d3});
  if (is_swapped) found.normal = -found.normal;
  return (d.got.count > 0 || found.is_clipped) &&
         ledger_of::is_given(d, found, ledger_of::as_rounded(d));
}

/// No contact though corners with radii overlap: no face of either core is farther than 0.0005,
/// and the incident edge is beyond the reference face's ends.
bool corner_beyond_slab(const Deviation& d) {
  const auto found = found_by_box2d3(d);
  return found && d.got.count == 0 && found->is_disjoint && !found->are_apart &&
         ledger_of::least_depth(d) > d.right.bounds.separation;
}

/// Whether the answer's normal is that of a face to which several edges are alike in float.
bool is_of_tied_incidents(const Deviation& d, const Vector2<double>& normal) {
  const Bounds& bounds = d.right.bounds;
  const exact::RoughPair placed = exact::place_roughly(d.right.truth->stored());
  for (const Side side : {Side::a, Side::b}) {
    const Vector2<double> out = side == Side::a ? normal : Vector2<double>(-normal);
    for (int i = 0; i < d.right.pair()[side].polygon.face_count(); ++i) {
      if ((placed[side].normals[i] - out).norm() > 2 * bounds.normal) continue;
      if (d.right.truth->incident_edges({side, i}, bounds.incident_dot).size() > 1) return true;
    }
  }
  return false;
}

/// A round pair with a polygon: of edges that tie as incident one is clipped that has not the
/// deepest vertex, so that the answer is less deep than any direction allows.
bool tied_incident_of_box2d3(const Deviation& d) {
  const auto found = found_by_box2d3(d);
  if (!found || found->is_of_capsules || !found->is_clipped || d.got.count == 0) return false;
  double deepest = 0;
  for (int i = 0; i < d.got.count; ++i) deepest = std::max(deepest, d.got.points[i].depth);
  return deepest < ledger_of::least_depth(d) - d.right.bounds.separation &&
         is_of_tied_incidents(d, found->normal);
}

/// Two capsules: with the slop, the bias to A's edge and the one point that doubles have too.
bool capsules_of_box2d3(const Deviation& d) {
  return found_by_box2d3(d) && slop_in_box2d3_capsules(d);
}

/// Two capsules: floats decide otherwise than doubles which side, end or place is nearer, or make
/// another normal of the direction between nearest places.
bool roundings_in_box2d3_capsules(const Deviation& d) {
  const auto found = found_by_box2d3(d);
  return found && found->is_of_capsules && !slop_in_box2d3_capsules(d);
}

/// A round pair with a polygon: edges are clipped along a face's normal though a vertex of each is
/// nearer.
bool face_within_box2d3_slop(const Deviation& d) {
  const auto found = found_by_box2d3(d);
  return found && !found->is_of_capsules && found->is_clipped && are_nearest_at_vertices(d);
}

/// The normal between two corners is their difference over the distance of the same places as
/// shares of their edges give them: not unit, by the roundings of these over the distance.
bool normal_over_box2d3_distance(const Deviation& d) {
  const auto found = found_by_box2d3(d);
  return found && !found->is_of_capsules && found->are_apart && !found->is_clipped &&
         d.got.count == 1 && std::abs(d.got.normal.norm() - 1) > d.right.bounds.normal;
}

/// An answer that holds no number: the distance of the nearest places is 0, and their difference is
/// divided by it.
bool normal_over_no_distance(const LostAnswer& lost) {
  if (lost.how != Lost::How::malformed) return false;
  const auto found = ledger_of::contact_of_box2d3(lost.pair);
  return found && !found->is_of_capsules && found->are_apart && !found->is_clipped &&
         !found->points.empty() && !found->normal.allFinite();
}

/// An answer that holds no number: of two capsules, the product of both cores' squared lengths is
/// beyond a float, and the nearest places are shares of infinity over infinity.
bool squares_beyond_box2d3_range(const LostAnswer& lost) {
  if (lost.how != Lost::How::malformed) return false;
  const Manifold<double>* const got = manifold_in(lost.answer);
  const auto found = ledger_of::contact_of_box2d3(lost.pair);
  return got != nullptr && got->count == 1 && !got->points[0].position.allFinite() && found &&
         found->is_of_capsules && found->is_beyond_range && found->points.size() == 1 &&
         !found->points[0].at.allFinite();
}

/// The incident edge is shorter along the face than float's epsilon, and not clipped.
bool edge_below_box2d3_epsilon(const Deviation& d) {
  const auto found = found_by_box2d3(d);
  return found && found->is_unclipped;
}

/// No contact: edges that are apart miss each other along the reference face, by roundings, and are
/// nearest, by roundings, not at their ends.
bool neither_clipped_nor_corner(const Deviation& d) {
  const auto found = found_by_box2d3(d);
  return found && d.got.count == 0 && found->is_disjoint && found->are_apart &&
         ledger_of::least_depth(d) > d.right.bounds.separation;
}

constexpr LedgerRow kBox2d3Rows[] = {
    {"no-contact-on-tied-features", no_contact_on_tied_features},
    {"corner-beyond-slab", corner_beyond_slab},
    {"tied-incident", tied_incident_of_box2d3},
    {"capsule-slop", capsules_of_box2d3},
    {"one-point-between-corners", ledger_of::one_point_between_corners},
    {"face-within-slop", face_within_box2d3_slop},
    {"no-normal-within-epsilon", no_normal_within_box2d3_epsilon},
    {"direction-of-rounded-place", direction_of_rounded_place},
    {"capsule-roundings", roundings_in_box2d3_capsules},
    {"normal-over-rounded-distance", normal_over_box2d3_distance},
    {"no-distance", nullptr, normal_over_no_distance},
    {"squares-beyond-float", nullptr, squares_beyond_box2d3_range},
    {"edge-below-epsilon", edge_below_box2d3_epsilon},
    {"neither-clipped-nor-corner", neither_clipped_nor_corner},
    {"circle-tied-faces", corner_of_tied_face},
    {"face-within-epsilon", face_within_box2d3_epsilon},
};

}  // namespace

Engine engine_box2d3() {
  return {.name = "box2d3", .ledger = {{"box2d3", kBox2d3Rows}}};
}

}  // namespace manifuzz
