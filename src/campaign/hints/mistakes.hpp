#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string_view>

#include "collider/collider.hpp"
#include "exact/truth.hpp"

namespace manifuzz {

/// A case, and what a collider answered to it.
struct AskedCase {
  const exact::Truth& truth;
  const Declaration& declaration;
  const Answer& answer;

  const PairCase& pair() const { return truth.pair(); }
};

/// The answer as it would be without a mistake, and what it is then to be judged by.
struct Undone {
  Declaration declaration;
  Answer answer;
  std::optional<PairCase> pair{};  ///< in place of the case
  /// A share of the size: what is right but for so much is taken for right, where the case as the
  /// collider saw it is not known to the last digit.
  double within = 0;
};

/// A known mistake of those who write an adapter.
struct Mistake {
  std::string_view name;
  std::string_view condition;  ///< behind "right if": what undoes it
  std::string_view advice;     ///< what is wrong, and what to do
  /// None where the case does not show it.
  std::optional<Undone> (*undo)(const AskedCase& asked);
  /// It only widens bounds, and so excuses what is off by little for any other reason: it is to
  /// explain wrong answers of all kinds together.
  bool is_allowance = false;
};

/// The simplest first. One of a name may stand there several times, for each way of making it.
std::span<const Mistake> mistakes();

}  // namespace manifuzz
