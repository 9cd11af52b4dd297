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
                               const FaultWordsOfDyn4j& fault, std::span<const Budget> budgets,
                               bool (*explains)(const Deviation&)) {
  return {.id = id,
          .collider = collider,
          .description = fault.description,
          .source = fault.source,
          .budgets = budgets,
          .explains = explains,
          .is_no_bug = fault.is_no_bug};
}

// dyn4j 6.0.0, in double. Budgets are twice what 300,000 cases against clip64 showed, rounded up.
inline constexpr Budget kOfDyn4jSatSignByCentres[] = {
    {"capsules", 200}, {"deep", 300000}, {"mixed_shapes", 390}, {"near_collinear", 200},
    {"scaled", 200},   {"sliver", 5500}, {"tied_faces", 6200},  {"ulp", 21000}};
inline constexpr Budget kOfDyn4jSatOneCentre[] = {{"cores_touch", 160000}};
inline constexpr Budget kOfDyn4jSatLongerCapsule[] = {
    {"capsules", 180000},     {"cores_touch", 330000}, {"in_line", 420000},
    {"large_radii", 160000},  {"mixed_shapes", 78000}, {"side_planes", 980000},
    {"tilted_edges", 460000}, {"voronoi_lines", 3000}};
inline constexpr Budget kOfDyn4jSatPlacedVertices[] = {{"boxes", 200},
                                                       {"corner_corner", 3300},
                                                       {"corner_face", 2900},
                                                       {"deep", 390},
                                                       {"far_from_origin", 860000},
                                                       {"generic", 2000},
                                                       {"micro_edge", 2400},
                                                       {"near_collinear", 12000},
                                                       {"near_parallel", 200},
                                                       {"off_unit", 2800},
                                                       {"regular", 390},
                                                       {"scaled", 2600},
                                                       {"sliver", 5800},
                                                       {"tie_bias", 2400},
                                                       {"tied_faces", 200},
                                                       {"ulp", 53000}};
inline constexpr Budget kOfDyn4jSatNormalOfEdge[] = {
    {"far_from_origin", 200}, {"micro_edge", 15000},  {"near_collinear", 970},
    {"side_planes", 590},     {"sliver", 390},        {"tie_bias", 200},
    {"tied_faces", 200},      {"tilted_edges", 4900}, {"ulp", 1200}};
inline constexpr Budget kOfDyn4jSatNeighbourByDot[] = {
    {"near_collinear", 21000}, {"tied_faces", 18000}, {"ulp", 2000}};
inline constexpr Budget kOfDyn4jSatLongerEdges[] = {
    {"grid", 390}, {"scaled", 200}, {"sliver", 200}, {"tied_faces", 200}, {"touching", 200}};
inline constexpr Budget kOfDyn4jSatAnyAngle[] = {{"capsules", 9500},
                                                 {"cores_touch", 5700},
                                                 {"in_line", 13000},
                                                 {"mixed_shapes", 13000},
                                                 {"voronoi_lines", 200}};
inline constexpr Budget kOfDyn4jSatFirstOfEqualAxes[] = {{"in_line", 72000},
                                                         {"near_collinear", 6400},
                                                         {"side_planes", 200},
                                                         {"ulp", 580},
                                                         {"voronoi_lines", 45000}};
inline constexpr Budget kOfDyn4jSatTiedEdges[] = {{"near_collinear", 970}};
inline constexpr Budget kOfDyn4jGjkEpaWithinEpsilon[] = {{"boxes", 1200},
                                                         {"capsules", 840000},
                                                         {"circles", 480000},
                                                         {"cores_touch", 680000},
                                                         {"far_from_origin", 200},
                                                         {"in_line", 1200000},
                                                         {"large_radii", 1200000},
                                                         {"micro_edge", 36000},
                                                         {"mixed_shapes", 720000},
                                                         {"near_collinear", 120000},
                                                         {"near_parallel", 120000},
                                                         {"regular", 55000},
                                                         {"scaled", 7000},
                                                         {"side_planes", 450000},
                                                         {"sliver", 390},
                                                         {"tie_bias", 200},
                                                         {"tied_faces", 34000},
                                                         {"tilted_edges", 610000},
                                                         {"ulp", 22000},
                                                         {"voronoi_lines", 1000000}};
inline constexpr Budget kOfDyn4jGjkDirectionWithinEpsilon[] = {{"scaled", 52000}, {"ulp", 2600}};
inline constexpr Budget kOfDyn4jGjkEpaIterations[] = {{"capsules", 780},
                                                      {"cores_touch", 390000},
                                                      {"in_line", 200},
                                                      {"mixed_shapes", 200},
                                                      {"side_planes", 200}};
inline constexpr Budget kOfDyn4jGjkGjkApart[] = {{"mixed_shapes", 390}, {"voronoi_lines", 200}};
inline constexpr Budget kOfDyn4jGjkOneCentre[] = {{"cores_touch", 160000}};
inline constexpr Budget kOfDyn4jGjkLongerCapsule[] = {
    {"capsules", 120000},     {"cores_touch", 210000}, {"in_line", 200000},
    {"large_radii", 70000},   {"mixed_shapes", 52000}, {"side_planes", 540000},
    {"tilted_edges", 170000}, {"voronoi_lines", 1800}};
inline constexpr Budget kOfDyn4jGjkPlacedVertices[] = {{"corner_corner", 3300},
                                                       {"corner_face", 2900},
                                                       {"deep", 390},
                                                       {"far_from_origin", 860000},
                                                       {"generic", 2000},
                                                       {"micro_edge", 2400},
                                                       {"near_collinear", 8700},
                                                       {"near_parallel", 200},
                                                       {"off_unit", 2800},
                                                       {"regular", 390},
                                                       {"scaled", 2600},
                                                       {"sliver", 5800},
                                                       {"tie_bias", 2400},
                                                       {"tied_faces", 200},
                                                       {"ulp", 53000}};
inline constexpr Budget kOfDyn4jGjkNeighbourByDot[] = {
    {"near_collinear", 12000}, {"tied_faces", 9500}, {"ulp", 390}};
inline constexpr Budget kOfDyn4jGjkLongerEdges[] = {{"near_collinear", 200}};
inline constexpr Budget kOfDyn4jGjkAnyAngle[] = {{"capsules", 9500},
                                                 {"cores_touch", 5300},
                                                 {"in_line", 13000},
                                                 {"mixed_shapes", 13000},
                                                 {"voronoi_lines", 200}};
inline constexpr Budget kOfDyn4jGjkTiedEdges[] = {{"near_collinear", 17000}, {"ulp", 1200}};

/// The entries, the first that explains before others.
inline constexpr std::array kOfDyn4jSat{
    LedgerEntry{.id = "dyn4j-sat-sign-by-centres",
                .collider = "dyn4j-sat",
                .description = "the normal reversed, or no contact: the centres decide for its "
                               "sign, wherever the least overlap is",
                .source = "dyn4j 6.0.0, collision/narrowphase/Sat.java, detect: cToc.dot(n) < 0",
                .budgets = kOfDyn4jSatSignByCentres,
                .explains = sign_by_centres_in_dyn4j},
    of_dyn4j("dyn4j-sat-one-centre", "dyn4j-sat", kOneCentreOfDyn4j, kOfDyn4jSatOneCentre,
             no_normal_of_one_centre_in_dyn4j),
    of_dyn4j("dyn4j-sat-longer-capsule", "dyn4j-sat", kCapsuleEdgeOfDyn4j, kOfDyn4jSatLongerCapsule,
             after_sat_of_dyn4j<FaultOfDyn4j::longer_capsule>),
    of_dyn4j("dyn4j-sat-placed-vertices", "dyn4j-sat", kPlacedVerticesOfDyn4j,
             kOfDyn4jSatPlacedVertices, after_sat_of_dyn4j<FaultOfDyn4j::placed_vertices>),
    of_dyn4j("dyn4j-sat-normal-of-edge", "dyn4j-sat", kNormalOfEdgeOfDyn4j, kOfDyn4jSatNormalOfEdge,
             after_sat_of_dyn4j<FaultOfDyn4j::normal_of_edge>),
    of_dyn4j("dyn4j-sat-neighbour-by-dot", "dyn4j-sat", kNeighbourByDotOfDyn4j,
             kOfDyn4jSatNeighbourByDot, after_sat_of_dyn4j<FaultOfDyn4j::neighbour_by_dot>),
    of_dyn4j("dyn4j-sat-longer-edges", "dyn4j-sat", kLongerEdgesOfDyn4j, kOfDyn4jSatLongerEdges,
             after_sat_of_dyn4j<FaultOfDyn4j::longer_edges>),
    of_dyn4j("dyn4j-sat-any-angle", "dyn4j-sat", kAnyAngleOfDyn4j, kOfDyn4jSatAnyAngle,
             after_sat_of_dyn4j<FaultOfDyn4j::any_angle>),
    LedgerEntry{
        .id = "dyn4j-sat-first-of-equal-axes",
        .collider = "dyn4j-sat",
        .description =
            "another normal of nearly the least depth: the first of axes whose overlaps are equal",
        .source = "dyn4j 6.0.0, collision/narrowphase/Sat.java, detect: o < overlap",
        .budgets = kOfDyn4jSatFirstOfEqualAxes,
        .explains = first_of_equal_axes_in_dyn4j},
    of_dyn4j("dyn4j-sat-tied-edges", "dyn4j-sat", kTiedEdgesOfDyn4j, kOfDyn4jSatTiedEdges,
             edges_tie_after_sat_of_dyn4j),
};

/// The same of Gjk with Epa.
inline constexpr std::array kOfDyn4jGjk{
    LedgerEntry{
        .id = "dyn4j-gjk-epa-within-epsilon",
        .collider = "dyn4j-gjk",
        .description = "more than the least depth, by up to 1.06e-8: the expansion ends there",
        .source = "dyn4j 6.0.0, collision/narrowphase/Epa.java, getPenetration: (projection - "
                  "edge.distance) < this.distanceEpsilon",
        .budgets = kOfDyn4jGjkEpaWithinEpsilon,
        .explains = epa_within_epsilon_in_dyn4j,
        .is_no_bug = true},
    LedgerEntry{.id = "dyn4j-gjk-direction-within-epsilon",
                .collider = "dyn4j-gjk",
                .description =
                    "another normal and depth, or another verdict, of small shapes: a direction "
                    "is taken for 0 where the square of a volume is below 1.1e-16",
                .source = "dyn4j 6.0.0, collision/narrowphase/Gjk.java, checkSimplex: "
                          "direction.getMagnitudeSquared() <= Epsilon.E",
                .budgets = kOfDyn4jGjkDirectionWithinEpsilon,
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
        .budgets = kOfDyn4jGjkEpaIterations,
        .explains = epa_after_iterations_in_dyn4j},
    LedgerEntry{.id = "dyn4j-gjk-apart",
                .collider = "dyn4j-gjk",
                .description = "no contact: the search for the origin finds them apart",
                .source = "dyn4j 6.0.0, collision/narrowphase/Gjk.java, detect: "
                          "supportPoint.dot(d) <= this.detectEpsilon, i < this.maxDetectIterations",
                .budgets = kOfDyn4jGjkGjkApart,
                .explains = gjk_apart_in_dyn4j},
    of_dyn4j("dyn4j-gjk-one-centre", "dyn4j-gjk", kOneCentreOfDyn4j, kOfDyn4jGjkOneCentre,
             no_normal_of_one_centre_in_dyn4j),
    of_dyn4j("dyn4j-gjk-longer-capsule", "dyn4j-gjk", kCapsuleEdgeOfDyn4j, kOfDyn4jGjkLongerCapsule,
             after_gjk_of_dyn4j<FaultOfDyn4j::longer_capsule>),
    of_dyn4j("dyn4j-gjk-placed-vertices", "dyn4j-gjk", kPlacedVerticesOfDyn4j,
             kOfDyn4jGjkPlacedVertices, after_gjk_of_dyn4j<FaultOfDyn4j::placed_vertices>),
    of_dyn4j("dyn4j-gjk-normal-of-edge", "dyn4j-gjk", kNormalOfEdgeOfDyn4j, {},
             after_gjk_of_dyn4j<FaultOfDyn4j::normal_of_edge>),
    of_dyn4j("dyn4j-gjk-neighbour-by-dot", "dyn4j-gjk", kNeighbourByDotOfDyn4j,
             kOfDyn4jGjkNeighbourByDot, after_gjk_of_dyn4j<FaultOfDyn4j::neighbour_by_dot>),
    of_dyn4j("dyn4j-gjk-longer-edges", "dyn4j-gjk", kLongerEdgesOfDyn4j, kOfDyn4jGjkLongerEdges,
             after_gjk_of_dyn4j<FaultOfDyn4j::longer_edges>),
    of_dyn4j("dyn4j-gjk-any-angle", "dyn4j-gjk", kAnyAngleOfDyn4j, kOfDyn4jGjkAnyAngle,
             after_gjk_of_dyn4j<FaultOfDyn4j::any_angle>),
    of_dyn4j("dyn4j-gjk-tied-edges", "dyn4j-gjk", kTiedEdgesOfDyn4j, kOfDyn4jGjkTiedEdges,
             edges_tie_after_gjk_of_dyn4j),
};

}  // namespace manifuzz::ledger_of
