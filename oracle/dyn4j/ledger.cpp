#include <algorithm>
#include <cmath>

#include "engines/engine.hpp"
#include "exact/curve.hpp"
#include "judging/faults/differences.hpp"
#include "judging/faults/replayed.hpp"
#include "judging/faults/shared_faults.hpp"
#include "oracle/dyn4j/detectors.hpp"

// dyn4j, whose Sat or Gjk finds a normal and a depth: its operations are repeated in its own scalar
// and order, and give the answer; with the named fault mended they give a right one.

namespace manifuzz {
namespace {

using as_dyn4j::FaultOfDyn4j;
using replayed::has;

using DetectorOfDyn4j = as_dyn4j::Found (*)(const as_dyn4j::Placed&, const as_dyn4j::Placed&);

/// Normal and depth are not those of the least depth.
constexpr unsigned kFaultOfDetector = 1;
constexpr unsigned kFaultsOfDyn4j = 127;

/// As Dyn4j.java declares it.
Declaration as_declared_by_dyn4j(unsigned mended) {
  Declaration declaration;
  declaration.scalar = ScalarType::float64;
  declaration.frame = RoundingFrame::world;
  declaration.min_vertices = 1;
  declaration.takes_radius = false;
  // Capsule.EDGE_FEATURE_SELECTION_CRITERIA
  if (!has(mended, FaultOfDyn4j::any_angle)) declaration.second_point = {0.98};
  return declaration;
}

/// The engine's operations on a case, once more.
class ByDyn4j {
 public:
  ByDyn4j(const Deviation& deviation, DetectorOfDyn4j detector)
      : deviation_(deviation),
        a_(deviation.right.pair().a),
        b_(deviation.right.pair().b),
        found_(detector(a_, b_)) {}

  const as_dyn4j::Found& found() const { return found_; }
  bool is_same_answer() const { return replayed::is_same_answer(deviation_, answer_with(0)); }
  bool needs(unsigned fault) const {
    return is_same_answer() && replayed::is_needed(fault, kFaultsOfDyn4j, [&](unsigned mended) {
             return replayed::is_right_answer(deviation_, as_declared_by_dyn4j(mended),
                                              answer_with(mended));
           });
  }

 private:
  replayed::Contact answer_with(unsigned mended) const {
    as_dyn4j::Found found = found_;
    if ((mended & kFaultOfDetector) != 0) {
      found.depth = ledger_of::least_depth(deviation_);
      found.touches = found.depth >= 0;
      found.normal = replayed::least_normal_near(deviation_, found.normal);
    }
    if (!found.touches) return {};
    return as_dyn4j::clipped_by_dyn4j(found, a_, b_, mended);
  }

  const Deviation& deviation_;
  as_dyn4j::Placed a_;
  as_dyn4j::Placed b_;
  as_dyn4j::Found found_;
};

as_dyn4j::Found found_by_gjk(const as_dyn4j::Placed& a, const as_dyn4j::Placed& b) {
  return as_dyn4j::by_gjk(a, b);
}

/// Whether the detector is at fault, having ended so.
bool is_fault_of_detector(const Deviation& d, DetectorOfDyn4j detector, as_dyn4j::End end) {
  const ByDyn4j replayed(d, detector);
  return replayed.found().end == end && replayed.needs(kFaultOfDetector);
}

/// Whether Epa ended within its epsilon of the least depth.
bool is_within_epsilon(const Deviation& d, const as_dyn4j::Found& found) {
  const double excess = found.depth - ledger_of::least_depth(d);
  const double bound = 2 * d.right.bounds.separation;
  return found.end == as_dyn4j::End::epsilon && excess >= -bound &&
         excess <= std::sqrt(as_dyn4j::kEpsilon) + bound;
}

/// Whether the detector was right within what it is known for, and the edges that tie are not.
bool is_lost_by_edges(const Deviation& d, DetectorOfDyn4j detector) {
  if (!no_contact_on_tied_features(d)) return false;
  const ByDyn4j replayed(d, detector);
  return replayed.found().touches &&
         std::abs(replayed.found().depth - ledger_of::least_depth(d)) <=
             std::sqrt(as_dyn4j::kEpsilon) + 2 * d.right.bounds.separation &&
         replayed.is_same_answer();
}

/// Whether the reference edge's ends are placed where it has no length, and so no normal, though
/// the detector was right.
bool is_edge_placed_without_length(const Deviation& d, DetectorOfDyn4j detector) {
  if (d.got.count == 0 || !d.got.normal.isZero(0) || is_round(d.right.pair())) return false;
  const ByDyn4j replayed(d, detector);
  return replayed.is_same_answer() &&
         std::abs(replayed.found().depth - ledger_of::least_depth(d)) <=
             2 * d.right.bounds.separation;
}

/// D at a detector's normal.
double depth_along(const Deviation& d, const Vector2<double>& normal) {
  return exact::Along(*d.right.truth, local_normal(d.right.pair(), normal)).depth();
}

/// Sat: the least overlap is on the other side than the centres, which decide for the sign.
bool sign_by_centres_in_dyn4j(const Deviation& d) {
  const ByDyn4j replayed(d, as_dyn4j::by_axes);
  const as_dyn4j::Found& found = replayed.found();
  if (found.end != as_dyn4j::End::axes) return false;
  const double bound = 2 * d.right.bounds.separation;
  return depth_along(d, found.normal) > found.depth + bound &&
         std::abs(depth_along(d, -found.normal) - found.depth) <= bound &&
         replayed.needs(kFaultOfDetector);
}

/// Sat: of axes whose overlaps are equal within rounding it takes the first.
bool first_of_equal_axes_in_dyn4j(const Deviation& d) {
  const ByDyn4j replayed(d, as_dyn4j::by_axes);
  if (replayed.found().end != as_dyn4j::End::axes || !replayed.needs(kFaultOfDetector))
    return false;
  const auto all = as_dyn4j::overlaps_along_axes(as_dyn4j::Placed(d.right.pair().a),
                                                 as_dyn4j::Placed(d.right.pair().b));
  const Bounds& bounds = d.right.bounds;
  // An axis between places is off by their roundings over the distance between them.
  const double apart = std::abs(total_radius(d.right.pair()) - ledger_of::least_depth(d));
  const double off = 2 * bounds.normal + (apart > 0 ? 4 * bounds.separation / apart : 0);
  return std::ranges::any_of(all, [&](const as_dyn4j::Found& other) {
    const Vector2<double> least = replayed::least_normal_near(d, other.normal);
    return (other.normal - least).norm() <= off &&
           other.depth <= replayed.found().depth + 2 * bounds.separation;
  });
}

/// CircleDetector: a difference of centres that is not longer than Epsilon.E is not normalised.
bool no_normal_of_one_centre_in_dyn4j(const Deviation& d) {
  const ByDyn4j replayed(d, as_dyn4j::by_axes);
  const as_dyn4j::Found& found = replayed.found();
  return found.end == as_dyn4j::End::circles && found.normal.norm() <= as_dyn4j::kEpsilon &&
         replayed.needs(kFaultOfDetector);
}

/// Epa: it ends where the next point is nearer than the root of Epsilon.E.
bool epa_within_epsilon_in_dyn4j(const Deviation& d) {
  const ByDyn4j replayed(d, found_by_gjk);
  return is_within_epsilon(d, replayed.found()) && replayed.needs(kFaultOfDetector);
}

/// Gjk: a direction of short edges is taken for 0, its square being compared with Epsilon.E: the
/// edge's left side is searched, wherever the origin lies.
bool gjk_direction_within_epsilon_in_dyn4j(const Deviation& d) {
  const ByDyn4j replayed(d, found_by_gjk);
  const as_dyn4j::Found mended =
      as_dyn4j::by_gjk(as_dyn4j::Placed(d.right.pair().a), as_dyn4j::Placed(d.right.pair().b), 0);
  const bool is_mended = mended.touches ? is_within_epsilon(d, mended)
                                        : ledger_of::least_depth(d) <= d.right.bounds.separation;
  return is_mended && !is_within_epsilon(d, replayed.found()) && replayed.needs(kFaultOfDetector);
}

/// Gjk: a direction of short edges is taken for 0 though the shapes are apart: Epa then finds the
/// gap between them, as a depth below 0.
bool gjk_depth_below_0_in_dyn4j(const LostAnswer& lost) {
  const Manifold<double>* const got = manifold_in(lost.answer);
  if (lost.how != Lost::How::malformed || got == nullptr || got->count == 0) return false;
  const as_dyn4j::Placed a(lost.pair.a);
  const as_dyn4j::Placed b(lost.pair.b);
  if (as_dyn4j::by_gjk(a, b, 0).touches) return false;
  const as_dyn4j::Found found = found_by_gjk(a, b);
  if (!found.touches) return false;
  const replayed::Contact contact = as_dyn4j::clipped_by_dyn4j(found, a, b, 0);
  return std::ssize(contact.points) == got->count && contact.points[0].depth < 0 &&
         got->points[0].depth == contact.points[0].depth;
}

/// Epa: a point is found twice, and the edge between both has no length and no normal.
bool epa_edge_of_no_length_in_dyn4j(const Deviation& d) {
  const ByDyn4j replayed(d, found_by_gjk);
  const as_dyn4j::Found& found = replayed.found();
  return found.end == as_dyn4j::End::epsilon && found.normal.norm() <= as_dyn4j::kEpsilon &&
         replayed.needs(kFaultOfDetector);
}

/// Epa: it ends after 100 iterations.
bool epa_after_iterations_in_dyn4j(const Deviation& d) {
  return is_fault_of_detector(d, found_by_gjk, as_dyn4j::End::iterations);
}

/// Gjk: it finds them apart.
bool gjk_apart_in_dyn4j(const Deviation& d) {
  return is_fault_of_detector(d, found_by_gjk, as_dyn4j::End::apart);
}

/// ClippingManifoldSolver: of edges that tie it takes one that misses the other's slab.
template <DetectorOfDyn4j kDetector>
bool edges_tie_in_dyn4j(const Deviation& d) {
  return is_lost_by_edges(d, kDetector);
}

template <DetectorOfDyn4j kDetector, FaultOfDyn4j kFault>
bool fault_of_dyn4j(const Deviation& d) {
  if (kFault == FaultOfDyn4j::placed_vertices && kDetector == as_dyn4j::by_axes &&
      is_edge_placed_without_length(d, kDetector)) {
    return true;
  }
  return ByDyn4j(d, kDetector).needs(static_cast<unsigned>(kFault));
}

/// What comes after either detector, but for edges that tie.
template <DetectorOfDyn4j kDetector>
constexpr LedgerRow kAfterDyn4jDetector[] = {
    {"one-centre", no_normal_of_one_centre_in_dyn4j},
    {"longer-capsule", fault_of_dyn4j<kDetector, FaultOfDyn4j::longer_capsule>},
    {"placed-vertices", fault_of_dyn4j<kDetector, FaultOfDyn4j::placed_vertices>},
    {"normal-of-edge", fault_of_dyn4j<kDetector, FaultOfDyn4j::normal_of_edge>},
    {"neighbour-by-dot", fault_of_dyn4j<kDetector, FaultOfDyn4j::neighbour_by_dot>},
    {"longer-edges", fault_of_dyn4j<kDetector, FaultOfDyn4j::longer_edges>},
    {"any-angle", fault_of_dyn4j<kDetector, FaultOfDyn4j::any_angle>},
};

constexpr LedgerRow kFirstOfDyn4jSat[] = {{"sign-by-centres", sign_by_centres_in_dyn4j}};
constexpr LedgerRow kLastOfDyn4jSat[] = {
    {"first-of-equal-axes", first_of_equal_axes_in_dyn4j},
    {"tied-edges", edges_tie_in_dyn4j<as_dyn4j::by_axes>},
};
constexpr LedgerRow kFirstOfDyn4jGjk[] = {
    {"epa-within-epsilon", epa_within_epsilon_in_dyn4j},
    {"direction-within-epsilon", gjk_direction_within_epsilon_in_dyn4j, gjk_depth_below_0_in_dyn4j},
    {"epa-edge-of-no-length", epa_edge_of_no_length_in_dyn4j},
    {"epa-iterations", epa_after_iterations_in_dyn4j},
    {"apart", gjk_apart_in_dyn4j},
};
constexpr LedgerRow kLastOfDyn4jGjk[] = {{"tied-edges", edges_tie_in_dyn4j<found_by_gjk>}};

}  // namespace

Engine engine_dyn4j() {
  return {.name = "dyn4j",
          .ledger = {{"dyn4j-sat", kFirstOfDyn4jSat},
                     {"dyn4j-sat", kAfterDyn4jDetector<as_dyn4j::by_axes>},
                     {"dyn4j-sat", kLastOfDyn4jSat},
                     {"dyn4j-gjk", kFirstOfDyn4jGjk},
                     {"dyn4j-gjk", kAfterDyn4jDetector<found_by_gjk>},
                     {"dyn4j-gjk", kLastOfDyn4jGjk}}};
}

}  // namespace manifuzz
