#pragma once

#include <array>

#include "oracle/parry/ledger/faults.hpp"

namespace manifuzz::ledger_of {

// parry2d-f64 0.30.2, in doubles. Budgets are twice what 300,000 cases against clip64
// showed, rounded up.
inline constexpr Budget kOfParryF64FaceByCosine[] = {
    {"near_collinear", 54000}, {"tied_faces", 15000}, {"ulp", 3600}};
inline constexpr Budget kOfParryF64CornerCones[] = {
    {"cores_touch", 2400}, {"corner_corner", 200}, {"grid", 92000},
    {"mixed_shapes", 600}, {"off_unit", 600},      {"scaled", 800},
    {"sliver", 1000},      {"touching", 4400},     {"ulp", 4200}};
inline constexpr Budget kOfParryF64LostByEpa[] = {
    {"cores_touch", 3600}, {"in_line", 1400}, {"near_parallel", 200}, {"tied_faces", 200}};
inline constexpr Budget kOfParryF64DirectionOfRoundings[] = {
    {"capsules", 3200},     {"cores_touch", 190000}, {"in_line", 160000},
    {"mixed_shapes", 1200}, {"round_corners", 2000}, {"side_planes", 5600},
    {"tilted_edges", 5000}, {"voronoi_lines", 800}};
inline constexpr Budget kOfParryF64GjkStop[] = {
    {"capsules", 22000},     {"cores_touch", 1000},   {"in_line", 9800},
    {"large_radii", 170000}, {"mixed_shapes", 32000}, {"round_corners", 72000},
    {"side_planes", 150000}, {"tilted_edges", 47000}, {"voronoi_lines", 3800}};
inline constexpr Budget kOfParryF64TouchingWithin[] = {
    {"cores_touch", 5800},    {"in_line", 5200},       {"micro_edge", 400}, {"mixed_shapes", 200},
    {"near_collinear", 1000}, {"near_parallel", 1000}, {"tied_faces", 600}, {"ulp", 200},
    {"regular", 540}};
inline constexpr Budget kOfParryF64EqualCorners[] = {{"cores_touch", 200}, {"micro_edge", 200}};
inline constexpr Budget kOfParryF64SecondPoint[] = {
    {"capsules", 11000},     {"cores_touch", 11000},  {"in_line", 200},
    {"large_radii", 120000}, {"mixed_shapes", 1200},  {"side_planes", 4800},
    {"tilted_edges", 1000},  {"voronoi_lines", 18000}};
inline constexpr Budget kOfParryF64CrossingCapsules[] = {
    {"capsules", 18000},    {"cores_touch", 70000}, {"in_line", 300000},
    {"mixed_shapes", 3200}, {"tilted_edges", 7600}, {"voronoi_lines", 3400}};
inline constexpr Budget kOfParryF64NearlyParallel[] = {
    {"capsules", 11000},    {"cores_touch", 2000},  {"in_line", 3600},     {"large_radii", 2600},
    {"mixed_shapes", 1800}, {"side_planes", 19000}, {"tilted_edges", 5800}};
inline constexpr Budget kOfParryF64CornerOfChord[] = {{"cores_touch", 2200}};
inline constexpr Budget kOfParryF64CentreOnSurface[] = {
    {"circles", 2000}, {"cores_touch", 130000}, {"mixed_shapes", 600}, {"voronoi_lines", 1800}};
inline constexpr Budget kOfParryF64CircleByGjk[] = {{"circles", 360000},
                                                    {"cores_touch", 4800},
                                                    {"large_radii", 100000},
                                                    {"mixed_shapes", 90000},
                                                    {"voronoi_lines", 210000}};
inline constexpr Budget kOfParryF64EpaChord[] = {{"cores_touch", 130000}};
inline constexpr Budget kOfParryF64EdgeAlongNormal[] = {{"cores_touch", 200}, {"in_line", 4800}};
inline constexpr Budget kOfParryF64StepBack[] = {
    {"cores_touch", 200}, {"side_planes", 600}, {"voronoi_lines", 600}};

/// The entries, the first that explains before others.
inline constexpr std::array kOfParryF64{
    of_parry("parry2d-f64-face-by-cosine", "parry2d-f64", kFaceByCosine, kOfParryF64FaceByCosine,
             clip_of_face_by_cosine<parry::Doubles>),
    of_parry("parry2d-f64-edge-along-normal", "parry2d-f64", kEdgeAlongNormal,
             kOfParryF64EdgeAlongNormal, edge_along_normal<parry::Doubles>),
    of_parry("parry2d-f64-corner-cones", "parry2d-f64", kCornerCones, kOfParryF64CornerCones,
             normal_of_corner_cones<parry::Doubles>),
    of_parry("parry2d-f64-lost-by-epa", "parry2d-f64", kLostByEpa, kOfParryF64LostByEpa,
             contact_lost_by_epa<parry::Doubles>),
    of_parry("parry2d-f64-step-back", "parry2d-f64", kStepBack, kOfParryF64StepBack,
             step_back_of_gjk<parry::Doubles>),
    of_parry("parry2d-f64-direction-of-roundings", "parry2d-f64", kDirectionOfRoundings,
             kOfParryF64DirectionOfRoundings, direction_of_parry_places<parry::Doubles>),
    of_parry("parry2d-f64-gjk-stop", "parry2d-f64", kGjkStop, kOfParryF64GjkStop,
             stop_of_gjk<parry::Doubles>),
    of_parry("parry2d-f64-touching-within-tolerance", "parry2d-f64", kTouchingWithin,
             kOfParryF64TouchingWithin, touching_of_gjk<parry::Doubles>),
    of_parry("parry2d-f64-equal-corners", "parry2d-f64", kEqualCorners, kOfParryF64EqualCorners,
             equal_corners_of_gjk<parry::Doubles>),
    of_parry("parry2d-f64-rounded-foot", "parry2d-f64", kRoundedFoot, {},
             rounded_foot_of_gjk<parry::Doubles>),
    of_parry("parry2d-f64-second-point-of-capsules", "parry2d-f64", kSecondPoint,
             kOfParryF64SecondPoint, second_point_of_parry_capsules<parry::Doubles>),
    of_parry("parry2d-f64-crossing-capsules", "parry2d-f64", kCrossingCapsules,
             kOfParryF64CrossingCapsules, crossing_of_parry_capsules<parry::Doubles>),
    of_parry("parry2d-f64-nearly-parallel-capsules", "parry2d-f64", kNearlyParallel,
             kOfParryF64NearlyParallel, nearly_parallel_parry_capsules<parry::Doubles>),
    of_parry("parry2d-f64-corner-of-chord", "parry2d-f64", kCornerOfChord, kOfParryF64CornerOfChord,
             corner_of_epa_chord<parry::Doubles>),
    of_parry("parry2d-f64-centre-on-surface", "parry2d-f64", kCentreOnSurface,
             kOfParryF64CentreOnSurface, centre_on_surface<parry::Doubles>),
    of_parry("parry2d-f64-circle-by-gjk", "parry2d-f64", kCircleByGjk, kOfParryF64CircleByGjk,
             circle_by_gjk_stop<parry::Doubles>),
    of_parry("parry2d-f64-epa-chord", "parry2d-f64", kEpaChord, kOfParryF64EpaChord,
             chord_of_epa<parry::Doubles>),
};

}  // namespace manifuzz::ledger_of
