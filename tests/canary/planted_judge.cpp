// Copied with the bugs planted into the judge, and compiled under a namespace of theirs.
#include "canary/planted.hpp"
#include "judging/admissible.cpp"
#include "judging/bounds.cpp"
#include "judging/by_curve.cpp"
#include "judging/compare.cpp"
#include "judging/extent.cpp"
#include "judging/judge.cpp"
#include "judging/ledger.cpp"
#include "judging/ledger/box2d/box2d3_deviations.cpp"
#include "judging/ledger/box2d/box2d_deviations.cpp"
#include "judging/ledger/box2d/phaser_deviations.cpp"
#include "judging/ledger/box2d/phaser_polygons.cpp"
#include "judging/ledger/box2d/planck_deviations.cpp"
#include "judging/ledger/bullet/bullet_deviations.cpp"
#include "judging/ledger/bullet/bullet_directions.cpp"
#include "judging/ledger/bullet/bullet_epa.cpp"
#include "judging/ledger/bullet/bullet_gjk.cpp"
#include "judging/ledger/bullet/bullet_prisms.cpp"
#include "judging/ledger/bullet/bullet_query.cpp"
#include "judging/ledger/bullet/ccd_deviations.cpp"
#include "judging/ledger/bullet/ccd_polytope.cpp"
#include "judging/ledger/bullet/ccd_simplex.cpp"
#include "judging/ledger/bullet/libccd_deviations.cpp"
#include "judging/ledger/bullet/libccd_ray.cpp"
#include "judging/ledger/bullet/query_deviations.cpp"
#include "judging/ledger/bullet/voronoi_simplex.cpp"
#include "judging/ledger/chipmunk/chipmunk_deviations.cpp"
#include "judging/ledger/chipmunk/ported_deviations.cpp"
#include "judging/ledger/differences.cpp"
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
