#pragma once

#include <span>
#include <string_view>

#include "judging/admissible.hpp"

namespace manifuzz {

/// What an entry of the ledger may look at: the oracle's wrong answer, and what would be right.
struct Deviation {
  const Admissible& right;
  const Manifold<double>& got;
  Kind kind = Kind::none;  ///< of the mismatch
};

/// How often an entry may fire, at most, in a regime with its own radii.
struct Budget {
  std::string_view regime;
  double per_million = 0;
};

/// A known deviation of an oracle: named, cited, and alive as long as its witness still shows it.
struct LedgerEntry {
  std::string_view id;
  std::string_view collider;          ///< whose deviation it is
  std::string_view description;       ///< one line for `list ledger`
  std::string_view source;            ///< file and function, or issue, where it comes from
  std::string_view witness;           ///< path in the corpus of a case that shows it
  std::span<const Budget> budgets{};  ///< of the regimes in which it fires
  bool (*explains)(const Deviation& deviation);
};

/// Every known deviation. An entry is added here, with its witness, and nowhere else.
std::span<const LedgerEntry> ledger();

inline constexpr std::size_t kLedgerMax = 16;

/// The entry's place in the ledger.
std::size_t index_of(const LedgerEntry& entry);

/// The entry's budget in a regime, in hits a million cases: 0 where it names none.
double budget_per_million(const LedgerEntry& entry, std::string_view regime);

/// The first entry that explains what this collider did, or nullptr.
const LedgerEntry* find_explanation(std::string_view collider, const Deviation& deviation);

}  // namespace manifuzz
