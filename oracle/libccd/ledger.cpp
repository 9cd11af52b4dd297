#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "engines/engine.hpp"
#include "exact/rational.hpp"
#include "judging/faults/differences.hpp"
#include "oracle/libccd/ledger/deviations.hpp"
#include "oracle/libccd/ledger/polytope.hpp"
#include "oracle/libccd/ledger/portal.hpp"
#include "oracle/libccd/libccd_pass.hpp"

// ccdGJKPenetration and ccdMPRPenetration are repeated in their own doubles, in space: the answer
// is that of the repeated one, which ended as named.

namespace manifuzz {
namespace {

using ledger_of::CcdAnswer;
using ledger_of::CcdEnd;
using ledger_of::CcdPortalAnswer;
using ledger_of::CcdPortalEnd;
using ledger_of::CcdTetrahedron;
using ledger_of::CcdVector;

/// epa_tolerance of CCD_INIT.
constexpr double kToleranceOfEpa = 1e-4;

/// Whether it is what was answered, in the plane.
bool is_said_by_ccd(const Deviation& d, const CcdAnswer& answer) {
  if (d.got.count == 0 || answer.end == CcdEnd::none) return false;
  // Its direction is the element's place over its length, and its depth this length.
  const Vector2<double> translation(answer.nearest.place.x(), answer.nearest.place.y());
  return (ledger_of::translation_of(d) - translation).norm() <= 4 * d.right.bounds.separation;
}

using ExactPlace = std::array<exact::Rational, 3>;

ExactPlace exactly(const CcdVector& v) {
  return {v.x(), v.y(), v.z()};
}

ExactPlace less(const ExactPlace& v, const ExactPlace& by) {
  return {v[0] - by[0], v[1] - by[1], v[2] - by[2]};
}

/// The sign of the volume that three vectors span, exactly.
int side_of(const ExactPlace& a, const ExactPlace& b, const ExactPlace& c) {
  const exact::Rational volume = a[0] * (b[1] * c[2] - b[2] * c[1]) -
                                 a[1] * (b[0] * c[2] - b[2] * c[0]) +
                                 a[2] * (b[0] * c[1] - b[1] * c[0]);
  return volume.sign();
}

/// Which way its corners turn; 0 of a flat one.
int turn_of(const CcdTetrahedron& corners) {
  const ExactPlace a = exactly(corners[0]);
  return side_of(less(exactly(corners[1]), a), less(exactly(corners[2]), a),
                 less(exactly(corners[3]), a));
}

/// Whether the origin is within a tetrahedron, exactly: not on its surface, but perhaps on a side
/// that is off a corner from `first_shared` on.
bool is_around_origin(const CcdTetrahedron& corners, std::size_t first_shared) {
  const ExactPlace a = exactly(corners[0]);
  const ExactPlace b = exactly(corners[1]);
  const ExactPlace c = exactly(corners[2]);
  const ExactPlace d = exactly(corners[3]);
  const std::array sides{side_of(b, c, d), -side_of(a, c, d), side_of(a, b, d), -side_of(a, b, c)};
  const auto shared = sides.begin() + static_cast<std::ptrdiff_t>(first_shared);
  const auto is_inside = [&](int side) { return side == sides[0]; };
  return sides[0] != 0 && std::all_of(sides.begin(), shared, is_inside) &&
         std::all_of(shared, sides.end(), [&](int side) { return side == 0 || is_inside(side); });
}

/// Whether the origin is within the tetrahedra of which the first polytope is made, exactly: not on
/// its surface, but perhaps on a side that two of them share.
bool holds_origin(const std::vector<CcdTetrahedron>& first) {
  // Two share the side that the last corner is off, four those that the last two are off.
  const std::size_t first_shared = first.size() == 1 ? 4 : first.size() == 2 ? 3 : 2;
  return std::ranges::any_of(first, [&](const CcdTetrahedron& corners) {
    return is_around_origin(corners, first_shared);
  });
}

/// What another predicate looks for, where the answer is the repeated one.
bool is_of_ccd(const Deviation& d) {
  const CcdAnswer answer = ledger_of::ccd_penetration(d.right.pair());
  return d.got.count == 0 ? answer.end == CcdEnd::none : is_said_by_ccd(d, answer);
}

template <bool (*kExplains)(const Deviation&)>
bool by_ccd(const Deviation& d) {
  return kExplains(d) && is_of_ccd(d);
}

/// nextSupport compared the tolerance, a length, with a product or a square of lengths that was
/// below it, though what they are of is longer: an element inside the difference.
bool polytope_left_by_squares(const Deviation& d) {
  const CcdAnswer answer = ledger_of::ccd_penetration(d.right.pair());
  const double length = answer.end == CcdEnd::along
                            ? answer.beyond / std::sqrt(answer.nearest.square)
                            : std::sqrt(answer.beyond);
  const bool is_by_tolerance = answer.end == CcdEnd::along || answer.end == CcdEnd::near;
  return is_by_tolerance && length >= kToleranceOfEpa && is_said_by_ccd(d, answer);
}

/// The corner that it asked for next is one of the element's own, within the tolerance: expansion
/// replaces one triangle, which leaves the polytope not convex.
bool polytope_left_at_own_corner(const Deviation& d) {
  const CcdAnswer answer = ledger_of::ccd_penetration(d.right.pair());
  // A square below 0 is one of roundings.
  return answer.end == CcdEnd::near && answer.beyond < kToleranceOfEpa * kToleranceOfEpa &&
         is_said_by_ccd(d, answer);
}

/// The repeated query ended so, for an element inside the difference: one that the origin is on, or
/// a simplex that touches it and was taken for the boundary.
template <CcdEnd kEnd>
bool polytope_left(const Deviation& d) {
  const CcdAnswer answer = ledger_of::ccd_penetration(d.right.pair());
  return answer.end == kEnd && is_said_by_ccd(d, answer);
}

/// The polytope that it begins with does not hold the origin, or has it on its surface: the steps
/// of GJK compare sums that are rounded by more than CCD_EPS.
bool polytope_without_origin(const Deviation& d) {
  const CcdAnswer answer = ledger_of::ccd_penetration(d.right.pair());
  return !answer.first.empty() && !holds_origin(answer.first) && is_said_by_ccd(d, answer);
}

/// Epa stops at a polytope about two corners: the four others do not go round the line between
/// them, so that its triangles are folded.
bool polytope_folded(const Deviation& d) {
  const CcdAnswer answer = ledger_of::ccd_penetration(d.right.pair());
  if (answer.first.size() < 4 || !is_said_by_ccd(d, answer)) return false;
  std::array<int, 4> turns{};
  std::ranges::transform(answer.first, turns.begin(), turn_of);
  return turns[0] == 0 || std::ranges::count(turns, turns[0]) < 4;
}

/// A polytope that held the origin does so no more: along its place, which is rounded, a corner on
/// the inner side of a triangle seemed to be beyond it, and the tetrahedron of both, around the
/// origin, was taken off.
bool polytope_expanded_inwards(const Deviation& d) {
  const CcdAnswer answer = ledger_of::ccd_penetration(d.right.pair());
  if (!holds_origin(answer.first) || !is_said_by_ccd(d, answer)) return false;
  // A second one would put it back.
  const auto around = std::ranges::count_if(answer.expanded, [](const CcdTetrahedron& corners) {
    return is_around_origin(corners, corners.size());
  });
  return around % 2 == 1;
}

/// No contact: a tetrahedron seems flat, or a direction of no length, by a square below CCD_EPS.
bool apart_by_zero(const Deviation& d) {
  return d.got.count == 0 && ledger_of::is_ccd_apart_by_zero(d.right.pair());
}

/// The nearest element is the origin itself, and ccdGJKPenetration divides its place by its length.
bool direction_of_no_length(const LostAnswer& lost) {
  const auto* const said = std::get_if<Penetration>(&lost.answer);
  if (lost.how != Lost::How::malformed || said == nullptr || !said->touches) return false;
  const CcdAnswer answer = ledger_of::ccd_penetration(lost.pair);
  const CcdVector& place = answer.nearest.place;
  return (answer.end == CcdEnd::zero || answer.end == CcdEnd::touching) &&
         ledger_of::ccd_dot(place, place) == 0;
}

/// Expansions repeat themselves, and nothing counts them.
bool polytope_expanded_for_ever(const LostAnswer& lost) {
  return lost.how == Lost::How::timed_out &&
         ledger_of::ccd_penetration(lost.pair).end == CcdEnd::endless;
}

/// Whether it is what was answered, in the plane.
bool is_said_by_portal(const Deviation& d, const CcdPortalAnswer& answer) {
  if (d.got.count == 0) return false;
  const Vector2<double> translation(answer.translation.x(), answer.translation.y());
  return (ledger_of::translation_of(d) - translation).norm() <= 4 * d.right.bounds.separation;
}

/// The repeated query ended so, with the translation to an edge or a corner of the last portal, or
/// not.
template <CcdPortalEnd kEnd, bool kIsOnEdge>
bool portal_left(const Deviation& d) {
  const CcdPortalAnswer answer = ledger_of::ccd_portal_penetration(d.right.pair());
  return answer.end == kEnd && answer.is_on_edge == kIsOnEdge && is_said_by_portal(d, answer);
}

constexpr LedgerRow kGjkRows[] = {
    {"zero-of-squares", by_ccd<zero_of_squares>},
    {"tolerance-of-squares", by_ccd<tolerance_of_squares>},
    {"left-by-squares", polytope_left_by_squares},
    {"left-at-own-corner", polytope_left_at_own_corner},
    {"left-at-zero", polytope_left<CcdEnd::zero>},
    {"left-touching", polytope_left<CcdEnd::touching>},
    {"without-origin", polytope_without_origin},
    {"folded", polytope_folded},
    {"expanded-inwards", polytope_expanded_inwards},
    {"apart-by-zero", apart_by_zero},
    {"no-direction", nullptr, direction_of_no_length},
    {"endless", nullptr, polytope_expanded_for_ever},
};

constexpr LedgerRow kMprRows[] = {
    // The last portal, through which the ray from the middle leaves, is within the tolerance of the
    // boundary: the translation is at right angles to it, and ends within it.
    {"face-of-ray", portal_left<CcdPortalEnd::tolerance, false>},
    // The origin is on the segment from the difference's middle to its corner that is farthest
    // beyond it, or is that middle. The translation is to this corner, not to the face that it is
    // on.
    {"corner-of-ray", portal_left<CcdPortalEnd::segment, false>},
    // The foot of the origin is beside the last portal, one triangle.
    {"edge-of-portal", portal_left<CcdPortalEnd::tolerance, true>},
};

}  // namespace

Engine engine_libccd() {
  Engine engine{.name = "libccd", .ledger = {{"libccd-gjk", kGjkRows}, {"libccd-mpr", kMprRows}}};
#ifdef MANIFUZZ_WITH_CCD
  engine.passes = {{"libccd-gjk", "libccd-gjk", "closest points", libccd_gjk_pass},
                   {"libccd-mpr", "libccd-mpr", "closest points", libccd_mpr_pass}};
#endif
  return engine;
}

}  // namespace manifuzz
