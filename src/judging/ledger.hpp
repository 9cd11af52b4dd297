#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "judging/admissible.hpp"

namespace manifuzz {

/// What an entry of the ledger may look at: the oracle's wrong answer, and what would be right.
struct Deviation {
  const Admissible& right;
  const Manifold<double>& got;
  Kind kind = Kind::none;  ///< the first condition of a right answer that it does not meet
  /// The case, which is not `right`'s where the oracle used other shapes; nullptr where unknown.
  const PairCase* asked = nullptr;
};

/// An oracle's answer that is nonsense, or that never came.
struct LostAnswer {
  const PairCase& pair;
  const Answer& answer;
  Lost::How how = Lost::How::malformed;
};

/// How often an entry may fire, at most, in a regime with its own radii.
struct Budget {
  std::string regime;
  double per_million = 0;
};

/// A known deviation of an oracle: named, cited, and alive as long as its witness still shows it.
struct LedgerEntry {
  std::string id;
  std::string collider;       ///< whose deviation it is
  std::string description{};  ///< one line for `list ledger`
  std::string source{};       ///< file and function, or issue, where it comes from
  /// Unset where it explains only what is lost.
  bool (*explains)(const Deviation& deviation) = nullptr;
  /// Unset where it explains nothing that is lost.
  bool (*explains_lost)(const LostAnswer& lost) = nullptr;
  /// Its source or its documentation says that it is meant.
  bool is_no_bug = false;
  std::vector<Budget> budgets{};  ///< in the regimes in which it fires
};

/// What an engine's sources say of an entry: what looks for it. All else is in the texts of its
/// folder.
struct LedgerRow {
  std::string_view cause;  ///< the entry's id, without the collider's name before it
  bool (*explains)(const Deviation& deviation) = nullptr;
  bool (*explains_lost)(const LostAnswer& lost) = nullptr;
};

/// Rows of a collider, the first that explains before others.
struct LedgerRows {
  std::string_view collider;
  std::span<const LedgerRow> rows;
};

/// The entries of each engine that a program is built with, in the order of the engines. Whatever
/// is linked with the judge defines it: a program by the list of its engines,
/// src/engines/engine.hpp.
std::vector<LedgerEntry> built_ledger();

/// Every known deviation, engine by engine.
std::span<const LedgerEntry> ledger();

inline constexpr std::size_t kLedgerMax = 384;

/// The entry's place in the ledger.
std::size_t index_of(const LedgerEntry& entry);

/// The path in the corpus of a case that shows it.
std::string witness_of(const LedgerEntry& entry);

/// The entry's budget in a regime, in hits a million cases: 0 where it names none.
double budget_per_million(const LedgerEntry& entry, std::string_view regime);

/// The first entry that explains what this collider did, or nullptr.
const LedgerEntry* find_explanation(std::string_view collider, const Deviation& deviation);
/// The first entry that explains an answer that is nonsense, or that never came.
const LedgerEntry* find_explanation(std::string_view collider, const LostAnswer& lost);

}  // namespace manifuzz
