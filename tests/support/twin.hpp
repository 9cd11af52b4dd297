#pragma once

#include <cstdlib>
#include <vector>

#include "judging/judge.hpp"

// The judge's twin: what the design calls truth and admissible, written a second time, slowly and
// plainly, over rationals and enclosures of their roots. It shares the bounds with the judge and
// nothing else.

namespace manifuzz {

/// How many cases a regime something is held against its twin: MANIFUZZ_TWIN_CASES, or as usual.
inline std::uint64_t twin_cases(std::uint64_t usual) {
  const char* const text = std::getenv("MANIFUZZ_TWIN_CASES");
  return text == nullptr ? usual : std::strtoull(text, nullptr, 10);
}

/// A reference face and an incident edge that a collider may take.
struct TwinCandidate {
  Side side = Side::a;
  int reference = 0;
  int incident = 0;

  friend bool operator==(const TwinCandidate&, const TwinCandidate&) = default;
};

struct TwinJudgement {
  bool touching = false;                  ///< S <= total radius
  std::vector<TwinCandidate> candidates;  ///< the subject's
  Bucket bucket;                          ///< as `as_twin_has_it`
};

/// The twin neither asks the ledger nor measures how wrong a clip is: errors have no class, and a
/// wrong clip with a contact that there may be, unless it is reversed, no kind.
inline Bucket as_twin_has_it(Bucket bucket, const PairCase& pair) {
  if (bucket.verdict == Verdict::known) bucket.verdict = Verdict::oracle_wrong;
  bucket.error_class = ErrorClass::none;
  const bool is_measured = bucket.kind != Kind::missed_contact &&
                           bucket.kind != Kind::phantom_contact && bucket.kind != Kind::reversed;
  if (bucket.fault != Fault::none && !is_round(pair) && is_measured) bucket.kind = Kind::none;
  return bucket;
}

TwinJudgement twin_judge(const PairCase& pair, const ColliderAnswer& subject,
                         const ColliderAnswer& oracle);

}  // namespace manifuzz
