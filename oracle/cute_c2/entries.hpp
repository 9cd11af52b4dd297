#pragma once

#include <array>

#include "judging/faults/shared_faults.hpp"
#include "oracle/cute_c2/deviations.hpp"

namespace manifuzz::ledger_of {

// cute_c2 1.08, in float. Budgets (budgets.json) are twice what 300,000 cases against clip64
// showed, rounded up.

/// The entries, the first that explains before others.
inline constexpr std::array kOfCute{
    LedgerEntry{
        .id = "cute_c2-placed-vertices",
        .collider = "cute_c2",
        .description = "a normal off by the roundoff of world coordinates over the face's length",
        .source = "cute_c2 1.08, in crate c2-sys 0.1.0 cute-header/cute_c2.c, c2SidePlanes: c2v in "
                  "= c2Norm(c2Sub(rb, ra))",
        .explains = fault_of_cute<FaultOfCute::placed_vertices>},
    LedgerEntry{.id = "cute_c2-bias",
                .collider = "cute_c2",
                .description =
                    "no contact for overlapping polygons: a face is preferred that is not the "
                    "least deep (A's in deep contacts, B's in shallow ones), and the incident "
                    "edge lies outside its side planes",
                .source = "cute_c2 1.08, in crate c2-sys 0.1.0 cute-header/cute_c2.c, "
                          "c2PolytoPolyManifold: sa * kRelTol > sb + kAbsTol",
                .explains = fault_of_cute<FaultOfCute::bias>},
    LedgerEntry{
        .id = "cute_c2-open-planes",
        .collider = "cute_c2",
        .description =
            "no contact, of an incident edge that ends on a side plane: one point is left of it",
        .source = "cute_c2 1.08, in crate c2-sys 0.1.0 cute-header/cute_c2.c, c2Clip: d0 * d1 <= "
                  "0; c2SidePlanes: c2Clip(seg, left) < 2",
        .explains = fault_of_cute<FaultOfCute::open_planes>},
    LedgerEntry{.id = "cute_c2-inside",
                .collider = "cute_c2",
                .description = "cores that cross or touch: the left side for a normal, the sum of "
                               "the radii for a depth, and without radii no contact",
                .source =
                    "cute_c2 1.08, in crate c2-sys 0.1.0 cute-header/cute_c2.c, "
                    "c2CapsuletoCapsuleManifold, c2CircletoCapsuleManifold: if (d == 0) n = "
                    "c2Norm(c2Skew(; "
                    "d < r, c2CapsuletoPolyManifold: d < A.r, of the rounded distance of c2GJK",
                .explains = fault_of_cute<FaultOfCute::inside>},
    LedgerEntry{.id = "cute_c2-nearest-places",
                .collider = "cute_c2",
                .description =
                    "another normal: the direction between the nearest points as floats have them, "
                    "or between corners nearer than 1.2e-7",
                .source = "cute_c2 1.08, in crate c2-sys 0.1.0 cute-header/cute_c2.c, "
                          "c2CapsuletoCapsuleManifold, c2CircletoCapsuleManifold, "
                          "c2CircletoPolyManifold, c2CapsuletoPolyManifold: c2Sub(b, a) of c2GJK, "
                          "which ends at c2Dot(d, d) < FLT_EPSILON * FLT_EPSILON",
                .explains = fault_of_cute<FaultOfCute::nearest_places>},
    LedgerEntry{.id = "cute_c2-two-frames",
                .collider = "cute_c2",
                .description = "a wrong depth and place, or no contact: a capsule's ends in the "
                               "polygon's frame clip an edge in the world",
                .source = "cute_c2 1.08, in crate c2-sys 0.1.0 cute-header/cute_c2.c, "
                          "c2CapsuletoPolyManifold: c2SidePlanes(incident, A_in_B.b, A_in_B.a, &h)",
                .explains = fault_of_cute<FaultOfCute::two_frames>},
    LedgerEntry{.id = "cute_c2-on-core",
                .collider = "cute_c2",
                .description = "points on a capsule's core, with the depth of its surface",
                .source = "cute_c2 1.08, in crate c2-sys 0.1.0 cute-header/cute_c2.c, "
                          "c2CapsuletoPolyManifold, case 0: m->depths[i] += A.r",
                .explains = fault_of_cute<FaultOfCute::on_core>},
    LedgerEntry{.id = "cute_c2-one-point",
                .collider = "cute_c2",
                .description =
                    "one point where two are needed: capsules always get one, a capsule and a "
                    "polygon where their cores are apart",
                .source = "cute_c2 1.08, in crate c2-sys 0.1.0 cute-header/cute_c2.c, "
                          "c2CapsuletoCapsuleManifold, c2CapsuletoPolyManifold: m->count = 1",
                .explains = fault_of_cute<FaultOfCute::one_point>},
    LedgerEntry{
        .id = "cute_c2-tied-features",
        .collider = "cute_c2",
        .description =
            "no contact of overlapping polygons: features that tie in float, the wrong one is kept",
        .source = "cute_c2 1.08, in crate c2-sys 0.1.0 cute-header/cute_c2.c, c2CheckFaces: d > "
                  "sep; c2Incident: dot < min_dot",
        .explains = tied_features_in_cute},
};

}  // namespace manifuzz::ledger_of
