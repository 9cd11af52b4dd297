#pragma once

#include <array>

#include "oracle/parry/ledger/faults.hpp"

namespace manifuzz::ledger_of {

// rapier2d-compat 0.21.0, which has parry2d 0.31.1 inside, in floats. Budgets are twice what
// 300,000 cases against clip64 showed, or another million, rounded up.
inline constexpr Budget kOfRapierFaceByCosine[] = {
    {"micro_edge", 1600}, {"scaled", 4200}, {"ulp", 200}};
inline constexpr Budget kOfRapierEdgeAlongNormal[] = {{"cores_touch", 200}, {"in_line", 4200}};
inline constexpr Budget kOfRapierCornerCones[] = {{"cores_touch", 12000},   {"corner_corner", 8800},
                                                  {"far_from_origin", 800}, {"grid", 49000},
                                                  {"micro_edge", 600},      {"mixed_shapes", 1000},
                                                  {"off_unit", 2800},       {"regular", 400},
                                                  {"round_corners", 200},   {"scaled", 22000},
                                                  {"sliver", 3000},         {"tie_bias", 2200},
                                                  {"touching", 23000},      {"ulp", 4200}};
inline constexpr Budget kOfRapierLostByEpa[] = {{"cores_touch", 8200},
                                                {"in_line", 5800},
                                                {"near_parallel", 400},
                                                {"scaled", 33000},
                                                {"ulp", 3200}};
inline constexpr Budget kOfRapierDirectionOfRoundings[] = {
    {"capsules", 2000},    {"cores_touch", 65000}, {"in_line", 97000},
    {"large_radii", 3600}, {"mixed_shapes", 2800}, {"round_corners", 1800},
    {"side_planes", 6800}, {"tilted_edges", 8600}, {"voronoi_lines", 3200}};
inline constexpr Budget kOfRapierGjkStop[] = {
    {"capsules", 600},     {"in_line", 9000},      {"large_radii", 99000},  {"mixed_shapes", 200},
    {"side_planes", 2400}, {"tilted_edges", 5600}, {"voronoi_lines", 4800}, {"round_corners", 610}};
inline constexpr Budget kOfRapierTouchingWithin[] = {
    {"capsules", 200},     {"cores_touch", 25000},  {"corner_corner", 200},
    {"generic", 200},      {"in_line", 14000},      {"micro_edge", 6000},
    {"mixed_shapes", 600}, {"near_collinear", 200}, {"near_parallel", 19000},
    {"off_unit", 400},     {"regular", 200},        {"round_corners", 400},
    {"scaled", 200},       {"side_planes", 1000},   {"sliver", 2400},
    {"tie_bias", 600},     {"tied_faces", 400},     {"tilted_edges", 2400},
    {"touching", 1000},    {"ulp", 1200},           {"voronoi_lines", 200}};
inline constexpr Budget kOfRapierOriginWithin[] = {
    {"capsules", 200},  {"cores_touch", 2800}, {"corner_corner", 11000}, {"far_from_origin", 600},
    {"grid", 600},      {"micro_edge", 2800},  {"mixed_shapes", 400},    {"near_collinear", 200},
    {"off_unit", 1600}, {"regular", 400},      {"scaled", 200},          {"sliver", 1000},
    {"tie_bias", 1400}, {"tied_faces", 1400},  {"touching", 13000},      {"ulp", 2600}};
inline constexpr Budget kOfRapierEqualCorners[] = {
    {"circles", 200},    {"cores_touch", 3800}, {"micro_edge", 14000}, {"scaled", 200},
    {"tied_faces", 400}, {"ulp", 800},          {"voronoi_lines", 200}};
inline constexpr Budget kOfRapierSecondPoint[] = {{"cores_touch", 2600},
                                                  {"in_line", 2400},
                                                  {"large_radii", 18000},
                                                  {"mixed_shapes", 200},
                                                  {"side_planes", 2200}};
inline constexpr Budget kOfRapierCrossingCapsules[] = {
    {"capsules", 18000},    {"cores_touch", 65000}, {"in_line", 290000},
    {"mixed_shapes", 3000}, {"tilted_edges", 7600}, {"voronoi_lines", 3400}};
inline constexpr Budget kOfRapierNearlyParallel[] = {{"large_radii", 1400}, {"tilted_edges", 1800}};
inline constexpr Budget kOfRapierCornerOfChord[] = {{"cores_touch", 2600}};
inline constexpr Budget kOfRapierCentreOnSurface[] = {{"circles", 11000},
                                                      {"cores_touch", 120000},
                                                      {"large_radii", 8000},
                                                      {"mixed_shapes", 3400},
                                                      {"voronoi_lines", 18000}};
inline constexpr Budget kOfRapierCircleByGjk[] = {{"circles", 230000},
                                                  {"cores_touch", 1400},
                                                  {"large_radii", 77000},
                                                  {"mixed_shapes", 57000},
                                                  {"voronoi_lines", 120000}};
inline constexpr Budget kOfRapierEpaChord[] = {{"cores_touch", 120000}};
inline constexpr Budget kOfRapierStepBack[] = {
    {"cores_touch", 200}, {"side_planes", 800}, {"voronoi_lines", 800}};
inline constexpr Budget kOfRapierRoundedFoot[] = {{"cores_touch", 200}};
inline constexpr Budget kOfRapierKeptNormals[] = {{"mixed_shapes", 180}, {"round_corners", 200}};

/// The entries, the first that explains before others.
inline constexpr std::array kOfRapier{
    of_parry("rapier2d-face-by-cosine", "rapier2d", kFaceByCosine, kOfRapierFaceByCosine,
             clip_of_face_by_cosine<parry::Rapier>),
    of_parry("rapier2d-kept-normals", "rapier2d", kNormalsBefore, kOfRapierKeptNormals,
             normals_before_simplifying<parry::Rapier>),
    of_parry("rapier2d-edge-along-normal", "rapier2d", kEdgeAlongNormal, kOfRapierEdgeAlongNormal,
             edge_along_normal<parry::Rapier>),
    of_parry_lost("rapier2d-not-a-number", "rapier2d", kNotANumber,
                  not_a_number_of_clip<parry::Rapier>),
    of_parry("rapier2d-corner-cones", "rapier2d", kCornerCones, kOfRapierCornerCones,
             normal_of_corner_cones<parry::Rapier>),
    of_parry("rapier2d-lost-by-epa", "rapier2d", kLostByEpa, kOfRapierLostByEpa,
             contact_lost_by_epa<parry::Rapier>),
    of_parry("rapier2d-step-back", "rapier2d", kStepBack, kOfRapierStepBack,
             step_back_of_gjk<parry::Rapier>),
    of_parry("rapier2d-direction-of-roundings", "rapier2d", kDirectionOfRoundings,
             kOfRapierDirectionOfRoundings, direction_of_parry_places<parry::Rapier>),
    of_parry("rapier2d-gjk-stop", "rapier2d", kGjkStop, kOfRapierGjkStop,
             stop_of_gjk<parry::Rapier>),
    of_parry("rapier2d-touching-within-tolerance", "rapier2d", kTouchingWithin,
             kOfRapierTouchingWithin, touching_of_gjk<parry::Rapier>),
    of_parry("rapier2d-origin-within-tolerance", "rapier2d", kOriginWithin, kOfRapierOriginWithin,
             origin_within_tolerance<parry::Rapier>),
    of_parry("rapier2d-equal-corners", "rapier2d", kEqualCorners, kOfRapierEqualCorners,
             equal_corners_of_gjk<parry::Rapier>),
    of_parry("rapier2d-rounded-foot", "rapier2d", kRoundedFoot, kOfRapierRoundedFoot,
             rounded_foot_of_gjk<parry::Rapier>),
    of_parry("rapier2d-second-point-of-capsules", "rapier2d", kSecondPoint, kOfRapierSecondPoint,
             second_point_of_parry_capsules<parry::Rapier>),
    of_parry("rapier2d-crossing-capsules", "rapier2d", kCrossingCapsules, kOfRapierCrossingCapsules,
             crossing_of_parry_capsules<parry::Rapier>),
    of_parry("rapier2d-nearly-parallel-capsules", "rapier2d", kNearlyParallel,
             kOfRapierNearlyParallel, nearly_parallel_parry_capsules<parry::Rapier>),
    of_parry("rapier2d-corner-of-chord", "rapier2d", kCornerOfChord, kOfRapierCornerOfChord,
             corner_of_epa_chord<parry::Rapier>),
    of_parry("rapier2d-centre-on-surface", "rapier2d", kCentreOnSurface, kOfRapierCentreOnSurface,
             centre_on_surface<parry::Rapier>),
    of_parry("rapier2d-circle-by-gjk", "rapier2d", kCircleByGjk, kOfRapierCircleByGjk,
             circle_by_gjk_stop<parry::Rapier>),
    of_parry("rapier2d-epa-chord", "rapier2d", kEpaChord, kOfRapierEpaChord,
             chord_of_epa<parry::Rapier>),
};

}  // namespace manifuzz::ledger_of
