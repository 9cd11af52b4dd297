#include "hunting/rounds.hpp"

#include <algorithm>
#include <tuple>

#include <fmt/format.h>

namespace manifuzz {
namespace {

/// The order in which cases are given to the archive of the next round.
auto turn_of(CaseNumber number, const Rounds& rounds) {
  const std::uint64_t parts = rounds.rounds * rounds.shares;
  const std::uint64_t length = rounds.cases / parts;
  const std::uint64_t longer = rounds.cases % parts;
  const CaseNumber in_longer = longer * (length + 1);
  const std::uint64_t part =
      number < in_longer ? number / (length + 1) : longer + (number - in_longer) / length;
  const CaseNumber turn = number - begin_of_part(part, parts, rounds.cases);
  return std::tuple(part / rounds.shares, turn, part % rounds.shares);
}

}  // namespace

std::vector<ArchivedCase> kept_in(const Archive& archive, CaseNumber from) {
  std::vector<ArchivedCase> kept;
  for (const EntryId id : archive.all()) {
    const Archive::Entry& entry = archive[id];
    if (entry.number >= from) kept.push_back({entry.number, entry.observed, entry.pair});
  }
  std::ranges::sort(kept, {}, &ArchivedCase::number);
  return kept;
}

void add_to(Archive& archive, Elite& elite, const ArchivedCase& one, const Aim& aim) {
  const auto pair_of = [&] { return one.pair; };
  const Archive::Taken taken = archive.add(one.observed, aim.value(one.observed), pair_of);
  const auto entry = elite.add(one.observed, taken.entry, archive, pair_of);
  if (entry) archive[*entry].number = one.number;
}

void expect_cases_for_all(const Rounds& rounds) {
  if (rounds.shares <= rounds.cases / rounds.rounds) return;
  if (rounds.cases < rounds.rounds) {
    throw UserError(fmt::format("--rounds: {} are too many for {}; use at most {}", rounds.rounds,
                                counted(rounds.cases, "case"), rounds.cases));
  }
  throw UserError(
      fmt::format("--share: {} of {} are too many shares of {}; use at most {} in a round",
                  counted(rounds.rounds, "round"), rounds.shares, counted(rounds.cases, "case"),
                  rounds.cases / rounds.rounds));
}

void narrow_to(const Rounds& rounds, const RoundShare& share, Plan& plan) {
  const std::uint64_t parts = rounds.rounds * rounds.shares;
  const std::uint64_t part = share.round * rounds.shares + share.share;
  plan.first = begin_of_part(part, parts, rounds.cases);
  plan.cases = begin_of_part(part + 1, parts, rounds.cases) - plan.first;
}

std::vector<ArchivedCase> best_of(std::vector<ArchivedCase> cases, const Rounds& rounds,
                                  const std::optional<Measure>& measure) {
  const auto turn = [&](const ArchivedCase& one) { return turn_of(one.number, rounds); };
  std::ranges::sort(cases, {}, turn);
  Archive archive;
  const Aim aim = aim_at(measure);
  Elite elite(aim);
  for (const ArchivedCase& one : cases) add_to(archive, elite, one, aim);
  std::vector<ArchivedCase> kept = kept_in(archive, 0);
  std::ranges::sort(kept, {}, turn);
  return kept;
}

}  // namespace manifuzz
