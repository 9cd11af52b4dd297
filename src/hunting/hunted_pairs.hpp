#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "hunting/elite.hpp"
#include "hunting/observed_pairs.hpp"
#include "hunting/rounds.hpp"

namespace manifuzz {

/// The cases of a generation, at most, founders apart.
inline constexpr CaseNumber kLongestGeneration = 8192;

/// The one regime of a plan whose cases a hunt breeds.
inline constexpr Regime kHunted{kRegimeOfHunts, "cases that a hunt bred of others", nullptr};

/// What a hunt begins with, and what it keeps.
struct Breed {
  std::vector<const Regime*> regimes;       ///< that cases are drawn from
  std::vector<PairCase> founders;           ///< cases to begin with, besides drawn ones
  Aim aim;                                  ///< what is kept of them
  OnJudged on_judged{};                     ///< besides what is learnt here
  std::span<const ArchivedCase> earlier{};  ///< of the rounds before, in order
  std::string again{};  ///< options that run a case again; empty: those that end with it
};

/// The cases of a hunt, generation by generation. Each generation is bred from the archive as it
/// stood when it began, each of its cases by the seed and its number alone, counted from the plan's
/// first: so any number of jobs finds the same.
class HuntedPairs : public ObservedPairs {
 public:
  HuntedPairs(Breed breed, const Plan& plan);

  std::string options_again(const Plan& plan, CaseNumber number) const override;
  bool has_budgets() const override { return false; }
  PairCase pair(const Plan& plan, CaseNumber number) const override;

  /// The cases that come next, at most so many: a generation.
  SharedQueue::Block begin_generation(CaseNumber most);
  /// Takes what became of it into the archive. `tally` is of all generations, this one included:
  /// cases that it tells of can be had from now on.
  void end_generation(const Tally& tally);

  std::size_t generations() const { return generations_; }
  /// What the archive holds of these cases, without earlier ones.
  std::vector<ArchivedCase> archived() const { return kept_in(archive(), first_); }

 private:
  /// Where a case comes from.
  enum class Source { founded, drawn, pair_cell, label_cell, kind_cell, count_cell, newest, worst };
  static constexpr std::size_t kSources = 8;
  struct Birth {
    Source source = Source::drawn;
    EntryId parent = 0;
    EntryId mate = 0;
  };
  /// How a source has done: new cells, and cases, the later ones weighing more.
  struct Yield {
    double cells = 0;
    double cases = 0;
  };

  /// What parents are chosen from besides cells: as they are when a generation begins.
  struct Eligible {
    std::vector<EntryId> newest;
    std::vector<std::vector<EntryId>> greatest;  ///< of each gauge that has any
  };

  Birth birth_of(CaseNumber number, const std::array<double, kSources>& shares,
                 const Eligible& eligible);
  /// The case of the least visited of 16 cells that chance takes.
  EntryId in_rare_cell(Archive::Set set, Random& random) const;
  /// The less used of two.
  EntryId less_used(std::span<const EntryId> entries, Random& random) const;
  EntryId parent_from(Source source, Random& random, const Eligible& eligible) const;
  std::array<double, kSources> shares_of_sources() const;
  PairCase born(CaseNumber number) const;
  PairCase drawn(CaseNumber number) const;
  void keep_cases_of(const Tally& tally);
  PairCase kept_or_born(CaseNumber number) const;
  PairCase to_keep(CaseNumber number) const override { return kept_or_born(number); }
  void take_in(CaseNumber number, const Observation& observed,
               const std::optional<Archive::Taken>& taken) override;

  Breed breed_;
  std::uint64_t seed_;
  CaseNumber first_;  ///< chance goes by a case's number from there on
  GenerationContext context_;
  std::array<Yield, kSources> yields_{};
  Elite elite_;
  std::map<CaseNumber, PairCase> kept_;
  std::size_t generations_ = 0;
  std::vector<Birth> births_;  ///< of the generation at work
};

}  // namespace manifuzz
