// Copied with the bugs planted into the judge, and compiled under a namespace of theirs.
#include "canary/one_target.hpp"
#include "canary/planted.hpp"
#include "exact/along.cpp"
#include "exact/clip.cpp"
#include "exact/curve.cpp"
#include "exact/hausdorff.cpp"
#include "exact/placed.cpp"
#include "exact/truth.cpp"
#include "exact/witness.cpp"
#include "judging/admissible.cpp"
#include "judging/bounds.cpp"
#include "judging/by_curve.cpp"
#include "judging/compare.cpp"
#include "judging/curve_answer.cpp"
#include "judging/errors/clip_error.cpp"
#include "judging/errors/curve_error.cpp"
#include "judging/errors/place_error.cpp"
#include "judging/extent.cpp"
#include "judging/judge.cpp"
#include "judging/ledger.cpp"
#include "judging/manifold_error.cpp"
#include "judging/mitred_contact.cpp"
#include "judging/round_contact.cpp"
#include "judging/tie_class.cpp"
#include "judging/turned_faces.cpp"
#include "judging/unjudged.cpp"
#include "judging/used_shapes.cpp"
#include "oracle/box2d-core/deviations.cpp"
#include "oracle/box2d/circles.cpp"
#include "oracle/box2d/edges.cpp"
#include "oracle/box2d3/capsules.cpp"
#include "oracle/box2d3/deviations.cpp"
#include "oracle/box2d3/replay.cpp"
#include "oracle/bullet/ledger/deviations.cpp"
#include "oracle/bullet/ledger/directions.cpp"
#include "oracle/bullet/ledger/epa.cpp"
#include "oracle/bullet/ledger/gjk.cpp"
#include "oracle/bullet/ledger/perturbed.cpp"
#include "oracle/bullet/ledger/perturbed_deviations.cpp"
#include "oracle/bullet/ledger/prisms.cpp"
#include "oracle/bullet/ledger/query.cpp"
#include "oracle/bullet/ledger/query_deviations.cpp"
#include "oracle/bullet/ledger/repeated_query.cpp"
#include "oracle/bullet/ledger/voronoi_simplex.cpp"
#include "oracle/chipmunk/corners.cpp"
#include "oracle/chipmunk/replay.cpp"
#include "oracle/chipmunk/round_shapes.cpp"
#include "oracle/cp/deviations.cpp"
#include "oracle/cute_c2/deviations.cpp"
#include "oracle/cute_c2/gjk.cpp"
#include "oracle/cute_c2/manifold.cpp"
#include "oracle/dyn4j/detectors.cpp"
#include "oracle/dyn4j/deviations.cpp"
#include "oracle/dyn4j/manifold.cpp"
#include "oracle/dyn4j/shapes.cpp"
#include "oracle/godot3/deviations.cpp"
#include "oracle/godot3/shapes.cpp"
#include "oracle/godot3/solver.cpp"
#include "oracle/jbox2d/climbing.cpp"
#include "oracle/jbox2d/edges.cpp"
#include "oracle/libccd/ledger/deviations.cpp"
#include "oracle/libccd/ledger/polytope.cpp"
#include "oracle/libccd/ledger/polytope_deviations.cpp"
#include "oracle/libccd/ledger/polytope_start.cpp"
#include "oracle/libccd/ledger/portal.cpp"
#include "oracle/libccd/ledger/prisms.cpp"
#include "oracle/libccd/ledger/ray.cpp"
#include "oracle/libccd/ledger/simplex.cpp"
#include "oracle/matter-js/deviations.cpp"
#include "oracle/matter-js/replay.cpp"
#include "oracle/nape-js/deviations.cpp"
#include "oracle/nape-js/replay.cpp"
#include "oracle/p2-es/deviations.cpp"
#include "oracle/p2-es/replay.cpp"
#include "oracle/parry/ledger/adapters.cpp"
#include "oracle/parry/ledger/contact.cpp"
#include "oracle/parry/ledger/deviations.cpp"
#include "oracle/parry/ledger/replay.cpp"
#include "oracle/parry/ledger/round_deviations.cpp"
#include "oracle/phaser-box2d/capsules.cpp"
#include "oracle/phaser-box2d/polygons.cpp"
#include "oracle/planck/circles.cpp"
#include "oracle/rapier/deviations.cpp"
#include "oracle/sat/deviations.cpp"

namespace manifuzz {

/// A planted judge explains nothing: bugs are looked for in what is right and wrong.
std::vector<BuiltLedger> built_ledgers() {
  return {};
}

namespace {

Bucket bucket_of(const PairCase& pair, const Declaration& subject, const Answer& of_subject,
                 const Declaration& oracle, const Answer& of_oracle) {
  return judge(pair, ColliderAnswer{subject, of_subject}, ColliderAnswer{oracle, of_oracle}).bucket;
}

[[maybe_unused]] const bool planted = canary::add_judges({PLANTED_BUGS}, bucket_of);

}  // namespace
}  // namespace manifuzz
