#pragma once

#include <array>

#include "oracle/parry/ledger/faults.hpp"

namespace manifuzz::ledger_of {

// parry2d 0.30.2 in floats, polygons by from_convex_polyline. Budgets (budgets.json) are twice what
// 300,000 cases against clip64 showed, or another million, rounded up.

/// The entries, the first that explains before others.
inline constexpr std::array kOfParrySimplified{
    of_parry("parry2d-simplified-face-by-cosine", "parry2d-simplified", kFaceByCosine,
             clip_of_face_by_cosine<parry::Floats>),
    of_parry("parry2d-simplified-kept-normals", "parry2d-simplified", kNormalsBefore,
             normals_before_simplifying<parry::Floats>),
    of_parry("parry2d-simplified-edge-along-normal", "parry2d-simplified", kEdgeAlongNormal,
             edge_along_normal<parry::Floats>),
    of_parry_lost("parry2d-simplified-not-a-number", "parry2d-simplified", kNotANumber,
                  not_a_number_of_clip<parry::Floats>),
    of_parry("parry2d-simplified-corner-cones", "parry2d-simplified", kCornerCones,
             normal_of_corner_cones<parry::Floats>),
    of_parry("parry2d-simplified-lost-by-epa", "parry2d-simplified", kLostByEpa,
             contact_lost_by_epa<parry::Floats>),
    of_parry("parry2d-simplified-step-back", "parry2d-simplified", kStepBack,
             step_back_of_gjk<parry::Floats>),
    of_parry("parry2d-simplified-direction-of-roundings", "parry2d-simplified",
             kDirectionOfRoundings, direction_of_parry_places<parry::Floats>),
    of_parry("parry2d-simplified-gjk-stop", "parry2d-simplified", kGjkStop,
             stop_of_gjk<parry::Floats>),
    of_parry("parry2d-simplified-touching-within-tolerance", "parry2d-simplified", kTouchingWithin,
             touching_of_gjk<parry::Floats>),
    of_parry("parry2d-simplified-origin-within-tolerance", "parry2d-simplified", kOriginWithin,
             origin_within_tolerance<parry::Floats>),
    of_parry("parry2d-simplified-equal-corners", "parry2d-simplified", kEqualCorners,
             equal_corners_of_gjk<parry::Floats>),
    of_parry("parry2d-simplified-rounded-foot", "parry2d-simplified", kRoundedFoot,
             rounded_foot_of_gjk<parry::Floats>),
    of_parry("parry2d-simplified-second-point-of-capsules", "parry2d-simplified", kSecondPoint,
             second_point_of_parry_capsules<parry::Floats>),
    of_parry("parry2d-simplified-crossing-capsules", "parry2d-simplified", kCrossingCapsules,
             crossing_of_parry_capsules<parry::Floats>),
    of_parry("parry2d-simplified-nearly-parallel-capsules", "parry2d-simplified", kNearlyParallel,
             nearly_parallel_parry_capsules<parry::Floats>),
    of_parry("parry2d-simplified-corner-of-chord", "parry2d-simplified", kCornerOfChord,
             corner_of_epa_chord<parry::Floats>),
    of_parry("parry2d-simplified-centre-on-surface", "parry2d-simplified", kCentreOnSurface,
             centre_on_surface<parry::Floats>),
    of_parry("parry2d-simplified-circle-by-gjk", "parry2d-simplified", kCircleByGjk,
             circle_by_gjk_stop<parry::Floats>),
    of_parry("parry2d-simplified-epa-chord", "parry2d-simplified", kEpaChord,
             chord_of_epa<parry::Floats>),
};

}  // namespace manifuzz::ledger_of
