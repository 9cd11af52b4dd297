#pragma once

#include <optional>
#include <vector>

#include "judging/admissible.hpp"
#include "judging/completed.hpp"
#include "judging/manifold_error.hpp"
#include "judging/properties.hpp"

// What properties are written with: asking a collider, outcomes, and holding two manifolds against
// each other.

namespace manifuzz {

/// What a property asks of a collider, remembered so that the ledger can be asked in turn.
class AskedCollider {
 public:
  explicit AskedCollider(const Collider& collider) : collider_(collider) {}

  const Collider& collider() const { return collider_; }
  const Declaration& declaration() const { return collider_.declaration; }
  const std::vector<PairCase>& asked() const { return asked_; }

  /// Its manifold, or none where it does not take the case.
  std::optional<Manifold<double>> manifold(const PairCase& pair) {
    asked_.push_back(pair);
    const Answer answer = ask(collider_, pair);
    const auto* const found = std::get_if<Manifold<double>>(&answer);
    const auto* const lost = std::get_if<Lost>(&answer);
    if (lost && !lost_) lost_ = *lost;
    return found ? std::optional(*found) : std::nullopt;
  }

  /// The first time that it died, hung, or answered nonsense.
  const std::optional<Lost>& lost() const { return lost_; }

 private:
  const Collider& collider_;
  std::optional<Lost> lost_;
  std::vector<PairCase> asked_;
};

inline Outcome holds() {
  return {};
}
inline Outcome not_applicable() {
  return {.kind = Outcome::Kind::not_applicable, .why = {}};
}
inline Outcome fails(std::string why, double magnitude) {
  return {.kind = Outcome::Kind::fails, .why = std::move(why), .magnitude = magnitude};
}

/// What is right for this collider, if nothing that decides it is within bound: one reference face
/// by a clear lead, one incident edge, both ends clearly kept, clipped or dropped.
std::optional<Admissible> decided(const PairCase& pair, const Declaration& declaration);

/// By how much two right manifolds of one case may differ: the sum of both bounds.
ManifoldError tolerance(const Admissible& right);

enum class Features { compared, ignored };

/// Holds where both manifolds, given in one frame, are the same within the tolerance.
Outcome same_manifold(const PairCase& pair, const Manifold<double>& expected,
                      const Manifold<double>& got, const ManifoldError& within, Features features);

}  // namespace manifuzz
