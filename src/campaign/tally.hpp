#pragma once

#include <array>
#include <cstdint>

#include "judging/judge.hpp"

namespace manifuzz {

inline constexpr std::size_t kRegimesMax = 64;

/// A position in the campaign's order of cases: case k is regime k % R at index first + k / R.
using CaseNumber = std::uint64_t;

/// What was seen of one bucket.
struct BucketTally {
  std::uint64_t count = 0;
  CaseNumber first = 0;  ///< the least case number
  CaseNumber worst = 0;  ///< of the greatest magnitude, the least of equals
  double magnitude = 0;

  void add(CaseNumber number, double finding_magnitude);
  void add(const BucketTally& tally);
};

struct RegimeTally {
  std::uint64_t cases = 0;
  std::uint64_t touching = 0;  ///< by the truth
  std::uint64_t near = 0;      ///< not touching, but near
  std::uint64_t unexplained = 0;
  std::uint64_t failures = 0;  ///< against the subject
};

/// Counts of a run, or of one job of it: plain data that lies in shared memory and that no order of
/// adding changes.
struct Tally {
  std::array<std::uint64_t, kVerdictNames.size()> verdicts{};
  std::array<RegimeTally, kRegimesMax> regimes{};
  std::array<BucketTally, kBucketCount> buckets{};
  /// The worst errors of wrong answers.
  ManifoldError of_subject;
  ManifoldError of_oracle;
  /// How often each entry of the ledger fired in each regime.
  std::array<std::array<std::uint64_t, kRegimesMax>, kLedgerMax> explained{};

  void add(std::size_t regime, CaseNumber number, const Standing& standing,
           const Judgement& judgement);
  void add(const Tally& tally);

  std::uint64_t cases() const;
  std::uint64_t touching() const;
  std::uint64_t near() const;
  std::uint64_t unexplained() const;
  std::uint64_t count(Verdict verdict) const { return verdicts[static_cast<std::size_t>(verdict)]; }
};

}  // namespace manifuzz
