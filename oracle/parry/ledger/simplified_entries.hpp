#pragma once

#include <array>

#include "oracle/parry/ledger/faults.hpp"

namespace manifuzz::ledger_of {

// parry2d 0.30.2 in floats, polygons by from_convex_polyline. Budgets are twice what 300,000 cases
// against clip64 showed, or another million, rounded up.
inline constexpr Budget kOfParrySimplifiedFaceByCosine[] = {
    {"micro_edge", 2200}, {"near_collinear", 200}, {"scaled", 4400}, {"ulp", 200}};
inline constexpr Budget kOfParrySimplifiedEdgeAlongNormal[] = {{"cores_touch", 200},
                                                               {"in_line", 4400}};
inline constexpr Budget kOfParrySimplifiedCornerCones[] = {
    {"cores_touch", 11000},   {"corner_corner", 9200},
    {"far_from_origin", 800}, {"grid", 92000},
    {"micro_edge", 800},      {"mixed_shapes", 1000},
    {"off_unit", 1000},       {"regular", 200},
    {"round_corners", 200},   {"scaled", 23000},
    {"sliver", 3600},         {"tie_bias", 2000},
    {"touching", 22000},      {"ulp", 5800}};
inline constexpr Budget kOfParrySimplifiedLostByEpa[] = {{"cores_touch", 7600},
                                                         {"in_line", 7000},
                                                         {"near_parallel", 400},
                                                         {"scaled", 34000},
                                                         {"ulp", 3200}};
inline constexpr Budget kOfParrySimplifiedDirectionOfRoundings[] = {
    {"capsules", 4600},    {"cores_touch", 85000},  {"in_line", 130000},
    {"large_radii", 2400}, {"mixed_shapes", 2000},  {"round_corners", 1800},
    {"side_planes", 9400}, {"tilted_edges", 11000}, {"voronoi_lines", 2000}};
inline constexpr Budget kOfParrySimplifiedGjkStop[] = {
    {"capsules", 400},     {"in_line", 11000},     {"large_radii", 110000}, {"mixed_shapes", 200},
    {"side_planes", 1200}, {"tilted_edges", 4600}, {"voronoi_lines", 3400}, {"round_corners", 610}};
inline constexpr Budget kOfParrySimplifiedTouchingWithin[] = {
    {"capsules", 800},        {"cores_touch", 28000}, {"corner_corner", 200},
    {"far_from_origin", 200}, {"generic", 200},       {"in_line", 16000},
    {"micro_edge", 5600},     {"mixed_shapes", 400},  {"near_collinear", 200},
    {"near_parallel", 20000}, {"off_unit", 200},      {"regular", 200},
    {"round_corners", 800},   {"scaled", 400},        {"side_planes", 1600},
    {"sliver", 2200},         {"tie_bias", 1000},     {"tied_faces", 200},
    {"tilted_edges", 1600},   {"touching", 1200},     {"ulp", 1200},
    {"voronoi_lines", 200}};
inline constexpr Budget kOfParrySimplifiedOriginWithin[] = {
    {"capsules", 200},    {"cores_touch", 3000}, {"corner_corner", 8800}, {"far_from_origin", 400},
    {"micro_edge", 3200}, {"mixed_shapes", 200}, {"off_unit", 1000},      {"regular", 200},
    {"scaled", 800},      {"sliver", 600},       {"tie_bias", 1400},      {"tied_faces", 1600},
    {"touching", 11000},  {"ulp", 2600}};
inline constexpr Budget kOfParrySimplifiedEqualCorners[] = {
    {"circles", 200},    {"cores_touch", 3800}, {"micro_edge", 15000},
    {"tied_faces", 400}, {"ulp", 1000},         {"voronoi_lines", 200}};
inline constexpr Budget kOfParrySimplifiedSecondPoint[] = {
    {"capsules", 11000},    {"cores_touch", 7800}, {"in_line", 600},       {"large_radii", 89000},
    {"mixed_shapes", 1200}, {"side_planes", 2600}, {"tilted_edges", 1000}, {"voronoi_lines", 2600}};
inline constexpr Budget kOfParrySimplifiedCrossingCapsules[] = {
    {"capsules", 18000},    {"cores_touch", 64000}, {"in_line", 310000},
    {"mixed_shapes", 3200}, {"tilted_edges", 7600}, {"voronoi_lines", 3400}};
inline constexpr Budget kOfParrySimplifiedNearlyParallel[] = {{"large_radii", 800},
                                                              {"tilted_edges", 2200}};
inline constexpr Budget kOfParrySimplifiedCornerOfChord[] = {{"cores_touch", 2400}};
inline constexpr Budget kOfParrySimplifiedCentreOnSurface[] = {{"circles", 8600},
                                                               {"cores_touch", 140000},
                                                               {"large_radii", 7600},
                                                               {"mixed_shapes", 3000},
                                                               {"voronoi_lines", 19000}};
inline constexpr Budget kOfParrySimplifiedCircleByGjk[] = {{"circles", 240000},
                                                           {"cores_touch", 1600},
                                                           {"large_radii", 77000},
                                                           {"mixed_shapes", 58000},
                                                           {"voronoi_lines", 120000}};
inline constexpr Budget kOfParrySimplifiedEpaChord[] = {{"cores_touch", 120000}};
inline constexpr Budget kOfParrySimplifiedStepBack[] = {
    {"capsules", 200}, {"cores_touch", 200}, {"side_planes", 1200}, {"voronoi_lines", 1200}};
inline constexpr Budget kOfParrySimplifiedKeptNormals[] = {
    {"cores_touch", 200},  {"corner_face", 240}, {"far_from_origin", 120},
    {"generic", 60},       {"micro_edge", 120},  {"near_collinear", 120},
    {"near_parallel", 60}, {"off_unit", 600},    {"round_corners", 180},
    {"scaled", 200},       {"sliver", 400},      {"tie_bias", 60},
    {"ulp", 120}};
inline constexpr Budget kOfParrySimplifiedRoundedFoot[] = {{"cores_touch", 200}};

/// The entries, the first that explains before others.
inline constexpr std::array kOfParrySimplified{
    of_parry("parry2d-simplified-face-by-cosine", "parry2d-simplified", kFaceByCosine,
             kOfParrySimplifiedFaceByCosine, clip_of_face_by_cosine<parry::Floats>),
    of_parry("parry2d-simplified-kept-normals", "parry2d-simplified", kNormalsBefore,
             kOfParrySimplifiedKeptNormals, normals_before_simplifying<parry::Floats>),
    of_parry("parry2d-simplified-edge-along-normal", "parry2d-simplified", kEdgeAlongNormal,
             kOfParrySimplifiedEdgeAlongNormal, edge_along_normal<parry::Floats>),
    of_parry_lost("parry2d-simplified-not-a-number", "parry2d-simplified", kNotANumber,
                  not_a_number_of_clip<parry::Floats>),
    of_parry("parry2d-simplified-corner-cones", "parry2d-simplified", kCornerCones,
             kOfParrySimplifiedCornerCones, normal_of_corner_cones<parry::Floats>),
    of_parry("parry2d-simplified-lost-by-epa", "parry2d-simplified", kLostByEpa,
             kOfParrySimplifiedLostByEpa, contact_lost_by_epa<parry::Floats>),
    of_parry("parry2d-simplified-step-back", "parry2d-simplified", kStepBack,
             kOfParrySimplifiedStepBack, step_back_of_gjk<parry::Floats>),
    of_parry("parry2d-simplified-direction-of-roundings", "parry2d-simplified",
             kDirectionOfRoundings, kOfParrySimplifiedDirectionOfRoundings,
             direction_of_parry_places<parry::Floats>),
    of_parry("parry2d-simplified-gjk-stop", "parry2d-simplified", kGjkStop,
             kOfParrySimplifiedGjkStop, stop_of_gjk<parry::Floats>),
    of_parry("parry2d-simplified-touching-within-tolerance", "parry2d-simplified", kTouchingWithin,
             kOfParrySimplifiedTouchingWithin, touching_of_gjk<parry::Floats>),
    of_parry("parry2d-simplified-origin-within-tolerance", "parry2d-simplified", kOriginWithin,
             kOfParrySimplifiedOriginWithin, origin_within_tolerance<parry::Floats>),
    of_parry("parry2d-simplified-equal-corners", "parry2d-simplified", kEqualCorners,
             kOfParrySimplifiedEqualCorners, equal_corners_of_gjk<parry::Floats>),
    of_parry("parry2d-simplified-rounded-foot", "parry2d-simplified", kRoundedFoot,
             kOfParrySimplifiedRoundedFoot, rounded_foot_of_gjk<parry::Floats>),
    of_parry("parry2d-simplified-second-point-of-capsules", "parry2d-simplified", kSecondPoint,
             kOfParrySimplifiedSecondPoint, second_point_of_parry_capsules<parry::Floats>),
    of_parry("parry2d-simplified-crossing-capsules", "parry2d-simplified", kCrossingCapsules,
             kOfParrySimplifiedCrossingCapsules, crossing_of_parry_capsules<parry::Floats>),
    of_parry("parry2d-simplified-nearly-parallel-capsules", "parry2d-simplified", kNearlyParallel,
             kOfParrySimplifiedNearlyParallel, nearly_parallel_parry_capsules<parry::Floats>),
    of_parry("parry2d-simplified-corner-of-chord", "parry2d-simplified", kCornerOfChord,
             kOfParrySimplifiedCornerOfChord, corner_of_epa_chord<parry::Floats>),
    of_parry("parry2d-simplified-centre-on-surface", "parry2d-simplified", kCentreOnSurface,
             kOfParrySimplifiedCentreOnSurface, centre_on_surface<parry::Floats>),
    of_parry("parry2d-simplified-circle-by-gjk", "parry2d-simplified", kCircleByGjk,
             kOfParrySimplifiedCircleByGjk, circle_by_gjk_stop<parry::Floats>),
    of_parry("parry2d-simplified-epa-chord", "parry2d-simplified", kEpaChord,
             kOfParrySimplifiedEpaChord, chord_of_epa<parry::Floats>),
};

}  // namespace manifuzz::ledger_of
