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
#include "judging/round_contact.cpp"
#include "judging/second_point.cpp"
#include "judging/turned_faces.cpp"
#include "judging/unjudged.cpp"
#include "judging/used_shapes.cpp"

namespace manifuzz {

/// A planted judge explains nothing: bugs are looked for in what is right and wrong.
std::vector<LedgerEntry> built_ledger() {
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
