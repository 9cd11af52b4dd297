#pragma once

#include <array>

#include "judging/faults/shared_faults.hpp"
#include "oracle/nape-js/deviations.hpp"

namespace manifuzz::ledger_of {

// @newkrok/nape-js 1.0.0. Budgets (budgets.json) are twice what 300,000 cases against clip64
// showed, rounded up.

/// The entries, the first that explains before others.
inline constexpr std::array kOfNape{
    LedgerEntry{.id = "nape-js-corners-spliced",
                .collider = "nape-js",
                .description = "another shape than the case's: without corners whose sides have a "
                               "cross product, an area, below 1e-8, or that are as near the next",
                .source = "@newkrok/nape-js 1.0.0, js/libs/nape-js.js, "
                          "ZPP_Polygon.splice_collinear_real: crs * crs >= nape.Config.epsilon * "
                          "nape.Config.epsilon",
                .explains = corners_spliced_by_nape},
    LedgerEntry{.id = "nape-js-axis-within-epsilon",
                .collider = "nape-js",
                .description = "a normal along the world's x axis, the whole radius for a depth "
                               "and a centre for a point: a circle's centre is within 1e-8 of "
                               "another's or of a corner",
                .source = "@newkrok/nape-js 1.0.0, js/libs/nape-js.js, ZPP_Collide.contactCollide: "
                          "distSqr < nape.Config.epsilon * nape.Config.epsilon",
                .explains = axis_within_nape_epsilon},
    LedgerEntry{.id = "nape-js-unclipped-within-epsilon",
                .collider = "nape-js",
                .description = "a point beyond a side plane by less than 1e-8 of the incident "
                               "edge's length",
                .source = "@newkrok/nape-js 1.0.0, js/libs/nape-js.js, ZPP_Collide.contactCollide: "
                          "t > nape.Config.epsilon, t2 < -nape.Config.epsilon",
                .explains = unclipped_within_nape_epsilon},
    LedgerEntry{.id = "nape-js-edge-extended-to-slab",
                .collider = "nape-js",
                .description = "a point off the polygon: an incident edge that misses the slab, or "
                               "is along the normal but for roundings, is prolonged to it",
                .source = "@newkrok/nape-js 1.0.0, js/libs/nape-js.js, ZPP_Collide.contactCollide: "
                          "c0x += dvx * t1, of any t1",
                .explains = edge_extended_by_nape},
    LedgerEntry{.id = "nape-js-edge-of-no-run",
                .collider = "nape-js",
                .description = "an answer that holds no number: the incident edge has no run along "
                               "the reference face, and is prolonged by shares of it",
                .source = "@newkrok/nape-js 1.0.0, js/libs/nape-js.js, ZPP_Collide.contactCollide: "
                          "den = 1 / (d1 - d0)",
                .explains_lost = edge_of_no_run_in_nape},
    LedgerEntry{.id = "nape-js-no-contact-on-tied-features",
                .collider = "nape-js",
                .description = "no contact for overlapping polygons: faces or edges tie in double, "
                               "the wrong one is kept, and the incident edge, prolonged to its "
                               "side planes, is in front of it",
                .source = "@newkrok/nape-js 1.0.0, js/libs/nape-js.js, ZPP_Collide.contactCollide: "
                          "min > max, k2 < min2, first of equals; c0d > 0 && c1d > 0",
                .explains = no_contact_on_tied_features},
};

}  // namespace manifuzz::ledger_of
