// Copied with the bugs planted into the judge, and compiled under a namespace of theirs.
#include "canary/planted.hpp"
#include "judging/admissible.cpp"
#include "judging/bounds.cpp"
#include "judging/by_curve.cpp"
#include "judging/compare.cpp"
#include "judging/extent.cpp"
#include "judging/judge.cpp"
#include "judging/ledger.cpp"
#include "judging/ledger/box2d/box2d3_capsules.cpp"
#include "judging/ledger/box2d/box2d3_deviations.cpp"
#include "judging/ledger/box2d/box2d3_replay.cpp"
#include "judging/ledger/box2d/box2d_deviations.cpp"
#include "judging/ledger/box2d/phaser_deviations.cpp"
#include "judging/ledger/box2d/phaser_polygons.cpp"
#include "judging/ledger/box2d/planck_deviations.cpp"
#include "judging/ledger/bullet/bullet_deviations.cpp"
#include "judging/ledger/bullet/libccd_deviations.cpp"
#include "judging/ledger/chipmunk/chipmunk_deviations.cpp"
#include "judging/ledger/chipmunk/ported_deviations.cpp"
#include "judging/ledger/differences.cpp"
#include "judging/ledger/npm/box2d_core_deviations.cpp"
#include "judging/ledger/npm/matter_deviations.cpp"
#include "judging/ledger/npm/matter_replay.cpp"
#include "judging/ledger/npm/nape_deviations.cpp"
#include "judging/ledger/npm/p2_deviations.cpp"
#include "judging/ledger/npm/p2_replay.cpp"
#include "judging/ledger/separating_axes/cute_deviations.cpp"
#include "judging/ledger/separating_axes/cute_gjk.cpp"
#include "judging/ledger/separating_axes/cute_manifold.cpp"
#include "judging/ledger/separating_axes/dyn4j_detectors.cpp"
#include "judging/ledger/separating_axes/dyn4j_deviations.cpp"
#include "judging/ledger/separating_axes/dyn4j_manifold.cpp"
#include "judging/ledger/separating_axes/dyn4j_shapes.cpp"
#include "judging/ledger/separating_axes/godot_deviations.cpp"
#include "judging/ledger/separating_axes/godot_shapes.cpp"
#include "judging/ledger/separating_axes/godot_solver.cpp"
#include "judging/ledger/separating_axes/jbox2d_climbing.cpp"
#include "judging/ledger/separating_axes/replayed.cpp"
#include "judging/ledger/separating_axes/sat_deviations.cpp"
#include "judging/ledger/parry/parry_adapters.cpp"
#include "judging/ledger/parry/parry_contact.cpp"
#include "judging/ledger/parry/parry_deviations.cpp"
#include "judging/ledger/parry/parry_replay.cpp"
#include "judging/ledger/parry/parry_round_deviations.cpp"
#include "judging/ledger/parry/rapier_adapters.cpp"
#include "judging/malformed.cpp"
#include "judging/manifold_error.cpp"
#include "judging/mitred_contact.cpp"
#include "judging/round_contact.cpp"
#include "judging/used_shapes.cpp"
#include "oracle/exact/along.cpp"
#include "oracle/exact/clip.cpp"
#include "oracle/exact/curve.cpp"
#include "oracle/exact/hausdorff.cpp"
#include "oracle/exact/placed.cpp"
#include "oracle/exact/truth.cpp"
#include "oracle/exact/witness.cpp"

namespace manifuzz {
namespace {

Bucket bucket_of(const PairCase& pair, const Declaration& subject, const Answer& of_subject,
                 const Declaration& oracle, const Answer& of_oracle) {
  return judge(pair, ColliderAnswer{subject, of_subject}, ColliderAnswer{oracle, of_oracle}).bucket;
}

[[maybe_unused]] const bool planted = canary::add_judges({PLANTED_BUGS}, bucket_of);

}  // namespace
}  // namespace manifuzz
