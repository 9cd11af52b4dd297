#include "engines/engine.hpp"

#include "judging/faults/shared_faults.hpp"
#include "oracle/box2d/box2d.hpp"
#include "oracle/box2d/deviations.hpp"
#include "oracle/box2d/round_shapes.hpp"

namespace manifuzz {
namespace {

constexpr LedgerRow kBox2dRows[] = {
    {"tiny-reference-face", tiny_reference_face_of_box2d},
    {"huge-reference-face", huge_reference_face},
    {"no-contact-under-bias", no_contact_under_bias},
    {"no-contact-on-tied-features", no_contact_on_tied_features},
    {"crossing-underflows", crossing_underflows},
    {"edge-slab-not-widened", edge_slab_not_widened},
    {"edge-hysteresis", edge_face_kept_by_hysteresis},
    {"edge-tied-incident", edge_clips_tied_incident},
    {"coincident-points", axis_for_coincident_points},
    {"direction-of-roundings", direction_of_roundings},
    {"corner-direction-not-normalised", corner_direction_not_normalised},
    {"face-within-epsilon", face_within_box2d_epsilon},
    {"circle-tied-faces", tied_face_of_box2d_circle},
};

}  // namespace

Engine engine_box2d() {
  return {.name = "box2d",
          .ledger = {{"box2d", kBox2dRows}},
          .colliders = {{"box2d", [] { return make_box2d(); }}},
          .passes = {{"box2d", "box2d", "clipping", box2d_pass},
                     {"box2d+world", "box2d", "", box2d::world_pass}},
          .scenes = {box2d_pairs, box2d_trajectory}};
}

}  // namespace manifuzz
