#pragma once

#include <array>

#include "judging/faults/shared_faults.hpp"
#include "oracle/godot3/deviations.hpp"

namespace manifuzz::ledger_of {

// Godot 3.2.3, in float. Budgets (budgets.json) are twice what 300,000 cases against clip64 showed,
// or a million, rounded up.

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
                .explains = fault_of_godot<FaultOfGodot::short_difference>},
    LedgerEntry{
        .id = "godot3-segment-length",
        .collider = "godot3",
        .description = "a segment's normal is not normalised: a long segment counts as an edge at "
                       "any angle, a short one never",
        .source = "Godot 3.2.3, servers/physics_2d/shape_2d_sw.cpp, SegmentShape2DSW::set_data: n "
                  "= (b - a).tangent()",
        .explains = fault_of_godot<FaultOfGodot::segment_length>},
    LedgerEntry{.id = "godot3-first-edge",
                .collider = "godot3",
                .description = "another edge's contact: the first of a polygon's edges within 0.36 "
                               "degrees of the normal",
                .source = "Godot 3.2.3, servers/physics_2d/shape_2d_sw.cpp, "
                          "ConvexPolygonShape2DSW::get_supports: points[i].normal.dot(p_normal) > "
                          "_SEGMENT_IS_VALID_SUPPORT_THRESHOLD",
                .explains = fault_of_godot<FaultOfGodot::first_edge>},
    LedgerEntry{
        .id = "godot3-first-ends",
        .collider = "godot3",
        .description = "another depth or place, or no contact: an edge up to 0.36 degrees off the "
                       "normal's perpendicular is taken to lie at the height of its first end",
        .source =
            "Godot 3.2.3, servers/physics_2d/collision_solver_2d_sat.cpp, "
            "_generate_contacts_edge_edge: dA = n.dot(p_points_A[0]), dB = n.dot(p_points_B[0])",
        .explains = fault_of_godot<FaultOfGodot::first_ends>},
    LedgerEntry{.id = "godot3-tested-axis",
                .collider = "godot3",
                .description = "another normal of nearly the least depth: an axis between rounded "
                               "places, or one of several whose overlaps are equal in float",
                .source = "Godot 3.2.3, servers/physics_2d/collision_solver_2d_sat.cpp, test_axis: "
                          "dmax < best_depth; TEST_POINT: ((m_a) - (m_b)).normalized()",
                .explains = fault_of_godot<FaultOfGodot::tested_axis>},
    LedgerEntry{.id = "godot3-rounded-ends",
                .collider = "godot3",
                .description = "a point off its edge: the edge's line is that of its two ends as "
                               "rounded in the world, however short it is",
                .source = "Godot 3.2.3, servers/physics_2d/collision_solver_2d_sat.cpp, "
                          "generate_contacts: supports_A[i] = transform_A->xform(supports_A[i])",
                .explains = fault_of_godot<FaultOfGodot::rounded_ends>},
    LedgerEntry{.id = "godot3-uncapped-foot",
                .collider = "godot3",
                .description =
                    "a point meets an edge's line where it is nearest to it: along the edge's "
                    "normal, not the contact's, and beyond the edge's ends too",
                .source = "Godot 3.2.3, servers/physics_2d/collision_solver_2d_sat.cpp, "
                          "_generate_contacts_point_edge: get_closest_point_to_segment_uncapped_2d",
                .explains = fault_of_godot<FaultOfGodot::uncapped_foot>},
    LedgerEntry{.id = "godot3-flat-capsule",
                .collider = "godot3",
                .description = "a point off the capsule's end: within 0.0012 degrees of its side "
                               "its points lie along the side's normal, not the contact's",
                .source = "Godot 3.2.3, servers/physics_2d/shape_2d_sw.cpp, "
                          "CapsuleShape2DSW::get_supports: make it flat",
                .explains = fault_of_godot<FaultOfGodot::flat_capsule>},
};

}  // namespace manifuzz::ledger_of
