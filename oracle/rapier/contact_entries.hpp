#pragma once

#include <array>

#include "oracle/parry/ledger/faults.hpp"

namespace manifuzz::ledger_of {

// rapier2d-compat 0.21.0 asked by contactCollider, in floats. Budgets (budgets.json) are twice what
// 300,000 cases against clip64 showed, or another million, rounded up.

/// The entries, the first that explains before others.
inline constexpr std::array kOfRapierContact{
    of_parry("rapier2d-contact-corner-cones", "rapier2d-contact", kCornerCones,
             normal_of_corner_cones<parry::RapierContact>),
    of_parry("rapier2d-contact-lost-by-epa", "rapier2d-contact", kLostByEpa,
             contact_lost_by_epa<parry::RapierContact>),
    of_parry("rapier2d-contact-step-back", "rapier2d-contact", kStepBack,
             step_back_of_gjk<parry::RapierContact>),
    of_parry("rapier2d-contact-touching-within-tolerance", "rapier2d-contact", kTouchingWithin,
             touching_of_gjk<parry::RapierContact>),
    of_parry("rapier2d-contact-origin-within-tolerance", "rapier2d-contact", kOriginWithin,
             origin_within_tolerance<parry::RapierContact>),
    of_parry("rapier2d-contact-equal-corners", "rapier2d-contact", kEqualCorners,
             equal_corners_of_gjk<parry::RapierContact>),
    of_parry("rapier2d-contact-rounded-foot", "rapier2d-contact", kRoundedFoot,
             rounded_foot_of_gjk<parry::RapierContact>),
    of_parry("rapier2d-contact-corner-of-chord", "rapier2d-contact", kCornerOfChord,
             corner_of_epa_chord<parry::RapierContact>),
    of_parry("rapier2d-contact-centre-on-surface", "rapier2d-contact", kCentreOnSurfaceOfContact,
             centre_on_surface<parry::RapierContact>),
    of_parry("rapier2d-contact-circle-by-gjk", "rapier2d-contact", kCircleByGjk,
             circle_by_gjk_stop<parry::RapierContact>),
    of_parry("rapier2d-contact-epa-chord", "rapier2d-contact", kEpaChord,
             chord_of_epa<parry::RapierContact>),
};

}  // namespace manifuzz::ledger_of
