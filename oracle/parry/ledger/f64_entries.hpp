#pragma once

#include <array>

#include "oracle/parry/ledger/faults.hpp"

namespace manifuzz::ledger_of {

// parry2d-f64 0.30.2, in doubles. Budgets (budgets.json) are twice what 300,000 cases against
// clip64 showed, rounded up.

/// The entries, the first that explains before others.
inline constexpr std::array kOfParryF64{
    of_parry("parry2d-f64-face-by-cosine", "parry2d-f64", kFaceByCosine,
             clip_of_face_by_cosine<parry::Doubles>),
    of_parry("parry2d-f64-edge-along-normal", "parry2d-f64", kEdgeAlongNormal,
             edge_along_normal<parry::Doubles>),
    of_parry("parry2d-f64-corner-cones", "parry2d-f64", kCornerCones,
             normal_of_corner_cones<parry::Doubles>),
    of_parry("parry2d-f64-lost-by-epa", "parry2d-f64", kLostByEpa,
             contact_lost_by_epa<parry::Doubles>),
    of_parry("parry2d-f64-step-back", "parry2d-f64", kStepBack, step_back_of_gjk<parry::Doubles>),
    of_parry("parry2d-f64-direction-of-roundings", "parry2d-f64", kDirectionOfRoundings,
             direction_of_parry_places<parry::Doubles>),
    of_parry("parry2d-f64-gjk-stop", "parry2d-f64", kGjkStop, stop_of_gjk<parry::Doubles>),
    of_parry("parry2d-f64-touching-within-tolerance", "parry2d-f64", kTouchingWithin,
             touching_of_gjk<parry::Doubles>),
    of_parry("parry2d-f64-equal-corners", "parry2d-f64", kEqualCorners,
             equal_corners_of_gjk<parry::Doubles>),
    of_parry("parry2d-f64-rounded-foot", "parry2d-f64", kRoundedFoot,
             rounded_foot_of_gjk<parry::Doubles>),
    of_parry("parry2d-f64-second-point-of-capsules", "parry2d-f64", kSecondPoint,
             second_point_of_parry_capsules<parry::Doubles>),
    of_parry("parry2d-f64-crossing-capsules", "parry2d-f64", kCrossingCapsules,
             crossing_of_parry_capsules<parry::Doubles>),
    of_parry("parry2d-f64-nearly-parallel-capsules", "parry2d-f64", kNearlyParallel,
             nearly_parallel_parry_capsules<parry::Doubles>),
    of_parry("parry2d-f64-corner-of-chord", "parry2d-f64", kCornerOfChord,
             corner_of_epa_chord<parry::Doubles>),
    of_parry("parry2d-f64-centre-on-surface", "parry2d-f64", kCentreOnSurface,
             centre_on_surface<parry::Doubles>),
    of_parry("parry2d-f64-circle-by-gjk", "parry2d-f64", kCircleByGjk,
             circle_by_gjk_stop<parry::Doubles>),
    of_parry("parry2d-f64-epa-chord", "parry2d-f64", kEpaChord, chord_of_epa<parry::Doubles>),
};

}  // namespace manifuzz::ledger_of
