#pragma once

#include <array>

#include "oracle/parry/ledger/faults.hpp"

namespace manifuzz::ledger_of {

// parry2d 0.30.2 in floats. Budgets (budgets.json) are twice what 300,000 cases against clip64
// showed, rounded up.

/// The entries, the first that explains before others.
inline constexpr std::array kOfParry{
    of_parry("parry2d-face-by-cosine", "parry2d", kFaceByCosine,
             clip_of_face_by_cosine<parry::Floats>),
    of_parry("parry2d-squared-length", "parry2d", kSquaredLength,
             squared_length_of_epa<parry::Floats>),
    of_parry("parry2d-edge-along-normal", "parry2d", kEdgeAlongNormal,
             edge_along_normal<parry::Floats>),
    of_parry_lost("parry2d-not-a-number", "parry2d", kNotANumber,
                  not_a_number_of_clip<parry::Floats>),
    of_parry("parry2d-corner-cones", "parry2d", kCornerCones,
             normal_of_corner_cones<parry::Floats>),
    of_parry("parry2d-lost-by-epa", "parry2d", kLostByEpa, contact_lost_by_epa<parry::Floats>),
    of_parry("parry2d-step-back", "parry2d", kStepBack, step_back_of_gjk<parry::Floats>),
    of_parry("parry2d-direction-of-roundings", "parry2d", kDirectionOfRoundings,
             direction_of_parry_places<parry::Floats>),
    of_parry("parry2d-gjk-stop", "parry2d", kGjkStop, stop_of_gjk<parry::Floats>),
    of_parry("parry2d-touching-within-tolerance", "parry2d", kTouchingWithin,
             touching_of_gjk<parry::Floats>),
    of_parry("parry2d-origin-within-tolerance", "parry2d", kOriginWithin,
             origin_within_tolerance<parry::Floats>),
    of_parry("parry2d-equal-corners", "parry2d", kEqualCorners,
             equal_corners_of_gjk<parry::Floats>),
    of_parry("parry2d-rounded-foot", "parry2d", kRoundedFoot, rounded_foot_of_gjk<parry::Floats>),
    of_parry("parry2d-second-point-of-capsules", "parry2d", kSecondPoint,
             second_point_of_parry_capsules<parry::Floats>),
    of_parry("parry2d-crossing-capsules", "parry2d", kCrossingCapsules,
             crossing_of_parry_capsules<parry::Floats>),
    of_parry("parry2d-nearly-parallel-capsules", "parry2d", kNearlyParallel,
             nearly_parallel_parry_capsules<parry::Floats>),
    of_parry("parry2d-corner-of-chord", "parry2d", kCornerOfChord,
             corner_of_epa_chord<parry::Floats>),
    of_parry("parry2d-centre-on-surface", "parry2d", kCentreOnSurface,
             centre_on_surface<parry::Floats>),
    of_parry("parry2d-circle-by-gjk", "parry2d", kCircleByGjk, circle_by_gjk_stop<parry::Floats>),
    of_parry("parry2d-epa-chord", "parry2d", kEpaChord, chord_of_epa<parry::Floats>),
};

}  // namespace manifuzz::ledger_of
