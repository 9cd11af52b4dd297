#pragma once

#include "oracle/parry/ledger/round_faults.hpp"
#include "oracle/parry/ledger/search_faults.hpp"

namespace manifuzz::parry {

/// What colliders that give contact manifolds are known for; each has some of these causes.
template <class Engine>
inline constexpr LedgerRow kRowsOfManifolds[] = {
    {"face-by-cosine", clip_of_face_by_cosine<Engine>},
    {"squared-length", squared_length_of_epa<Engine>},
    {"kept-normals", normals_before_simplifying<Engine>},
    {"edge-along-normal", edge_along_normal<Engine>},
    {"not-a-number", nullptr, not_a_number_of_clip<Engine>},
    {"corner-cones", normal_of_corner_cones<Engine>},
    {"lost-by-epa", contact_lost_by_epa<Engine>},
    {"step-back", step_back_of_gjk<Engine>},
    {"direction-of-roundings", direction_of_parry_places<Engine>},
    {"gjk-stop", stop_of_gjk<Engine>},
    {"touching-within-tolerance", touching_of_gjk<Engine>},
    {"origin-within-tolerance", origin_within_tolerance<Engine>},
    {"equal-corners", equal_corners_of_gjk<Engine>},
    {"rounded-foot", rounded_foot_of_gjk<Engine>},
    {"second-point-of-capsules", second_point_of_parry_capsules<Engine>},
    {"crossing-capsules", crossing_of_parry_capsules<Engine>},
    {"nearly-parallel-capsules", nearly_parallel_parry_capsules<Engine>},
    {"corner-of-chord", corner_of_epa_chord<Engine>},
    {"centre-on-surface", centre_on_surface<Engine>},
    {"circle-by-gjk", circle_by_gjk_stop<Engine>},
    {"epa-chord", chord_of_epa<Engine>},
};

}  // namespace manifuzz::parry
