#pragma once

#include <array>

#include "judging/ledger/separating_axes/axes_deviations.hpp"

namespace manifuzz::ledger_of {

// Godot 3.2.3, in float. Budgets are twice what 300,000 cases against clip64 showed, rounded up.

/// The entries, the first that explains before others.
inline constexpr std::array kOfGodot{
    LedgerEntry{.id = "godot3-short-difference",
                .collider = "godot3",
                .description = "the normal and the depth of a short difference of points that are "
                               "rounded in the world",
                .source = "Godot 3.2.3, servers/physics_2d/body_pair_2d_sw.cpp, "
                          "_contact_added_callback: (p_point_A - p_point_B).normalized()",
                .explains = fault_of_godot<FaultOfGodot::short_difference>},
    LedgerEntry{
        .id = "godot3-segment-length",
        .collider = "godot3",
        .description =
            "another support, or none of an edge: a segment's normal is as long as the segment",
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
        .description = "another depth or place, or no contact: an edge is met on the plane through "
                       "its first end, up to 0.36 degrees off",
        .source =
            "Godot 3.2.3, servers/physics_2d/collision_solver_2d_sat.cpp, "
            "_generate_contacts_edge_edge: dA = n.dot(p_points_A[0]), dB = n.dot(p_points_B[0])",
        .explains = fault_of_godot<FaultOfGodot::first_ends>},
    LedgerEntry{.id = "godot3-coordinates-beyond",
                .collider = "godot3",
                .description = "no contact of coordinates beyond 1e10: no support is found",
                .source = "Godot 3.2.3, servers/physics_2d/shape_2d_sw.cpp, "
                          "ConvexPolygonShape2DSW::get_supports: d = -1e10",
                .explains = coordinates_beyond_godot},
};

}  // namespace manifuzz::ledger_of
