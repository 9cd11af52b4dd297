#pragma once

#include "judging/compare.hpp"
#include "judging/ledger.hpp"
#include "judging/manifold_error.hpp"

namespace manifuzz {

/// The verdict on a subject's and an oracle's answer to one case.
struct Judgement {
  Bucket bucket{};
  double magnitude = 0;                      ///< the finding's worst error as a share of the size
  const LedgerEntry* explanation = nullptr;  ///< set where the verdict is known
  ManifoldError of_subject{};  ///< of a wrong manifold, as shares of the size; 0 of a right one
  ManifoldError of_oracle{};
};

/// Where a case stands by the truth alone.
struct Standing {
  bool touching = false;  ///< S <= total radius, exactly
  bool near = false;      ///< S within 10% of the size from the total radius
};

inline constexpr double kNearShare = 0.1;

Standing standing(const exact::Truth& truth);

/// The full verdict.
Judgement judge(std::shared_ptr<const exact::Truth> truth, const ColliderAnswer& subject,
                const ColliderAnswer& oracle);
Judgement judge(const PairCase& pair, const ColliderAnswer& subject, const ColliderAnswer& oracle);

/// The full verdict on what these two answer now.
Judgement judge(const PairCase& pair, const Collider& subject, const Collider& oracle);

}  // namespace manifuzz
