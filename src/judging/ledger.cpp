#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "judging/compare.hpp"
#include "judging/round_deviations.hpp"

namespace manifuzz {
namespace {

// Twice what 20,000,000 cases showed, rounded up. An entry without budgets is met in the regime
// `corpus` alone, which has none.
constexpr Budget kOfTinyFaces[] = {{"micro_edge", 7200}, {"scaled", 1300}, {"ulp", 500}};
constexpr Budget kOfBias[] = {{"generic", 30},
                              {"regular", 20},
                              {"sliver", 1600},
                              {"near_parallel", 10},
                              {"tied_faces", 60},
                              {"micro_edge", 5000},
                              {"near_collinear", 300},
                              {"corner_corner", 4000},
                              {"corner_face", 30},
                              {"deep", 30},
                              {"tie_bias", 47'000},
                              {"far_from_origin", 40},
                              {"scaled", 16'000},
                              {"off_unit", 50},
                              {"ulp", 4400}};
constexpr Budget kOfTies[] = {{"sliver", 4800},        {"tied_faces", 26'000},
                              {"micro_edge", 10},      {"near_collinear", 48'000},
                              {"corner_corner", 40},   {"tie_bias", 10},
                              {"far_from_origin", 30}, {"scaled", 10},
                              {"off_unit", 20},        {"ulp", 4700}};

// The same of 10,000,000 cases against clip64.
constexpr Budget kOfPlanckNoContactUnderBias[] = {{"generic", 70},
                                                  {"boxes", 20},
                                                  {"regular", 130},
                                                  {"sliver", 5700},
                                                  {"near_parallel", 20},
                                                  {"tied_faces", 30},
                                                  {"micro_edge", 12000},
                                                  {"near_collinear", 280},
                                                  {"corner_corner", 12000},
                                                  {"corner_face", 20},
                                                  {"touching", 1400},
                                                  {"deep", 40},
                                                  {"tie_bias", 63000},
                                                  {"far_from_origin", 2700},
                                                  {"scaled", 20000},
                                                  {"off_unit", 2600},
                                                  {"ulp", 7600}};
constexpr Budget kOfPlanckNoContactOnTiedFeatures[] = {{"near_collinear", 9100}, {"ulp", 500}};
constexpr Budget kOfPlanckNormalOfScaledVertices[] = {
    {"generic", 20},        {"sliver", 2200},      {"near_parallel", 340},
    {"tied_faces", 260},    {"micro_edge", 69000}, {"near_collinear", 2800},
    {"corner_corner", 150}, {"corner_face", 70},   {"touching", 110},
    {"deep", 10},           {"tie_bias", 920},     {"far_from_origin", 190},
    {"scaled", 260},        {"off_unit", 120},     {"ulp", 4400}};
constexpr Budget kOfPhaserEdgeExtendedToSlab[] = {
    {"sliver", 590},   {"micro_edge", 80}, {"near_collinear", 18000}, {"corner_corner", 690},
    {"touching", 470}, {"tie_bias", 500},  {"far_from_origin", 100},  {"scaled", 200},
    {"off_unit", 220}, {"ulp", 1200}};
constexpr Budget kOfPhaserNoContactOnTiedFeatures[] = {{"near_collinear", 510}, {"ulp", 20}};
constexpr Budget kOfChipmunkNormalOfWorldVertices[] = {
    {"generic", 3400},       {"boxes", 1900},
    {"regular", 1400},       {"sliver", 14000},
    {"near_parallel", 1800}, {"tied_faces", 1800},
    {"micro_edge", 13000},   {"near_collinear", 18000},
    {"corner_corner", 5200}, {"corner_face", 5800},
    {"touching", 20},        {"deep", 1700},
    {"tie_bias", 4100},      {"far_from_origin", 910000},
    {"scaled", 6800},        {"off_unit", 7200},
    {"ulp", 56000}};
constexpr Budget kOfChipmunkCornerOnCorner[] = {
    {"regular", 170},        {"grid", 260000},        {"sliver", 3500},    {"tied_faces", 2200},
    {"near_collinear", 130}, {"corner_corner", 2800}, {"touching", 19000}, {"deep", 2400},
    {"tie_bias", 300},       {"scaled", 3300},        {"off_unit", 2400},  {"ulp", 8100}};
constexpr Budget kOfChipmunkCollinearApart[] = {
    {"grid", 7400}, {"tied_faces", 100}, {"tie_bias", 10}, {"ulp", 290}};
constexpr Budget kOfChipmunkWrongSupportEdge[] = {
    {"tied_faces", 2500}, {"near_collinear", 16000}, {"ulp", 1100}};
constexpr std::array kLedger{
    LedgerEntry{.id = "box2d-tiny-reference-face",
                .collider = "box2d",
                .description =
                    "a wrong normal or no contact: the reference face is shorter than b2_epsilon, "
                    "so its direction is not normalised, or than world coordinates resolve",
                .source =
                    "Box2D 2.4.1, include/box2d/b2_math.h, b2Vec2::Normalize: "
                    "`if (length < b2_epsilon) return 0.0f`; src/collision/b2_collide_polygon.cpp, "
                    "b2CollidePolygons: side offsets of world vertices",
                .budgets = kOfTinyFaces,
                .explains = tiny_reference_face},
    LedgerEntry{.id = "box2d-huge-reference-face",
                .collider = "box2d",
                .description =
                    "a normal of length zero: the square of the reference face's length is beyond "
                    "float, so its direction is divided by infinity",
                .source = "Box2D 2.4.1, include/box2d/b2_math.h, b2Vec2::Length and Normalize: "
                          "`b2Sqrt(x * x + y * y)`",
                .explains = huge_reference_face},
    LedgerEntry{.id = "box2d-no-contact-under-bias",
                .collider = "box2d",
                .description =
                    "no contact for overlapping polygons: the bias keeps A's shallower face, whose "
                    "side planes the incident edge misses",
                .source = "Box2D 2.4.1, src/collision/b2_collide_polygon.cpp, b2CollidePolygons: "
                          "k_tol = 0.1f * b2_linearSlop, then `if (np < 2) return`",
                .budgets = kOfBias,
                .explains = no_contact_under_bias},
    LedgerEntry{.id = "box2d-no-contact-on-tied-features",
                .collider = "box2d",
                .description =
                    "no contact for overlapping polygons: faces or edges tie in float, the wrong "
                    "one is kept, and its slab misses the deepest vertex",
                .source =
                    "Box2D 2.4.1, src/collision/b2_collide_polygon.cpp, b2FindMaxSeparation and "
                    "b2FindIncidentEdge: first of equals",
                .budgets = kOfTies,
                .explains = no_contact_on_tied_features},
    LedgerEntry{.id = "box2d-crossing-underflows",
                .collider = "box2d",
                .description =
                    "no contact for overlapping polygons: an end of the incident edge all "
                    "but touches a side plane, the product of distances underflows",
                .source = "Box2D 2.4.1, src/collision/b2_collision.cpp, b2ClipSegmentToLine: "
                          "`if (distance0 * distance1 < 0.0f)`",
                .explains = crossing_underflows},
    LedgerEntry{
        .id = "box2d-edge-slab-not-widened",
        .collider = "box2d",
        .description = "no contact, or too little depth, of a capsule and a polygon near corners: "
                       "what lies within the radii beyond the reference face's ends is cut off",
        .source = "Box2D 2.4.1, src/collision/b2_collide_edge.cpp, b2CollideEdgeAndPolygon: "
                  "ref.sideOffset1 = b2Dot(ref.sideNormal1, ref.v1), without the radius "
                  "that b2CollidePolygons adds",
        .explains = edge_slab_not_widened},
    LedgerEntry{
        .id = "box2d-edge-hysteresis",
        .collider = "box2d",
        .description = "a capsule's own face is kept though the polygon's is less deep, by 2 % of "
                       "its depth and 0.001",
        .source = "Box2D 2.4.1, src/collision/b2_collide_edge.cpp, b2CollideEdgeAndPolygon: "
                  "k_relativeTol = 0.98f, k_absoluteTol = 0.001f",
        .explains = edge_face_kept_by_hysteresis},
    LedgerEntry{.id = "box2d-coincident-points",
                .collider = "box2d",
                .description = "a normal along the world's x axis, into the edge: a circle's "
                               "centre lies on the end of an edge",
                .source = "Box2D 2.4.1, src/collision/b2_collision.cpp, "
                          "b2WorldManifold::Initialize: normal.Set(1.0f, 0.0f)",
                .explains = axis_for_coincident_points},
    LedgerEntry{.id = "box2d-direction-of-roundings",
                .collider = "box2d",
                .description = "a normal into the core: a circle's centre lies on an edge's end or "
                               "a polygon's corner, but for roundings, and their direction is it",
                .source = "Box2D 2.4.1, src/collision/b2_collision.cpp, "
                          "b2WorldManifold::Initialize: normal = pointB - pointA; "
                          "src/collision/b2_collide_circle.cpp, b2CollidePolygonAndCircle: "
                          "localNormal = cLocal - v1",
                .explains = direction_of_roundings},
    LedgerEntry{.id = "box2d-corner-direction-not-normalised",
                .collider = "box2d",
                .description = "a normal of no length and no depth: a circle's centre lies on a "
                               "polygon's corner, or within epsilon of it",
                .source = "Box2D 2.4.1, src/collision/b2_collide_circle.cpp, "
                          "b2CollidePolygonAndCircle: localNormal = cLocal - v1; "
                          "include/box2d/b2_math.h, b2Vec2::Normalize: `if (length < b2_epsilon)`",
                .explains = corner_direction_not_normalised},
    LedgerEntry{.id = "planck-no-contact-under-bias",
                .collider = "planck",
                .description =
                    "no contact for overlapping polygons: the bias keeps A's shallower face, whose "
                    "side planes the incident edge misses",
                .source = "planck 1.4.2, src/collision/shape/CollidePolygon.ts, CollidePolygons: "
                          "k_tol = 0.1 * Settings.linearSlop, then `if (np1 < 2) return`",
                .budgets = kOfPlanckNoContactUnderBias,
                .explains = no_contact_under_bias},
    LedgerEntry{.id = "planck-no-contact-on-tied-features",
                .collider = "planck",
                .description =
                    "no contact for overlapping polygons: faces or edges tie in double, the wrong "
                    "one is kept, and its slab misses the deepest vertex",
                .source = "planck 1.4.2, src/collision/shape/CollidePolygon.ts, findMaxSeparation "
                          "and findIncidentEdge: first of equals",
                .budgets = kOfPlanckNoContactOnTiedFeatures,
                .explains = no_contact_on_tied_features},
    LedgerEntry{.id = "planck-normal-of-scaled-vertices",
                .collider = "planck",
                .description = "a normal off by the roundoff of vertices over the face's length: "
                               "planck takes it from them, and they hold what (cos, sin) lacks of "
                               "unit length, since planck takes a transpose for the inverse",
                .source = "planck 1.4.2, src/collision/shape/CollidePolygon.ts, CollidePolygons: "
                          "localNormal of v12 - v11; scripts/colliders/protocol.mjs, readBody",
                .budgets = kOfPlanckNormalOfScaledVertices,
                .explains = normal_of_rounded_vertices},
    LedgerEntry{.id = "phaser-box2d-edge-extended-to-slab",
                .collider = "phaser-box2d",
                .description =
                    "a point off the polygon, or contact across a gap: an incident edge that "
                    "misses the reference face's slab is prolonged to it",
                .source = "phaser-box2d 1.1.0, src/manifold_c.js, b2ClipPolygons: b2Lerp(v22, v21, "
                          "(lower1 - lower2) / (upper2 - lower2)) with a fraction outside [0, 1]",
                .budgets = kOfPhaserEdgeExtendedToSlab,
                .explains = edge_extended_to_slab},
    LedgerEntry{
        .id = "phaser-box2d-no-contact-on-tied-features",
        .collider = "phaser-box2d",
        .description = "no contact for overlapping polygons: faces or edges tie in double, the "
                       "wrong one is kept, and its slab misses the deepest vertex",
        .source = "phaser-box2d 1.1.0, src/manifold_c.js, b2CollidePolygons: `dot < minDot`, first "
                  "of equals",
        .budgets = kOfPhaserNoContactOnTiedFeatures,
        .explains = no_contact_on_tied_features},
    LedgerEntry{.id = "phaser-box2d-tiny-edge-unclipped",
                .collider = "phaser-box2d",
                .description = "a point beyond the side plane: an incident edge shorter than 1e-10 "
                               "along the reference face is not clipped",
                .source = "phaser-box2d 1.1.0, src/manifold_c.js, b2ClipPolygons: "
                          "`upper2 - lower2 > eps`; src/include/math_functions_h.js: eps = 1.0e-10",
                .explains = incident_edge_unclipped},
    LedgerEntry{
        .id = "chipmunk-normal-of-world-vertices",
        .collider = "chipmunk",
        .description = "a normal off by the roundoff of world coordinates over the face's length",
        .source = "Chipmunk 7.0.3, src/cpCollision.c, ClosestPointsNew: "
                  "`n = cpvnormalize(cpvrperp(delta))`, delta of world points",
        .budgets = kOfChipmunkNormalOfWorldVertices,
        .explains = normal_of_rounded_vertices},
    LedgerEntry{.id = "chipmunk-corner-on-corner",
                .collider = "chipmunk",
                .description = "an arbitrary normal or no contact: a corner of A lies on a "
                               "corner of B",
                .source = "Chipmunk 7.0.3, src/cpCollision.c, GJKRecurse: the direction to the "
                          "nearest point is (0, 0), so no nearer one is found",
                .budgets = kOfChipmunkCornerOnCorner,
                .explains = corner_on_corner},
    LedgerEntry{.id = "chipmunk-collinear-apart",
                .collider = "chipmunk",
                .description = "contact for polygons well apart: the origin lies on the line of a "
                               "chord of their difference",
                .source = "Chipmunk 7.0.3, src/cpCollision.c, ClosestPointsNew: `if(d <= 0.0f` "
                          "comes before the distance to the nearer vertex",
                .budgets = kOfChipmunkCollinearApart,
                .explains = collinear_and_apart},
    LedgerEntry{.id = "chipmunk-wrong-support-edge",
                .collider = "chipmunk",
                .description = "too few points, wrong ones or none: the neighbour of the right "
                               "face is clipped, their directions being nearer than a dot can tell",
                .source = "Chipmunk 7.0.3, src/cpCollision.c, SupportEdgeForPoly: "
                          "`cpvdot(n, planes[i1].n) > cpvdot(n, planes[i2].n)`",
                .budgets = kOfChipmunkWrongSupportEdge,
                .explains = neighbours_nearly_parallel},
    LedgerEntry{.id = "chipmunk-swapped-distance",
                .collider = "chipmunk",
                .description = "no depth at all: shapes given in another order than circle, "
                               "segment, polygon, so that distances have the wrong sign",
                .source = "Chipmunk 7.0.3, src/cpShape.c, cpShapesCollide: distance = "
                          "cpvdot(cpvsub(p2, p1), set.normal), of points not swapped",
                .explains = sign_of_swapped_distance},
    LedgerEntry{.id = "chipmunk-polygon-radius-sign",
                .collider = "chipmunk",
                .description = "a circle against a rounded polygon: too little depth by twice the "
                               "polygon's radius, and its point as much too far",
                .source = "Chipmunk 7.0.3, src/cpCollision.c, CircleToPoly: "
                          "cpvadd(points.b, cpvmult(n, poly->r))",
                .explains = sign_of_polygon_radius},
    LedgerEntry{.id = "chipmunk-direction-of-roundings",
                .collider = "chipmunk",
                .description = "a circle's centre on a segment: the normal is the direction of "
                               "roundings between both",
                .source = "Chipmunk 7.0.3, src/cpCollision.c, CircleToSegment: "
                          "n = cpvmult(delta, 1.0f/dist)",
                .explains = direction_to_place_on_segment},
    LedgerEntry{.id = "chipmunk-round-corner-on-corner",
                .collider = "chipmunk",
                .description =
                    "a normal across any chord, or no contact: a corner of one core lies on the "
                    "other's",
                .source = "Chipmunk 7.0.3, src/cpCollision.c, GJKRecurse: the direction to the "
                          "nearest point is (0, 0), so no nearer one is found",
                .explains = normal_across_corner_on_corner},
    LedgerEntry{.id = "chipmunk-round-collinear",
                .collider = "chipmunk",
                .description = "a perpendicular normal for capsules end to end, or contact well "
                               "apart: the origin lies on the line of a chord",
                .source = "Chipmunk 7.0.3, src/cpCollision.c, ClosestPointsNew: `if(d <= 0.0f` "
                          "comes before the distance to the nearer vertex",
                .explains = normal_across_collinear},
    LedgerEntry{.id = "chipmunk-depth-by-crossing",
                .collider = "chipmunk",
                .description = "too little depth, or none, of an edge end on: its end is found by "
                               "a division by its run along the tangent",
                .source = "Chipmunk 7.0.3, src/cpCollision.c, ContactPoints: "
                          "e1_denom = 1.0f/(d_e1_b - d_e1_a + CPFLOAT_MIN)",
                .explains = depth_by_crossing},
};

static_assert(kLedger.size() <= kLedgerMax);

}  // namespace

std::span<const LedgerEntry> ledger() {
  return kLedger;
}

std::size_t index_of(const LedgerEntry& entry) {
  return static_cast<std::size_t>(&entry - kLedger.data());
}

std::string witness_of(const LedgerEntry& entry) {
  return fmt::format("defects/{}/witness-{}.json", entry.collider, entry.id);
}

double budget_per_million(const LedgerEntry& entry, std::string_view regime) {
  const auto found = std::ranges::find(entry.budgets, regime, &Budget::regime);
  return found == entry.budgets.end() ? 0 : found->per_million;
}

const LedgerEntry* find_explanation(std::string_view collider, const Deviation& deviation) {
  for (const LedgerEntry& entry : kLedger) {
    if (entry.collider == collider && entry.explains(deviation)) return &entry;
  }
  return nullptr;
}

}  // namespace manifuzz
