#pragma once

#include <array>

#include "oracle/parry/ledger/faults.hpp"

namespace manifuzz::ledger_of {

// parry2d 0.30.2 in floats. Budgets are twice what 300,000 cases against clip64
// showed, rounded up.
inline constexpr Budget kOfParryFaceByCosine[] = {{"micro_edge", 2200},  {"near_collinear", 11000},
                                                  {"scaled", 4800},      {"sliver", 56000},
                                                  {"tied_faces", 49000}, {"ulp", 4800}};
inline constexpr Budget kOfParryEdgeAlongNormal[] = {{"cores_touch", 200}, {"in_line", 4400}};
inline constexpr Budget kOfParryCornerCones[] = {{"cores_touch", 11000},   {"corner_corner", 9200},
                                                 {"far_from_origin", 800}, {"grid", 92000},
                                                 {"micro_edge", 800},      {"mixed_shapes", 1000},
                                                 {"off_unit", 1000},       {"regular", 200},
                                                 {"round_corners", 200},   {"scaled", 23000},
                                                 {"sliver", 3400},         {"tie_bias", 2000},
                                                 {"touching", 22000},      {"ulp", 6000}};
inline constexpr Budget kOfParryLostByEpa[] = {
    {"cores_touch", 7600}, {"in_line", 7000},    {"near_parallel", 400}, {"scaled", 34000},
    {"sliver", 6800},      {"tied_faces", 1000}, {"ulp", 3600}};
inline constexpr Budget kOfParryDirectionOfRoundings[] = {
    {"capsules", 4800},    {"cores_touch", 85000},  {"in_line", 130000},
    {"large_radii", 2400}, {"mixed_shapes", 2000},  {"round_corners", 1800},
    {"side_planes", 9400}, {"tilted_edges", 11000}, {"voronoi_lines", 2000}};
inline constexpr Budget kOfParryGjkStop[] = {{"capsules", 400},       {"in_line", 11000},
                                             {"large_radii", 110000}, {"mixed_shapes", 400},
                                             {"round_corners", 400},  {"side_planes", 1200},
                                             {"tilted_edges", 4600},  {"voronoi_lines", 3800}};
inline constexpr Budget kOfParryTouchingWithin[] = {
    {"capsules", 800},        {"cores_touch", 28000}, {"corner_corner", 200},
    {"far_from_origin", 200}, {"generic", 200},       {"in_line", 16000},
    {"micro_edge", 5600},     {"mixed_shapes", 400},  {"near_collinear", 8800},
    {"near_parallel", 20000}, {"off_unit", 200},      {"regular", 200},
    {"round_corners", 800},   {"scaled", 400},        {"side_planes", 1800},
    {"sliver", 65000},        {"tie_bias", 1000},     {"tied_faces", 6000},
    {"tilted_edges", 1600},   {"touching", 1200},     {"ulp", 6000},
    {"voronoi_lines", 200}};
inline constexpr Budget kOfParryOriginWithin[] = {
    {"capsules", 200},        {"cores_touch", 3000}, {"corner_corner", 8800},
    {"far_from_origin", 400}, {"micro_edge", 3200},  {"mixed_shapes", 200},
    {"near_collinear", 200},  {"off_unit", 1000},    {"regular", 200},
    {"scaled", 800},          {"sliver", 1800},      {"tie_bias", 1400},
    {"tied_faces", 1600},     {"touching", 11000},   {"ulp", 2800}};
inline constexpr Budget kOfParryEqualCorners[] = {{"circles", 200},      {"cores_touch", 3800},
                                                  {"micro_edge", 15000}, {"tied_faces", 400},
                                                  {"ulp", 1000},         {"voronoi_lines", 200}};
inline constexpr Budget kOfParrySecondPoint[] = {
    {"capsules", 11000},    {"cores_touch", 7800}, {"in_line", 600},       {"large_radii", 89000},
    {"mixed_shapes", 1200}, {"side_planes", 2600}, {"tilted_edges", 1000}, {"voronoi_lines", 2600}};
inline constexpr Budget kOfParryCrossingCapsules[] = {
    {"capsules", 18000},    {"cores_touch", 64000}, {"in_line", 310000},
    {"mixed_shapes", 3200}, {"tilted_edges", 7600}, {"voronoi_lines", 3400}};
inline constexpr Budget kOfParryNearlyParallel[] = {{"large_radii", 800}, {"tilted_edges", 2200}};
inline constexpr Budget kOfParryCornerOfChord[] = {{"cores_touch", 2600}};
inline constexpr Budget kOfParryCentreOnSurface[] = {{"circles", 8800},
                                                     {"cores_touch", 140000},
                                                     {"large_radii", 7800},
                                                     {"mixed_shapes", 3000},
                                                     {"voronoi_lines", 19000}};
inline constexpr Budget kOfParryCircleByGjk[] = {{"circles", 250000},
                                                 {"cores_touch", 1600},
                                                 {"large_radii", 80000},
                                                 {"mixed_shapes", 59000},
                                                 {"voronoi_lines", 120000}};
inline constexpr Budget kOfParryEpaChord[] = {{"cores_touch", 120000}};
inline constexpr Budget kOfParryStepBack[] = {
    {"capsules", 200}, {"cores_touch", 200}, {"side_planes", 1200}, {"voronoi_lines", 1200}};
inline constexpr Budget kOfParryRoundedFoot[] = {{"cores_touch", 200}};

/// The entries, the first that explains before others.
inline constexpr std::array kOfParry{
    of_parry("parry2d-face-by-cosine", "parry2d", kFaceByCosine, kOfParryFaceByCosine,
             clip_of_face_by_cosine<parry::Floats>),
    of_parry("parry2d-squared-length", "parry2d", kSquaredLength, {},
             squared_length_of_epa<parry::Floats>),
    of_parry("parry2d-edge-along-normal", "parry2d", kEdgeAlongNormal, kOfParryEdgeAlongNormal,
             edge_along_normal<parry::Floats>),
    of_parry_lost("parry2d-not-a-number", "parry2d", kNotANumber,
                  not_a_number_of_clip<parry::Floats>),
    of_parry("parry2d-corner-cones", "parry2d", kCornerCones, kOfParryCornerCones,
             normal_of_corner_cones<parry::Floats>),
    of_parry("parry2d-lost-by-epa", "parry2d", kLostByEpa, kOfParryLostByEpa,
             contact_lost_by_epa<parry::Floats>),
    of_parry("parry2d-step-back", "parry2d", kStepBack, kOfParryStepBack,
             step_back_of_gjk<parry::Floats>),
    of_parry("parry2d-direction-of-roundings", "parry2d", kDirectionOfRoundings,
             kOfParryDirectionOfRoundings, direction_of_parry_places<parry::Floats>),
    of_parry("parry2d-gjk-stop", "parry2d", kGjkStop, kOfParryGjkStop, stop_of_gjk<parry::Floats>),
    of_parry("parry2d-touching-within-tolerance", "parry2d", kTouchingWithin,
             kOfParryTouchingWithin, touching_of_gjk<parry::Floats>),
    of_parry("parry2d-origin-within-tolerance", "parry2d", kOriginWithin, kOfParryOriginWithin,
             origin_within_tolerance<parry::Floats>),
    of_parry("parry2d-equal-corners", "parry2d", kEqualCorners, kOfParryEqualCorners,
             equal_corners_of_gjk<parry::Floats>),
    of_parry("parry2d-rounded-foot", "parry2d", kRoundedFoot, kOfParryRoundedFoot,
             rounded_foot_of_gjk<parry::Floats>),
    of_parry("parry2d-second-point-of-capsules", "parry2d", kSecondPoint, kOfParrySecondPoint,
             second_point_of_parry_capsules<parry::Floats>),
    of_parry("parry2d-crossing-capsules", "parry2d", kCrossingCapsules, kOfParryCrossingCapsules,
             crossing_of_parry_capsules<parry::Floats>),
    of_parry("parry2d-nearly-parallel-capsules", "parry2d", kNearlyParallel, kOfParryNearlyParallel,
             nearly_parallel_parry_capsules<parry::Floats>),
    of_parry("parry2d-corner-of-chord", "parry2d", kCornerOfChord, kOfParryCornerOfChord,
             corner_of_epa_chord<parry::Floats>),
    of_parry("parry2d-centre-on-surface", "parry2d", kCentreOnSurface, kOfParryCentreOnSurface,
             centre_on_surface<parry::Floats>),
    of_parry("parry2d-circle-by-gjk", "parry2d", kCircleByGjk, kOfParryCircleByGjk,
             circle_by_gjk_stop<parry::Floats>),
    of_parry("parry2d-epa-chord", "parry2d", kEpaChord, kOfParryEpaChord,
             chord_of_epa<parry::Floats>),
};

}  // namespace manifuzz::ledger_of
