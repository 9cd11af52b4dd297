#include "cli/merged_runs.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "campaign/budgets.hpp"
#include "cases/user_error.hpp"

namespace manifuzz {
namespace {

using Count = std::uint64_t;

/// Which cases a result counts.
std::vector<CasesRun> parts_of(const FuzzResult& run) {
  if (!run.parts.empty()) return run.parts;
  CasesRun part{run.seed, run.first, {}};
  for (const RegimeResult& regime : run.regimes) part.cases[regime.name] = regime.cases;
  return {part};
}

bool overlap(const CasesRun& part, const CasesRun& with) {
  if (part.seed != with.seed) return false;
  return std::ranges::any_of(part.cases, [&](const auto& regime) {
    const auto& [name, cases] = regime;
    const auto same = with.cases.find(name);
    if (same == with.cases.end()) return false;
    return part.first < with.first ? with.first - part.first < cases
                                   : part.first - with.first < same->second;
  });
}

bool have_same_terms(const FuzzResult& one, const FuzzResult& other) {
  return one.subject == other.subject && one.oracle == other.oracle &&
         one.versions == other.versions;
}

std::string terms_in_words(const FuzzResult& run) {
  std::vector<std::string> versions;
  for (const auto& [name, version] : run.versions) versions.push_back(name + ' ' + version);
  return fmt::format("{} against {} ({})", run.subject, run.oracle, fmt::join(versions, ", "));
}

/// The result whose terms most share; of equally many the one whose terms ran the most cases, then
/// the first.
const FuzzResult* most_usual(std::span<const Result> results) {
  const FuzzResult* usual = nullptr;
  std::pair<std::size_t, Count> most;
  for (const Result& candidate : results) {
    if (!candidate.fuzz) continue;
    std::pair<std::size_t, Count> weight;
    for (const Result& other : results) {
      if (!other.fuzz || !have_same_terms(*other.fuzz, *candidate.fuzz)) continue;
      ++weight.first;
      weight.second += other.fuzz->cases();
    }
    if (usual != nullptr && weight <= most) continue;
    usual = &*candidate.fuzz;
    most = weight;
  }
  return usual;
}

void expect_addable(const FuzzResult& sum, const FuzzResult& run) {
  if (!have_same_terms(sum, run)) {
    throw UserError(fmt::format("is of {}, the others are of {}; those are added up",
                                terms_in_words(run), terms_in_words(sum)));
  }
  for (const CasesRun& part : sum.parts) {
    for (const CasesRun& with : parts_of(run)) {
      if (!overlap(part, with)) continue;
      throw UserError(fmt::format("counts cases of seed {} from {} on, which are counted already",
                                  with.seed.value_or(0), with.first));
    }
  }
}

void keep_greater(ErrorShare& kept, const ErrorShare& other) {
  kept.depth = std::max(kept.depth, other.depth);
  kept.position = std::max(kept.position, other.position);
}

/// The row that has that name, appended where there is none.
template <class Row>
Row& row_of(std::vector<Row>& rows, std::string Row::*name, const std::string& wanted) {
  const auto known = std::ranges::find(rows, wanted, name);
  if (known != rows.end()) return *known;
  rows.emplace_back().*name = wanted;
  return rows.back();
}

void add_regimes(FuzzResult& sum, const FuzzResult& run) {
  for (const RegimeResult& other : run.regimes) {
    RegimeResult& regime = row_of(sum.regimes, &RegimeResult::name, other.name);
    regime.cases += other.cases;
    regime.touching += other.touching;
    regime.near += other.near;
    regime.unexplained += other.unexplained;
  }
}

void add_ledger(FuzzResult& sum, const FuzzResult& run) {
  for (const LedgerResult& other : run.ledger) {
    LedgerResult& entry = row_of(sum.ledger, &LedgerResult::id, other.id);
    entry.hits += other.hits;
    for (const auto& [regime, hits] : other.regimes) entry.regimes[regime] += hits;
  }
}

/// A case's place in the order of a campaign: its index, then its regime's turn.
auto place_of(const BucketResult& found, const FuzzResult& sum) {
  const auto turn = std::ranges::find(sum.regimes, found.regime, &RegimeResult::name);
  return std::pair(found.first_index, turn - sum.regimes.begin());
}

void add_buckets(FuzzResult& sum, const FuzzResult& run) {
  for (const BucketResult& other : run.buckets) {
    const auto kept = std::ranges::find(sum.buckets, other.bucket, &BucketResult::bucket);
    if (kept == sum.buckets.end()) {
      sum.buckets.push_back(other);
      continue;
    }
    kept->count += other.count;
    kept->magnitude = std::max(kept->magnitude, other.magnitude);
    kept->is_new = kept->is_new || other.is_new;
    const bool is_comparable = sum.seed && sum.seed == run.seed;
    if (!is_comparable || place_of(*kept, sum) <= place_of(other, sum)) continue;
    kept->first_index = other.first_index;
    kept->regime = other.regime;
    kept->command = other.command;
  }
}

/// Of the sums, since what fires too often in one run may be chance, and the other way round.
void find_over_budget(FuzzResult& sum) {
  for (LedgerResult& row : sum.ledger) {
    row.over_budget.clear();
    const auto entry = std::ranges::find(ledger(), row.id, &LedgerEntry::id);
    if (entry == ledger().end() || !sum.budgets_hold) continue;
    for (const auto& [regime, hits] : row.regimes) {
      const auto counted = std::ranges::find(sum.regimes, regime, &RegimeResult::name);
      const Count cases = counted == sum.regimes.end() ? 0 : counted->cases;
      if (is_over_budget(*entry, regime, hits, cases)) row.over_budget.push_back(regime);
    }
  }
}

std::size_t index_of_name(const BucketResult& found) {
  const auto bucket = find_bucket(found.bucket);
  return bucket ? index_of(*bucket) : kBucketCount;
}

/// The sum of no runs, with this one's terms.
FuzzResult nothing_of(const FuzzResult& run) {
  FuzzResult sum;
  sum.subject = run.subject;
  sum.oracle = run.oracle;
  sum.versions = run.versions;
  sum.budgets_hold = true;
  return sum;
}

void add_run(FuzzResult& sum, const FuzzResult& run) {
  expect_addable(sum, run);
  if (sum.parts.empty()) {
    sum.machine = run.machine;
    sum.compiler = run.compiler;
    sum.seed = run.seed;
    sum.first = run.first;
  }
  sum.seconds += run.seconds;
  sum.jobs = std::max(sum.jobs, run.jobs);
  for (std::size_t i = 0; i < sum.verdicts.size(); ++i) sum.verdicts[i] += run.verdicts[i];
  keep_greater(sum.of_subject, run.of_subject);
  keep_greater(sum.of_oracle, run.of_oracle);
  sum.interrupted = sum.interrupted || run.interrupted;
  sum.stopped_early = sum.stopped_early || run.stopped_early;
  sum.budgets_hold = sum.budgets_hold && run.budgets_hold;
  add_regimes(sum, run);
  add_ledger(sum, run);
  add_buckets(sum, run);
  for (const CasesRun& part : parts_of(run)) sum.parts.push_back(part);
  if (sum.seed != run.seed) sum.seed.reset();
  sum.first = std::min(sum.first, run.first);
}

}  // namespace

MergedRuns merged_runs(std::span<const Result> results) {
  MergedRuns merged;
  const FuzzResult* const usual = most_usual(results);
  if (usual != nullptr) merged.sum = nothing_of(*usual);
  for (const Result& result : results) {
    try {
      if (!result.fuzz) {
        throw UserError(fmt::format("is a result of {}; those of fuzz are added up", result.kind));
      }
      add_run(*merged.sum, *result.fuzz);
    } catch (const UserError& error) {
      merged.errors.push_back(fmt::format("{}: {}", result.path, error.what()));
    }
  }
  if (!merged.sum) return merged;
  find_over_budget(*merged.sum);
  std::ranges::stable_sort(merged.sum->buckets, {}, index_of_name);
  return merged;
}

}  // namespace manifuzz
