#pragma once

#include <array>

#include "judging/faults/shared_faults.hpp"
#include "oracle/dyn4j/deviations.hpp"

namespace manifuzz::ledger_of {

/// What both detectors share: what is at fault, in words, and where.
struct FaultWordsOfDyn4j {
  std::string_view description;
  std::string_view source;
  bool is_no_bug = false;  ///< it is meant
};

inline constexpr FaultWordsOfDyn4j kCapsuleEdgeOfDyn4j{
    "points beyond a capsule's core, deeper than there: its edge is longer than it",
    "dyn4j 6.0.0, geometry/Capsule.java, getFarthestFeature: length * 0.5 * "
    "EDGE_FEATURE_EXPANSION_FACTOR",
    true};
inline constexpr FaultWordsOfDyn4j kNormalOfEdgeOfDyn4j{
    "an edge's normal, and depths along it, though cores are nearest along another",
    "dyn4j 6.0.0, collision/manifold/ClippingManifoldSolver.java, getManifold: frontNormal = "
    "refev.getRightHandOrthogonalVector()"};
inline constexpr FaultWordsOfDyn4j kPlacedVerticesOfDyn4j{
    "a normal off by the roundoff of world coordinates over the edge's length: its manifolds are "
    "of placed vertices by design",
    "dyn4j 6.0.0, collision/manifold/ClippingManifoldSolver.java, getManifold: refev = "
    "reference.getEdge(), of placed vertices",
    true};
inline constexpr FaultWordsOfDyn4j kNeighbourByDotOfDyn4j{
    "no contact, or another normal: the neighbour of the right edge clips, their directions being "
    "nearer than a dot can tell",
    "dyn4j 6.0.0, geometry/Polygon.java, getFarthestFeature: leftN.dot(localn) < "
    "rightN.dot(localn)"};
inline constexpr FaultWordsOfDyn4j kLongerEdgesOfDyn4j{
    "no contact, or another normal: of two edges the one clips whose product with the normal is "
    "least, which is the shorter",
    "dyn4j 6.0.0, collision/manifold/ClippingManifoldSolver.java, getManifold: Math.abs(e1.dot(n)) "
    "> Math.abs(e2.dot(n)), of edges that are not unit"};
inline constexpr FaultWordsOfDyn4j kAnyAngleOfDyn4j{
    "a second point beyond the angle at which a capsule has an edge: segments and polygons always "
    "have one",
    "dyn4j 6.0.0, geometry/Segment.java and Polygon.java, getFarthestFeature: an EdgeFeature, "
    "whatever the angle"};
inline constexpr FaultWordsOfDyn4j kOneCentreOfDyn4j{
    "a normal of no length: the centres of two circles are at one place",
    "dyn4j 6.0.0, collision/narrowphase/CircleDetector.java, detect: v.normalize(), which leaves "
    "what is not longer than Epsilon.E"};
inline constexpr FaultWordsOfDyn4j kTiedEdgesOfDyn4j{
    "no contact: of edges that tie, one is kept that misses the other's slab",
    "dyn4j 6.0.0, collision/manifold/ClippingManifoldSolver.java, getManifold: clip1.size() < 2, "
    "clip2.size() < 2"};

/// An entry of a detector on such a fault.
constexpr LedgerEntry of_dyn4j(std::string_view id, std::string_view collider,
                               const FaultWordsOfDyn4j& fault, bool (*explains)(const Deviation&)) {
  return {.id = id,
          .collider = collider,
          .description = fault.description,
          .source = fault.source,
          .explains = explains,
          .is_no_bug = fault.is_no_bug};
}

// dyn4j 6.0.0, in double. Budgets (budgets.json) are twice what 300,000 cases against clip64
// showed, rounded up.

/// The entries, the first that explains before others.
inline constexpr std::array kOfDyn4jSat{
    LedgerEntry{.id = "dyn4j-sat-sign-by-centres",
                .collider = "dyn4j-sat",
                .description = "the normal reversed, or no contact: the centres decide for its "
                               "sign, wherever the least overlap is",
                .source = "dyn4j 6.0.0, collision/narrowphase/Sat.java, detect: cToc.dot(n) < 0",
                .explains = sign_by_centres_in_dyn4j},
    of_dyn4j("dyn4j-sat-one-centre", "dyn4j-sat", kOneCentreOfDyn4j,
             no_normal_of_one_centre_in_dyn4j),
    of_dyn4j("dyn4j-sat-longer-capsule", "dyn4j-sat", kCapsuleEdgeOfDyn4j,
             after_sat_of_dyn4j<FaultOfDyn4j::longer_capsule>),
    of_dyn4j("dyn4j-sat-placed-vertices", "dyn4j-sat", kPlacedVerticesOfDyn4j,
             after_sat_of_dyn4j<FaultOfDyn4j::placed_vertices>),
    of_dyn4j("dyn4j-sat-normal-of-edge", "dyn4j-sat", kNormalOfEdgeOfDyn4j,
             after_sat_of_dyn4j<FaultOfDyn4j::normal_of_edge>),
    of_dyn4j("dyn4j-sat-neighbour-by-dot", "dyn4j-sat", kNeighbourByDotOfDyn4j,
             after_sat_of_dyn4j<FaultOfDyn4j::neighbour_by_dot>),
    of_dyn4j("dyn4j-sat-longer-edges", "dyn4j-sat", kLongerEdgesOfDyn4j,
             after_sat_of_dyn4j<FaultOfDyn4j::longer_edges>),
    of_dyn4j("dyn4j-sat-any-angle", "dyn4j-sat", kAnyAngleOfDyn4j,
             after_sat_of_dyn4j<FaultOfDyn4j::any_angle>),
    LedgerEntry{
        .id = "dyn4j-sat-first-of-equal-axes",
        .collider = "dyn4j-sat",
        .description =
            "another normal of nearly the least depth: the first of axes whose overlaps are equal",
        .source = "dyn4j 6.0.0, collision/narrowphase/Sat.java, detect: o < overlap",
        .explains = first_of_equal_axes_in_dyn4j},
    of_dyn4j("dyn4j-sat-tied-edges", "dyn4j-sat", kTiedEdgesOfDyn4j, edges_tie_after_sat_of_dyn4j),
};

/// The entries on Gjk with Epa, the first that explains before others.
inline constexpr std::array kOfDyn4jGjk{
    LedgerEntry{
        .id = "dyn4j-gjk-epa-within-epsilon",
        .collider = "dyn4j-gjk",
        .description = "more than the least depth, by up to 1.06e-8: the expansion ends there",
        .source = "dyn4j 6.0.0, collision/narrowphase/Epa.java, getPenetration: (projection - "
                  "edge.distance) < this.distanceEpsilon",
        .explains = epa_within_epsilon_in_dyn4j,
        .is_no_bug = true},
    LedgerEntry{.id = "dyn4j-gjk-direction-within-epsilon",
                .collider = "dyn4j-gjk",
                .description =
                    "another normal and depth, or another verdict, of small shapes: a direction "
                    "is taken for 0 where the square of a volume is below 1.1e-16",
                .source = "dyn4j 6.0.0, collision/narrowphase/Gjk.java, checkSimplex: "
                          "direction.getMagnitudeSquared() <= Epsilon.E",
                .explains = gjk_direction_within_epsilon_in_dyn4j,
                .explains_lost = gjk_depth_below_0_in_dyn4j},
    LedgerEntry{
        .id = "dyn4j-gjk-epa-edge-of-no-length",
        .collider = "dyn4j-gjk",
        .description = "no contact, or depth 0: an edge between equal support points has no normal",
        .source =
            "dyn4j 6.0.0, collision/narrowphase/ExpandingSimplexEdge.java: this.normal.normalize()",
        .explains = epa_edge_of_no_length_in_dyn4j},
    LedgerEntry{
        .id = "dyn4j-gjk-epa-iterations",
        .collider = "dyn4j-gjk",
        .description = "another normal and depth: 100 iterations do not get to the least",
        .source =
            "dyn4j 6.0.0, collision/narrowphase/Epa.java, getPenetration: i < this.maxIterations",
        .explains = epa_after_iterations_in_dyn4j},
    LedgerEntry{.id = "dyn4j-gjk-apart",
                .collider = "dyn4j-gjk",
                .description = "no contact: the search for the origin finds them apart",
                .source = "dyn4j 6.0.0, collision/narrowphase/Gjk.java, detect: "
                          "supportPoint.dot(d) <= this.detectEpsilon, i < this.maxDetectIterations",
                .explains = gjk_apart_in_dyn4j},
    of_dyn4j("dyn4j-gjk-one-centre", "dyn4j-gjk", kOneCentreOfDyn4j,
             no_normal_of_one_centre_in_dyn4j),
    of_dyn4j("dyn4j-gjk-longer-capsule", "dyn4j-gjk", kCapsuleEdgeOfDyn4j,
             after_gjk_of_dyn4j<FaultOfDyn4j::longer_capsule>),
    of_dyn4j("dyn4j-gjk-placed-vertices", "dyn4j-gjk", kPlacedVerticesOfDyn4j,
             after_gjk_of_dyn4j<FaultOfDyn4j::placed_vertices>),
    of_dyn4j("dyn4j-gjk-normal-of-edge", "dyn4j-gjk", kNormalOfEdgeOfDyn4j,
             after_gjk_of_dyn4j<FaultOfDyn4j::normal_of_edge>),
    of_dyn4j("dyn4j-gjk-neighbour-by-dot", "dyn4j-gjk", kNeighbourByDotOfDyn4j,
             after_gjk_of_dyn4j<FaultOfDyn4j::neighbour_by_dot>),
    of_dyn4j("dyn4j-gjk-longer-edges", "dyn4j-gjk", kLongerEdgesOfDyn4j,
             after_gjk_of_dyn4j<FaultOfDyn4j::longer_edges>),
    of_dyn4j("dyn4j-gjk-any-angle", "dyn4j-gjk", kAnyAngleOfDyn4j,
             after_gjk_of_dyn4j<FaultOfDyn4j::any_angle>),
    of_dyn4j("dyn4j-gjk-tied-edges", "dyn4j-gjk", kTiedEdgesOfDyn4j, edges_tie_after_gjk_of_dyn4j),
};

}  // namespace manifuzz::ledger_of
