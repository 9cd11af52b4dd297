#include "engines/engine.hpp"

#include "judging/faults/shared_faults.hpp"
#include "oracle/chipmunk/chipmunk_pass.hpp"
#include "oracle/chipmunk/deviations.hpp"

namespace manifuzz {
namespace {

constexpr LedgerRow kChipmunkRows[] = {
    {"normal-of-world-vertices", normal_of_rounded_vertices},
    {"corner-on-corner", corner_on_corner},
    {"collinear-apart", collinear_and_apart},
    {"wrong-support-edge", neighbours_nearly_parallel},
    {"swapped-distance", sign_of_swapped_distance},
    {"polygon-radius-sign", sign_of_polygon_radius},
    {"direction-of-roundings", direction_to_place_on_segment},
    {"round-corner-on-corner", normal_across_corner_on_corner},
    {"round-collinear", normal_across_collinear},
    {"depth-by-crossing", depth_by_crossing},
    {"direction-between-corners", direction_between_corners},
    {"segment-normal-not-unit", segment_normal_not_unit},
};

}  // namespace

Engine engine_chipmunk() {
  return {.name = "chipmunk",
          .ledger = {{"chipmunk", kChipmunkRows}},
          .passes = {{"chipmunk", "chipmunk", "GJK, then clipping", chipmunk_pass}}};
}

}  // namespace manifuzz
