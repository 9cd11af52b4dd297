#pragma once

#include "judging/admissible.hpp"
#include "judging/ledger.hpp"
#include "judging/manifold_error.hpp"

namespace manifuzz {

/// A collider's declaration and what it answered: one party of a comparison.
struct ColliderAnswer {
  const Declaration& declaration;
  const Answer& answer;
};

/// What a case comes to between a subject and an oracle.
struct Judgement {
  Bucket bucket;
  double magnitude = 0;                      ///< the finding's worst error as a share of the size
  const LedgerEntry* explanation = nullptr;  ///< set where the verdict is known
  ManifoldError of_subject{};  ///< of a wrong manifold, as shares of the size; 0 of a right one
  ManifoldError of_oracle{};
};

/// Whether it says what a manifold can say: 0 to 2 points, finite figures, no depth below zero,
/// features that exist.
bool is_well_formed(const PairCase& pair, const Manifold<double>& manifold);

/// Where a case stands by the truth alone.
struct Standing {
  bool touching = false;  ///< S <= total radius, exactly
  bool near = false;      ///< S within 10% of the size from the total radius
};

inline constexpr double kNearShare = 0.1;

Standing standing(const exact::Truth& truth);

/// Whether they match each other within the sum of both bounds, on the cheap: what it says is so,
/// but it leaves to `judge` every case in which anything has to be decided.
bool plainly_agree(const exact::Truth& truth, const ColliderAnswer& subject,
                   const ColliderAnswer& oracle);

/// The full verdict.
Judgement judge(std::shared_ptr<const exact::Truth> truth, const ColliderAnswer& subject,
                const ColliderAnswer& oracle);
Judgement judge(const PairCase& pair, const ColliderAnswer& subject, const ColliderAnswer& oracle);

/// The full verdict on what these two answer now.
Judgement judge(const PairCase& pair, const Collider& subject, const Collider& oracle);

/// A verdict that no answer decided: crashed or timed_out.
Bucket bucket_of_lost(Verdict verdict, Fault fault);

}  // namespace manifuzz
