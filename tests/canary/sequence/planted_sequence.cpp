// Copied with the bugs planted into the judge of sequences, and compiled under a namespace of
// theirs.
#include "canary/sequence/sequence_bugs.hpp"
#include "sequence/birth.cpp"
#include "sequence/extent.cpp"
#include "sequence/frame_judge.cpp"
#include "sequence/kept_bounds.cpp"
#include "sequence/kept_faults.cpp"
#include "sequence/kept_point.cpp"
#include "sequence/match.cpp"
#include "sequence/sequence_judge.cpp"
#include "sequence/sequence_ledger.cpp"

namespace manifuzz {

/// A planted judge of sequences explains nothing: bugs are looked for in what is right and wrong.
std::vector<SequenceEntry> built_sequence_ledger() {
  return {};
}

namespace {

Bucket bucket_of(const Sequence& sequence, const SequenceCollider& subject,
                 std::span<const KeptAnswer> answers) {
  return judge_sequence(sequence, subject, answers).bucket;
}

[[maybe_unused]] const bool planted = canary::add_sequence_judges({PLANTED_BUGS}, bucket_of);

}  // namespace
}  // namespace manifuzz
