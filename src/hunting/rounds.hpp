#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "campaign/plan.hpp"
#include "hunting/elite.hpp"

namespace manifuzz {

/// A case of an archive, and what became of it.
struct ArchivedCase {
  CaseNumber number = 0;   ///< of all cases of the hunt
  Observation observed{};  ///< of a well-posed case
  PairCase pair{};

  friend bool operator==(const ArchivedCase&, const ArchivedCase&) = default;
};

/// The archive's cases from that number on, in the order of their numbers.
std::vector<ArchivedCase> kept_in(const Archive& archive, CaseNumber from);
/// Takes one in that was archived before.
void add_to(Archive& archive, Elite& elite, const ArchivedCase& one, const Aim& aim);

/// A hunt that is dealt to machines: in each of its rounds each share breeds by itself, from the
/// archives of all shares of the round before. Cases are numbered through rounds, in them through
/// shares.
struct Rounds {
  std::uint64_t cases = 1;  ///< of all rounds and shares
  std::uint64_t rounds = 1;
  std::uint64_t shares = 1;  ///< of each round
};

/// One share of one round.
struct RoundShare {
  std::uint64_t round = 0;
  std::uint64_t share = 0;
};

/// Throws UserError where a share would have no case.
void expect_cases_for_all(const Rounds& rounds);
/// Leaves the plan the cases of that share.
void narrow_to(const Rounds& rounds, const RoundShare& share, Plan& plan);

/// The cases that an archive keeps if it is given all of these: by round, within a round by their
/// turn in their share, then by share, so that no share's cases come after all others. Of equally
/// great cases the first is kept, so the best of some and all others is the best of all.
std::vector<ArchivedCase> best_of(std::vector<ArchivedCase> cases, const Rounds& rounds,
                                  const std::optional<Measure>& measure);

}  // namespace manifuzz
