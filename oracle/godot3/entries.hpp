#pragma once

#include <array>

#include "judging/faults/shared_faults.hpp"
#include "oracle/godot3/deviations.hpp"

namespace manifuzz::ledger_of {

// Godot 3.2.3, in float. Budgets are twice what 300,000 cases against clip64 showed, or a million,
// rounded up.
inline constexpr Budget kOfGodotShortDifference[] = {
    {"boxes", 250000},        {"capsules", 260000},        {"circles", 220000},
    {"cores_touch", 73000},   {"corner_corner", 250000},   {"corner_face", 230000},
    {"deep", 1600},           {"far_from_origin", 180000}, {"generic", 390000},
    {"in_line", 210000},      {"large_radii", 340000},     {"micro_edge", 150000},
    {"mixed_shapes", 280000}, {"near_collinear", 140000},  {"near_parallel", 120000},
    {"off_unit", 230000},     {"regular", 310000},         {"scaled", 300000},
    {"side_planes", 120000},  {"sliver", 420000},          {"tie_bias", 510000},
    {"tied_faces", 240000},   {"tilted_edges", 170000},    {"touching", 700000},
    {"ulp", 270000},          {"voronoi_lines", 310000}};
inline constexpr Budget kOfGodotSegmentLength[] = {{"capsules", 61000},     {"cores_touch", 79000},
                                                   {"in_line", 29000},      {"mixed_shapes", 93000},
                                                   {"side_planes", 37000},  {"tilted_edges", 40000},
                                                   {"voronoi_lines", 26000}};
inline constexpr Budget kOfGodotFirstEdge[] = {{"corner_corner", 200}, {"corner_face", 390},
                                               {"deep", 420},          {"generic", 200},
                                               {"micro_edge", 200},    {"near_collinear", 11000},
                                               {"near_parallel", 200}, {"sliver", 120000},
                                               {"tied_faces", 20000},  {"ulp", 8900}};
inline constexpr Budget kOfGodotFirstEnds[] = {{"boxes", 840},           {"capsules", 780},
                                               {"cores_touch", 3900},    {"corner_corner", 200},
                                               {"corner_face", 580},     {"deep", 5700},
                                               {"far_from_origin", 580}, {"generic", 1600},
                                               {"in_line", 6400},        {"micro_edge", 3300},
                                               {"mixed_shapes", 580},    {"near_collinear", 13000},
                                               {"near_parallel", 52000}, {"off_unit", 6800},
                                               {"regular", 1600},        {"scaled", 3300},
                                               {"side_planes", 2000},    {"sliver", 13000},
                                               {"tie_bias", 5700},       {"tied_faces", 2400},
                                               {"tilted_edges", 4900},   {"ulp", 6600}};
inline constexpr Budget kOfGodotTestedAxis[] = {
    {"capsules", 580},         {"circles", 390},       {"cores_touch", 2000},
    {"far_from_origin", 1600}, {"in_line", 70000},     {"large_radii", 130000},
    {"mixed_shapes", 600},     {"near_parallel", 390}, {"side_planes", 8800},
    {"sliver", 390},           {"tie_bias", 200},      {"voronoi_lines", 31000}};
inline constexpr Budget kOfGodotRoundedEnds[] = {{"large_radii", 9500}};
inline constexpr Budget kOfGodotUncappedFoot[] = {
    {"capsules", 390},     {"circles", 970},      {"large_radii", 590},   {"mixed_shapes", 580},
    {"side_planes", 1600}, {"tilted_edges", 200}, {"voronoi_lines", 9500}};
inline constexpr Budget kOfGodotFlatCapsule[] = {
    {"in_line", 200}, {"side_planes", 200}, {"tilted_edges", 1200}};

/// The entries, the first that explains before others.
inline constexpr std::array kOfGodot{
    LedgerEntry{.id = "godot3-start-values",
                .collider = "godot3",
                .description = "no contact, or a crash: the farthest vertex is sought from -1e10 "
                               "upwards, the least overlap from 1e15 downwards",
                .source = "Godot 3.2.3, servers/physics_2d/shape_2d_sw.cpp, "
                          "ConvexPolygonShape2DSW::get_supports: d = -1e10; "
                          "collision_solver_2d_sat.cpp, SeparatorAxisTest2D: best_depth = 1e15",
                .explains = fault_of_godot<FaultOfGodot::start_values>,
                .explains_lost = no_support_found_by_godot},
    LedgerEntry{.id = "godot3-squared-length",
                .collider = "godot3",
                .description = "no contact, or another normal: the square of an edge's length "
                               "overflows or underflows",
                .source = "Godot 3.2.3, core/math/vector2.cpp, Vector2::normalize: x * x + y * y",
                .explains = fault_of_godot<FaultOfGodot::squared_length>},
    LedgerEntry{.id = "godot3-short-edge",
                .collider = "godot3",
                .description = "an edge shorter than 1e-10 is its first end: another normal and "
                               "depth",
                .source = "Godot 3.2.3, core/math/geometry.h, "
                          "get_closest_point_to_segment_uncapped_2d: if (l2 < 1e-20)",
                .explains = fault_of_godot<FaultOfGodot::short_edge>},
    LedgerEntry{.id = "godot3-short-difference",
                .collider = "godot3",
                .description =
                    "the normal and the depth are the difference of two contact points, which "
                    "is lost in rounding where the overlap is small",
                .source = "Godot 3.2.3, servers/physics_2d/body_pair_2d_sw.cpp, "
                          "_contact_added_callback: (p_point_A - p_point_B).normalized()",
                .budgets = kOfGodotShortDifference,
                .explains = fault_of_godot<FaultOfGodot::short_difference>},
    LedgerEntry{
        .id = "godot3-segment-length",
        .collider = "godot3",
        .description = "a segment's normal is not normalised: a long segment counts as an edge at "
                       "any angle, a short one never",
        .source = "Godot 3.2.3, servers/physics_2d/shape_2d_sw.cpp, SegmentShape2DSW::set_data: n "
                  "= (b - a).tangent()",
        .budgets = kOfGodotSegmentLength,
        .explains = fault_of_godot<FaultOfGodot::segment_length>},
    LedgerEntry{.id = "godot3-first-edge",
                .collider = "godot3",
                .description = "another edge's contact: the first of a polygon's edges within 0.36 "
                               "degrees of the normal",
                .source = "Godot 3.2.3, servers/physics_2d/shape_2d_sw.cpp, "
                          "ConvexPolygonShape2DSW::get_supports: points[i].normal.dot(p_normal) > "
                          "_SEGMENT_IS_VALID_SUPPORT_THRESHOLD",
                .budgets = kOfGodotFirstEdge,
                .explains = fault_of_godot<FaultOfGodot::first_edge>},
    LedgerEntry{
        .id = "godot3-first-ends",
        .collider = "godot3",
        .description = "another depth or place, or no contact: an edge up to 0.36 degrees off the "
                       "normal's perpendicular is taken to lie at the height of its first end",
        .source =
            "Godot 3.2.3, servers/physics_2d/collision_solver_2d_sat.cpp, "
            "_generate_contacts_edge_edge: dA = n.dot(p_points_A[0]), dB = n.dot(p_points_B[0])",
        .budgets = kOfGodotFirstEnds,
        .explains = fault_of_godot<FaultOfGodot::first_ends>},
    LedgerEntry{.id = "godot3-tested-axis",
                .collider = "godot3",
                .description = "another normal of nearly the least depth: an axis between rounded "
                               "places, or one of several whose overlaps are equal in float",
                .source = "Godot 3.2.3, servers/physics_2d/collision_solver_2d_sat.cpp, test_axis: "
                          "dmax < best_depth; TEST_POINT: ((m_a) - (m_b)).normalized()",
                .budgets = kOfGodotTestedAxis,
                .explains = fault_of_godot<FaultOfGodot::tested_axis>},
    LedgerEntry{.id = "godot3-rounded-ends",
                .collider = "godot3",
                .description = "a point off its edge: the edge's line is that of its two ends as "
                               "rounded in the world, however short it is",
                .source = "Godot 3.2.3, servers/physics_2d/collision_solver_2d_sat.cpp, "
                          "generate_contacts: supports_A[i] = transform_A->xform(supports_A[i])",
                .budgets = kOfGodotRoundedEnds,
                .explains = fault_of_godot<FaultOfGodot::rounded_ends>},
    LedgerEntry{.id = "godot3-uncapped-foot",
                .collider = "godot3",
                .description =
                    "a point meets an edge's line where it is nearest to it: along the edge's "
                    "normal, not the contact's, and beyond the edge's ends too",
                .source = "Godot 3.2.3, servers/physics_2d/collision_solver_2d_sat.cpp, "
                          "_generate_contacts_point_edge: get_closest_point_to_segment_uncapped_2d",
                .budgets = kOfGodotUncappedFoot,
                .explains = fault_of_godot<FaultOfGodot::uncapped_foot>},
    LedgerEntry{.id = "godot3-flat-capsule",
                .collider = "godot3",
                .description = "a point off the capsule's end: within 0.0012 degrees of its side "
                               "its points lie along the side's normal, not the contact's",
                .source = "Godot 3.2.3, servers/physics_2d/shape_2d_sw.cpp, "
                          "CapsuleShape2DSW::get_supports: make it flat",
                .budgets = kOfGodotFlatCapsule,
                .explains = fault_of_godot<FaultOfGodot::flat_capsule>},
};

}  // namespace manifuzz::ledger_of
