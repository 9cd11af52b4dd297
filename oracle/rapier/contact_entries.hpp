#pragma once

#include <array>

#include "oracle/parry/ledger/faults.hpp"

namespace manifuzz::ledger_of {

// rapier2d-compat 0.21.0 asked by contactCollider, in floats. Budgets are twice what 300,000 cases
// against clip64 showed, or another million, rounded up.
inline constexpr Budget kOfRapierContactCornerCones[] = {
    {"corner_corner", 7400}, {"far_from_origin", 800}, {"grid", 45000},    {"in_line", 3800},
    {"micro_edge", 600},     {"mixed_shapes", 800},    {"off_unit", 2000}, {"regular", 400},
    {"scaled", 34000},       {"side_planes", 1000},    {"tie_bias", 1400}, {"touching", 20000},
    {"ulp", 4000},           {"round_corners", 400},   {"sliver", 2400}};
inline constexpr Budget kOfRapierContactLostByEpa[] = {
    {"cores_touch", 200}, {"in_line", 600},      {"near_parallel", 400}, {"round_corners", 200},
    {"scaled", 33000},    {"tilted_edges", 400}, {"ulp", 3200},          {"side_planes", 400}};
inline constexpr Budget kOfRapierContactTouchingWithin[] = {
    {"capsules", 5800},      {"large_radii", 400},
    {"micro_edge", 1200},    {"mixed_shapes", 3400},
    {"near_collinear", 200}, {"near_parallel", 5800},
    {"off_unit", 200},       {"round_corners", 4800},
    {"scaled", 800},         {"side_planes", 5200},
    {"tie_bias", 800},       {"tied_faces", 400},
    {"tilted_edges", 4000},  {"ulp", 600},
    {"voronoi_lines", 600},  {"sliver", 1400}};
inline constexpr Budget kOfRapierContactOriginWithin[] = {
    {"capsules", 400},    {"corner_corner", 9000}, {"far_from_origin", 400}, {"grid", 200},
    {"in_line", 2000},    {"large_radii", 5000},   {"micro_edge", 2400},     {"mixed_shapes", 200},
    {"off_unit", 1200},   {"regular", 200},        {"round_corners", 2000},  {"scaled", 200},
    {"side_planes", 800}, {"tie_bias", 1000},      {"tied_faces", 800},      {"touching", 9400},
    {"ulp", 2000},        {"voronoi_lines", 2400}, {"sliver", 400}};
inline constexpr Budget kOfRapierContactEqualCorners[] = {
    {"capsules", 8600},     {"circles", 200},       {"cores_touch", 5200},   {"in_line", 4200},
    {"micro_edge", 14000},  {"mixed_shapes", 5400}, {"round_corners", 5000}, {"scaled", 3200},
    {"side_planes", 7600},  {"tied_faces", 200},    {"tilted_edges", 7600},  {"ulp", 800},
    {"voronoi_lines", 2400}};
inline constexpr Budget kOfRapierContactCornerOfChord[] = {{"boxes", 1400},
                                                           {"capsules", 200},
                                                           {"cores_touch", 33000},
                                                           {"corner_face", 600},
                                                           {"deep", 400},
                                                           {"generic", 2200},
                                                           {"grid", 4800},
                                                           {"in_line", 110000},
                                                           {"micro_edge", 1200},
                                                           {"mixed_shapes", 1600},
                                                           {"near_collinear", 2400},
                                                           {"near_parallel", 4400},
                                                           {"regular", 2800},
                                                           {"round_corners", 400},
                                                           {"scaled", 1400},
                                                           {"side_planes", 200},
                                                           {"tied_faces", 200},
                                                           {"tilted_edges", 400},
                                                           {"touching", 7400},
                                                           {"ulp", 800},
                                                           {"voronoi_lines", 200},
                                                           {"corner_corner", 400},
                                                           {"large_radii", 400},
                                                           {"off_unit", 600},
                                                           {"sliver", 1000}};
inline constexpr Budget kOfRapierContactCentreOnSurface[] = {{"circles", 11000},
                                                             {"cores_touch", 88000},
                                                             {"large_radii", 8000},
                                                             {"mixed_shapes", 3400},
                                                             {"voronoi_lines", 18000}};
inline constexpr Budget kOfRapierContactCircleByGjk[] = {{"circles", 230000},
                                                         {"cores_touch", 1400},
                                                         {"large_radii", 77000},
                                                         {"mixed_shapes", 57000},
                                                         {"voronoi_lines", 120000}};
inline constexpr Budget kOfRapierContactEpaChord[] = {{"capsules", 360000},
                                                      {"cores_touch", 550000},
                                                      {"corner_corner", 200},
                                                      {"deep", 1200},
                                                      {"grid", 1400},
                                                      {"in_line", 510000},
                                                      {"large_radii", 650000},
                                                      {"micro_edge", 1200},
                                                      {"mixed_shapes", 230000},
                                                      {"near_collinear", 7600},
                                                      {"round_corners", 450000},
                                                      {"scaled", 600},
                                                      {"side_planes", 260000},
                                                      {"tie_bias", 600},
                                                      {"tied_faces", 23000},
                                                      {"tilted_edges", 270000},
                                                      {"ulp", 2800},
                                                      {"voronoi_lines", 320000},
                                                      {"regular", 1400},
                                                      {"sliver", 800}};
inline constexpr Budget kOfRapierContactStepBack[] = {{"side_planes", 1}, {"voronoi_lines", 600}};
inline constexpr Budget kOfRapierContactRoundedFoot[] = {{"cores_touch", 200}};

/// The entries, the first that explains before others.
inline constexpr std::array kOfRapierContact{
    of_parry("rapier2d-contact-corner-cones", "rapier2d-contact", kCornerCones,
             kOfRapierContactCornerCones, normal_of_corner_cones<parry::RapierContact>),
    of_parry("rapier2d-contact-lost-by-epa", "rapier2d-contact", kLostByEpa,
             kOfRapierContactLostByEpa, contact_lost_by_epa<parry::RapierContact>),
    of_parry("rapier2d-contact-step-back", "rapier2d-contact", kStepBack, kOfRapierContactStepBack,
             step_back_of_gjk<parry::RapierContact>),
    of_parry("rapier2d-contact-touching-within-tolerance", "rapier2d-contact", kTouchingWithin,
             kOfRapierContactTouchingWithin, touching_of_gjk<parry::RapierContact>),
    of_parry("rapier2d-contact-origin-within-tolerance", "rapier2d-contact", kOriginWithin,
             kOfRapierContactOriginWithin, origin_within_tolerance<parry::RapierContact>),
    of_parry("rapier2d-contact-equal-corners", "rapier2d-contact", kEqualCorners,
             kOfRapierContactEqualCorners, equal_corners_of_gjk<parry::RapierContact>),
    of_parry("rapier2d-contact-rounded-foot", "rapier2d-contact", kRoundedFoot,
             kOfRapierContactRoundedFoot, rounded_foot_of_gjk<parry::RapierContact>),
    of_parry("rapier2d-contact-corner-of-chord", "rapier2d-contact", kCornerOfChord,
             kOfRapierContactCornerOfChord, corner_of_epa_chord<parry::RapierContact>),
    of_parry("rapier2d-contact-centre-on-surface", "rapier2d-contact", kCentreOnSurfaceOfContact,
             kOfRapierContactCentreOnSurface, centre_on_surface<parry::RapierContact>),
    of_parry("rapier2d-contact-circle-by-gjk", "rapier2d-contact", kCircleByGjk,
             kOfRapierContactCircleByGjk, circle_by_gjk_stop<parry::RapierContact>),
    of_parry("rapier2d-contact-epa-chord", "rapier2d-contact", kEpaChord, kOfRapierContactEpaChord,
             chord_of_epa<parry::RapierContact>),
};

}  // namespace manifuzz::ledger_of
