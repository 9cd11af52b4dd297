#pragma once

#include <array>

#include "oracle/parry/ledger/faults.hpp"

namespace manifuzz::ledger_of {

// rapier2d-compat 0.21.0, which has parry2d 0.31.1 inside, in floats. Budgets (budgets.json) are
// twice what 300,000 cases against clip64 showed, or another million, rounded up.

/// The entries, the first that explains before others.
inline constexpr std::array kOfRapier{
    of_parry("rapier2d-face-by-cosine", "rapier2d", kFaceByCosine,
             clip_of_face_by_cosine<parry::Rapier>),
    of_parry("rapier2d-kept-normals", "rapier2d", kNormalsBefore,
             normals_before_simplifying<parry::Rapier>),
    of_parry("rapier2d-edge-along-normal", "rapier2d", kEdgeAlongNormal,
             edge_along_normal<parry::Rapier>),
    of_parry_lost("rapier2d-not-a-number", "rapier2d", kNotANumber,
                  not_a_number_of_clip<parry::Rapier>),
    of_parry("rapier2d-corner-cones", "rapier2d", kCornerCones,
             normal_of_corner_cones<parry::Rapier>),
    of_parry("rapier2d-lost-by-epa", "rapier2d", kLostByEpa, contact_lost_by_epa<parry::Rapier>),
    of_parry("rapier2d-step-back", "rapier2d", kStepBack, step_back_of_gjk<parry::Rapier>),
    of_parry("rapier2d-direction-of-roundings", "rapier2d", kDirectionOfRoundings,
             direction_of_parry_places<parry::Rapier>),
    of_parry("rapier2d-gjk-stop", "rapier2d", kGjkStop, stop_of_gjk<parry::Rapier>),
    of_parry("rapier2d-touching-within-tolerance", "rapier2d", kTouchingWithin,
             touching_of_gjk<parry::Rapier>),
    of_parry("rapier2d-origin-within-tolerance", "rapier2d", kOriginWithin,
             origin_within_tolerance<parry::Rapier>),
    of_parry("rapier2d-equal-corners", "rapier2d", kEqualCorners,
             equal_corners_of_gjk<parry::Rapier>),
    of_parry("rapier2d-rounded-foot", "rapier2d", kRoundedFoot, rounded_foot_of_gjk<parry::Rapier>),
    of_parry("rapier2d-second-point-of-capsules", "rapier2d", kSecondPoint,
             second_point_of_parry_capsules<parry::Rapier>),
    of_parry("rapier2d-crossing-capsules", "rapier2d", kCrossingCapsules,
             crossing_of_parry_capsules<parry::Rapier>),
    of_parry("rapier2d-nearly-parallel-capsules", "rapier2d", kNearlyParallel,
             nearly_parallel_parry_capsules<parry::Rapier>),
    of_parry("rapier2d-corner-of-chord", "rapier2d", kCornerOfChord,
             corner_of_epa_chord<parry::Rapier>),
    of_parry("rapier2d-centre-on-surface", "rapier2d", kCentreOnSurface,
             centre_on_surface<parry::Rapier>),
    of_parry("rapier2d-circle-by-gjk", "rapier2d", kCircleByGjk, circle_by_gjk_stop<parry::Rapier>),
    of_parry("rapier2d-epa-chord", "rapier2d", kEpaChord, chord_of_epa<parry::Rapier>),
};

}  // namespace manifuzz::ledger_of
