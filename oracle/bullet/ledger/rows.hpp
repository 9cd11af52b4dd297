#pragma once

#include <span>
#include <vector>

#include "sequence/sequence_ledger.hpp"

namespace manifuzz {

inline constexpr std::size_t kBulletEpaRows = 17;

/// The rows of bullet-epa, which bullet-perturbed has of its first query.
std::span<const LedgerRow, kBulletEpaRows> bullet_epa_rows();

/// The rows that bullet-convex2d alone has.
LedgerRows bullet_flat_ledger();
/// The rows of the colliders that ask one query: bullet-epa, bullet-minkowski, bullet-convex2d.
std::vector<LedgerRows> bullet_query_ledger();
/// The rows of bullet-perturbed.
LedgerRows bullet_perturbed_ledger();
/// The rows of bullet-cached.
SequenceRows bullet_sequence_ledger();

}  // namespace manifuzz
