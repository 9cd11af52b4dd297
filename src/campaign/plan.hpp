#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "base/text.hpp"
#include "campaign/least_cases.hpp"
#include "campaign/work.hpp"
#include "collider/collider.hpp"
#include "corpus/corpus.hpp"
#include "generating/regime.hpp"
#include "judging/judge.hpp"
#include "process/interruption.hpp"

namespace manifuzz {

/// A collider's answer, completed, with its declaration.
struct DeclaredAnswer {
  Declaration declaration;
  Answer answer;

  /// Its manifold, or nullptr where it gave none. It may be malformed.
  const Manifold<double>* manifold() const { return manifold_in(answer); }
  /// The number of its points, 0 to 2 whatever a malformed manifold says.
  int count() const { return manifold() ? std::clamp(manifold()->count, 0, 2) : 0; }
};

/// A case, what two colliders answer, and the verdict: what `show` shows.
struct JudgedCase {
  CorpusCase given;
  DeclaredAnswer subject;
  DeclaredAnswer oracle;
  Judgement judgement;
};

/// The collider is asked in a child process, where it could take this one along. Throws
/// Interrupted.
DeclaredAnswer declared_answer(const Collider& collider, const PairCase& pair,
                               Interruption& interruption);

/// Both are asked so. Throws Interrupted.
JudgedCase judged_case(const CorpusCase& given, const Collider& subject, const Collider& oracle,
                       Interruption& interruption);

inline constexpr std::size_t kRegimesMax = 64;

/// What was seen of one bucket.
struct BucketTally {
  std::uint64_t count = 0;
  CaseNumber first = 0;  ///< the least case number
  CaseNumber worst = 0;  ///< of the greatest magnitude, the least of equals
  WorstError error{};
  std::array<CaseNumber, kComponentNames.size()>
      worst_of{};                                    ///< of each component's greatest error
  std::array<std::uint64_t, kRegimesMax> regimes{};  ///< the count in each
  std::array<std::uint64_t, kRegimesMax> agreed{};   ///< of these, agreed contacts

  /// Counts a case that shows it.
  void meet(std::size_t regime, CaseNumber number, const Judgement& judgement);
  void add(const BucketTally& tally);
};

/// The tallies of those buckets that were met: plain data, with room for more than there can be.
class BucketTallies {
 public:
  /// The bucket's, which begins at none.
  BucketTally& of(const Bucket& bucket);
  /// None where it was not met.
  const BucketTally* find(const Bucket& bucket) const;
  void add(const BucketTallies& tallies);

  struct Met {
    Bucket bucket;
    const BucketTally* tally = nullptr;
  };
  /// All buckets that were met, in the order of their indices.
  std::vector<Met> all() const;

 private:
  static constexpr std::size_t kRoom = 2048;  // there are some 900 that a run may meet

  std::size_t slot_of(std::size_t bucket) const;

  std::array<std::size_t, kRoom> places_{};  ///< the bucket's index and 1; 0: the slot is free
  std::array<BucketTally, kRoom> tallies_{};
};

/// Counts of a regime's cases.
struct RegimeTally {
  std::uint64_t cases = 0;
  std::uint64_t touching = 0;  ///< by the truth
  std::uint64_t near = 0;      ///< not touching, but near
  std::uint64_t unexplained = 0;
  std::uint64_t frames = 0;         ///< of sequences; pair cases have none
  std::uint64_t agreed = 0;         ///< agreed contacts, of which a sample is judged
  std::uint64_t agreed_judged = 0;  ///< the sample

  void add(const RegimeTally& tally);
};

/// One of these counts, over several regimes.
std::uint64_t sum_of(const auto& regimes, std::uint64_t RegimeTally::*count) {
  std::uint64_t sum = 0;
  for (const RegimeTally& regime : regimes) sum += regime.*count;
  return sum;
}

/// Counts of a run, or of one job of it: plain data that lies in shared memory and that no order of
/// adding changes.
struct Tally {
  std::array<std::uint64_t, kVerdictNames.size()> verdicts{};
  std::array<RegimeTally, kRegimesMax> regimes{};
  BucketTallies buckets;
  /// The first cases of the subject's wrong answers of each kind; malformed ones have kind none.
  std::array<LeastCases, kKindNames.size()> first_wrong{};
  std::uint64_t by_tolerance = 0;     ///< right, but only by the tolerance that a collider declares
  std::uint64_t agreeing_judged = 0;  ///< of those that agree, what was judged too
  /// The worst errors of wrong answers.
  Errors of_subject;
  Errors of_oracle;
  /// How often each entry of the ledger fired in each regime.
  std::array<std::array<std::uint64_t, kRegimesMax>, kLedgerMax> explained{};

  /// `frames`: of a sequence.
  void add(std::size_t regime, CaseNumber number, const Standing& standing,
           const Judgement& judgement, std::size_t frames = 0);
  void add(const Tally& tally);

  std::uint64_t cases() const { return sum_of(regimes, &RegimeTally::cases); }
  std::uint64_t touching() const { return sum_of(regimes, &RegimeTally::touching); }
  std::uint64_t unexplained() const { return sum_of(regimes, &RegimeTally::unexplained); }
  std::uint64_t count(Verdict verdict) const { return verdicts[static_cast<std::size_t>(verdict)]; }
};

inline constexpr std::uint64_t kJudgeEvery = 256;

/// One agreeing case in how many is judged by default: all are where a collider is asked in a
/// process of its own, since judging takes less than asking there.
inline std::uint64_t usual_judge_every(const Collider& subject, const Collider& oracle) {
  return subject.is_isolated() || oracle.is_isolated() ? 1 : kJudgeEvery;
}

/// What a campaign runs: which cases, through which two colliders.
struct Plan {
  Collider subject;
  Collider oracle;
  std::vector<const Regime*> regimes;  ///< not empty, at most kRegimesMax
  std::shared_ptr<const KindOfWork> work = work_on_pairs();
  GenerationContext context;
  std::uint64_t seed = 0;
  std::uint64_t first = 0;             ///< index in each regime of its first case
  std::optional<std::uint64_t> cases;  ///< of all regimes together; none: until time is up
  std::optional<double> seconds;       ///< from the first answer on: a program's start is extra
  Deadline latest{};                   ///< when it ends at the latest, whatever was answered
  bool until_new = false;              ///< it ends with the first case of something new and wrong
  /// It ends once the chance that the next case shows a bucket not yet seen is at most this.
  std::optional<double> until_risk{};
  /// The run ends with the first such case; those behind it are counted in part.
  std::function<bool(const Judgement&)> ends_with{};
  bool has_ties = false;  ///< new ties are findings to save, too
  int jobs = 1;
  /// Two colliders can be wrong alike: of the cases on which they plainly agree, one in so many is
  /// judged all the same.
  std::uint64_t judge_every = kJudgeEvery;

  /// How many cases there are to run, up to the last index where time alone ends the campaign.
  CaseNumber cases_max() const {
    constexpr CaseNumber most = std::numeric_limits<CaseNumber>::max();
    const CaseNumber indices = most - first;
    return cases.value_or(indices < most / regimes.size() ? indices * regimes.size() : most);
  }
  std::size_t regime_of(CaseNumber number) const { return number % regimes.size(); }
  std::uint64_t index_of(CaseNumber number) const { return first + number / regimes.size(); }
  PairCase pair(CaseNumber number) const {
    return generate(seed, *regimes[regime_of(number)], index_of(number), context);
  }
};

/// The part of a plan's cases that one of several machines runs.
struct Share {
  std::uint64_t number = 0;  ///< from 0 to of - 1
  std::uint64_t of = 1;
};

/// Where a part begins of so many things that are dealt to parts: each has as many as another, or
/// one more, and those that have more come first.
inline std::uint64_t begin_of_part(std::uint64_t part, std::uint64_t parts, std::uint64_t things) {
  return part * (things / parts) + std::min(part, things % parts);
}

/// What "3/40" says. Throws UserError that names --share.
Share share_of(const std::string& text);

/// Leaves the plan that share of its cases: whole turns of its regimes, one behind the other, which
/// together are all of them, each once; what each case is, and whether it is judged, stays. The
/// plan has a number of cases. Throws UserError where there are fewer turns than shares.
void narrow_to_share(const Share& share, Plan& plan);

/// The colliders that the plan asks: without an oracle that only stands for the judge.
std::vector<Declaration> asked_by(const Plan& plan);

/// Where a case stands by the truth alone.
Standing standing(const AnyCase& any);

/// The regimes of these names; without names all that have cases which the colliders take.
std::vector<const Regime*> regimes_for(const std::vector<Collider>& colliders,
                                       std::span<const std::string> names);

/// Only pairs are drawn that all of these take; the radii of sharp polygons, unless they are given,
/// are none where a collider takes none.
void narrow_to(const std::vector<Collider>& colliders, GenerationContext& context);

inline void narrow_to_colliders(Plan& plan) {
  narrow_to({plan.subject, plan.oracle}, plan.context);
}

}  // namespace manifuzz
