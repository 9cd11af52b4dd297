#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <span>
#include <tuple>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/file.hpp"
#include "base/text.hpp"
#include "campaign/result.hpp"
#include "campaign/save.hpp"
#include "corpus/preference.hpp"
#include "generating/regime.hpp"

namespace manifuzz {
namespace {

namespace fs = std::filesystem;
using Count = std::uint64_t;

std::string key_of(const CorpusCase& known) {
  if (known.expect && !known.expect->bucket.empty()) return finding_key(*known.expect);
  std::string line;
  append_case_line(line, known.any);
  return known.property + '|' + line;
}

/// The order in which witnesses are preferred, the first the best.
auto badness(const CorpusCase* witness) {
  const double magnitude = witness->expect ? witness->expect->magnitude.value_or(-1) : -1;
  const Found found = witness->found.value_or(Found{});
  const auto place = std::ranges::find(regimes(), found.regime, &Regime::name);
  return std::tuple(-magnitude, found.index, place - regimes().begin(), found.seed, witness->path);
}

auto size_of(const CorpusCase* known) {
  return std::tuple(preference(*known), badness(known));
}

using Members = std::vector<const CorpusCase*>;

MergedFinding merged_finding(const Members& members) {
  std::set<std::string> shrunk;  // files beside which lies what they were shrunk from
  for (const CorpusCase* known : members) {
    if (is_worst(known->path)) shrunk.insert(shrunk_beside(known->path));
  }
  Members as_seen;
  for (const CorpusCase* known : members) {
    if (!shrunk.contains(known->path)) as_seen.push_back(known);
  }
  MergedFinding kept{*std::ranges::min(members, {}, size_of), {}};
  const CorpusCase& worst = *std::ranges::min(as_seen, {}, badness);
  if (worst.any != kept.smallest.any) kept.worst = worst;
  const auto accepted = std::ranges::find_if(
      members, [](const CorpusCase* known) { return known->accepted.has_value(); });
  if (accepted != members.end()) kept.smallest.accepted = (*accepted)->accepted;
  return kept;
}

/// The case as its file has it, every byte: answers read and written again may differ by a
/// rounding.
std::string text_of(const CorpusCase& known) {
  return known.path.ends_with(".json") ? InputFile(known.path).read_all() : format_case(known);
}

/// A bucket's file is the merged one.
void name_files(CampaignResult& run, const std::map<std::string, std::string>& files) {
  Expectation expect{run.settings.subject, run.settings.oracle, {}, {}, {}};
  for (BucketResult& found : run.buckets) {
    expect.bucket = found.bucket;
    const auto file = files.find(finding_key(expect));
    if (file != files.end()) found.file = file->second;
  }
}

std::string in_words(const Settings& settings) {
  std::vector<std::string> versions;
  for (const auto& [name, version] : settings.versions)
    versions.push_back(fmt::format("{} {}", name, version));
  std::string text = fmt::format("{} against {} ({}), tie bias {}, judging 1 in {}",
                                 settings.subject, settings.oracle, fmt::join(versions, ", "),
                                 in_words(settings.tie_bias), settings.judge_every);
  if (settings.radius) text += fmt::format(", radius {}", *settings.radius);
  if (!settings.hunt.empty()) text += fmt::format(", {}", settings.hunt);
  return printable(text, 300);
}

/// The settings that most results share; of equally many those of the most cases, then the first.
const Settings* usual_settings(std::span<const ResultFile> results) {
  const auto weight = [results](const ResultFile& candidate) {
    std::pair<std::size_t, Count> sum;
    for (const ResultFile& other : results) {
      if (!candidate.campaign || !other.campaign) continue;
      if (other.campaign->settings != candidate.campaign->settings) continue;
      ++sum.first;
      sum.second += other.campaign->cases();
    }
    return sum;
  };
  const auto usual = std::ranges::max_element(results, {}, weight);
  return usual == results.end() || !usual->campaign ? nullptr : &usual->campaign->settings;
}

void expect_addable(const CampaignResult& sum, const CampaignResult& run) {
  if (sum.settings != run.settings) {
    throw UserError(fmt::format("is of {}; the others, which are added up, are of {}",
                                in_words(run.settings), in_words(sum.settings)));
  }
  if (run.cases() > kCountMax - sum.cases()) throw UserError("has more cases than can be counted");
  for (const CasesRun& part : sum.parts) {
    for (const CasesRun& with : run.parts) {
      if (!overlap(part, with)) continue;
      throw UserError(fmt::format("counts cases of seed {} from {} on, which are counted already",
                                  with.seed, with.first));
    }
  }
}

/// The row that has that name, appended where there is none.
template <class Row>
Row& row_of(std::vector<Row>& rows, std::string Row::*name, const std::string& wanted) {
  const auto known = std::ranges::find(rows, wanted, name);
  if (known != rows.end()) return *known;
  rows.emplace_back().*name = wanted;
  return rows.back();
}

/// Regimes stand as the runs have them, where all have the same; else in the order of the list.
void add_regimes(CampaignResult& sum, const CampaignResult& run) {
  const bool is_alike =
      std::ranges::equal(sum.regimes, run.regimes, {}, &RegimeResult::name, &RegimeResult::name);
  const bool is_ordered = sum.regimes.empty() || is_alike;
  for (const RegimeResult& other : run.regimes) {
    row_of(sum.regimes, &RegimeResult::name, other.name).add(other);
  }
  if (is_ordered) return;
  std::ranges::stable_sort(sum.regimes, {}, [](const RegimeResult& regime) {
    return std::ranges::find(regimes(), regime.name, &Regime::name) - regimes().begin();
  });
}

void add_ledger(CampaignResult& sum, const CampaignResult& run) {
  for (const LedgerResult& other : run.ledger) {
    LedgerResult& entry = row_of(sum.ledger, &LedgerResult::id, other.id);
    entry.hits += other.hits;
    for (const auto& [regime, hits] : other.regimes) entry.regimes[regime] += hits;
  }
}

/// A case's place in the order of a campaign: its index, then its regime's turn; then its seed.
auto place_of(const BucketResult& found, const CampaignResult& sum) {
  const auto turn = std::ranges::find(sum.regimes, found.regime, &RegimeResult::name);
  return std::tuple(found.first_index, turn - sum.regimes.begin(), found.seed);
}

void add_buckets(CampaignResult& sum, const CampaignResult& run) {
  for (const BucketResult& other : run.buckets) {
    const auto kept = std::ranges::find(sum.buckets, other.bucket, &BucketResult::bucket);
    if (kept == sum.buckets.end()) {
      sum.buckets.push_back(other);
      continue;
    }
    BucketResult added = place_of(other, sum) < place_of(*kept, sum) ? other : *kept;
    added.count = kept->count + other.count;
    added.error = kept->error;
    widen(added.error, other.error);
    added.regimes = kept->regimes;
    added.agreed = kept->agreed;
    for (const auto& [regime, count] : other.regimes) added.regimes[regime] += count;
    for (const auto& [regime, count] : other.agreed) added.agreed[regime] += count;
    added.is_new = kept->is_new || other.is_new;
    added.is_accepted = kept->is_accepted && other.is_accepted;
    added.is_in_baseline = kept->is_in_baseline && other.is_in_baseline;
    if (added.objection.empty()) added.objection = kept->objection + other.objection;
    *kept = added;
  }
}

/// Judges the sums, since what fires too often in one run may be chance, and the other way round.
void find_over_budget(CampaignResult& sum) {
  for (LedgerResult& row : sum.ledger) {
    row.over_budget.clear();
    const auto entry = std::ranges::find(ledger(), row.id, &LedgerEntry::id);
    if (entry == ledger().end() || !sum.budgets_hold) continue;
    for (const auto& [regime, hits] : row.regimes) {
      const auto counted = std::ranges::find(sum.regimes, regime, &RegimeResult::name);
      const Count cases = counted == sum.regimes.end() ? 0 : counted->cases;
      const double budget = budget_per_million(*entry, regime);
      if (is_over_budget(budget, regime, hits, cases)) row.over_budget.push_back(regime);
    }
  }
}

auto place_in_order(const BucketResult& found) {
  const auto bucket = find_bucket(found.bucket);
  using Place = decltype(place_of(*bucket, found.count));
  return bucket ? place_of(*bucket, found.count) : Place{std::numeric_limits<Count>::max()};
}

/// Runs that the risk was to end may each have ended at any look: all that may come together miss
/// as often as their shares of the error, multiplied, say.
void add_risk_error(CampaignResult& sum, const CampaignResult& run) {
  if (!run.risk_error || !sum.risk_error) {
    sum.risk_error.reset();
  } else {
    *sum.risk_error *= *run.risk_error / kRiskError;
  }
}

void add_run(CampaignResult& sum, const CampaignResult& run) {
  expect_addable(sum, run);
  if (sum.parts.empty()) {
    sum.machine = run.machine;
    sum.compiler = run.compiler;
  }
  sum.jobs = std::max(sum.jobs, run.jobs);
  for (std::size_t i = 0; i < sum.verdicts.size(); ++i) sum.verdicts[i] += run.verdicts[i];
  sum.by_tolerance += run.by_tolerance;
  sum.agreeing_judged += run.agreeing_judged;
  widen(sum.of_subject, run.of_subject);
  widen(sum.of_oracle, run.of_oracle);
  sum.unshrunk += run.unshrunk;
  for (const std::string& file : run.stale) {
    if (std::ranges::count(sum.stale, file) == 0) sum.stale.push_back(file);
  }
  sum.interrupted = sum.interrupted || run.interrupted;
  sum.stopped_early = sum.stopped_early || run.stopped_early;
  sum.budgets_hold = sum.budgets_hold && run.budgets_hold;
  add_risk_error(sum, run);
  add_regimes(sum, run);
  add_ledger(sum, run);
  add_buckets(sum, run);
  add_hunt(sum, run);
  sum.parts.insert(sum.parts.end(), run.parts.begin(), run.parts.end());
  join(sum.parts);
}

}  // namespace

std::vector<MergedFinding> merged_findings(const std::vector<CorpusCase>& cases) {
  std::map<std::string, Members> groups;
  for (const CorpusCase& known : cases) groups[key_of(known)].push_back(&known);
  std::vector<MergedFinding> all;
  all.reserve(groups.size());
  for (const auto& [key, members] : groups) all.push_back(merged_finding(members));
  return all;
}

MergedRuns merged_runs(const RunFiles& files) {
  const bool has_hunts = std::ranges::any_of(files.results, [](const ResultFile& result) {
    return result.campaign && result.campaign->hunt;
  });
  std::vector<CorpusCase> cases = files.corpus.all();
  MergedRuns runs{.errors = files.corpus.errors};
  if (has_hunts) runs.worst = take_out_worst(cases);
  runs.findings = merged_findings(cases);
  if (const Settings* const usual = usual_settings(files.results)) {
    runs.result.emplace();
    runs.result->settings = *usual;
    runs.result->budgets_hold = true;
    runs.result->risk_error = kRiskError;
  }
  for (const ResultFile& result : files.results) {
    try {
      if (!result.campaign) {
        throw UserError(fmt::format("is a result of {}; those of fuzz are added up", result.kind));
      }
      add_run(*runs.result, *result.campaign);
    } catch (const UserError& error) {
      runs.errors.push_back(fmt::format("{}: {}", result.path, error.what()));
    }
  }
  if (!runs.result) return runs;
  find_over_budget(*runs.result);
  std::ranges::stable_sort(runs.result->buckets, {}, place_in_order);
  return runs;
}

void write_findings(MergedRuns& runs, const fs::path& folder, Interruption& interruption) {
  std::map<std::string, std::string> files;  // of the smallest, by their findings' keys
  for (const MergedFinding& finding : runs.findings) {
    if (interruption.is_stopped()) throw UserError("merge: interrupted; nothing was written");
    const CorpusCase& smallest = finding.smallest;
    const fs::path file = corpus_file(folder / corpus_folder(smallest), smallest);
    write_file(file, text_of(smallest));
    if (smallest.accepted) write_acceptance(file.string(), smallest.accepted);
    if (finding.worst) write_file(worst_beside(file), text_of(*finding.worst));
    if (smallest.expect) files[finding_key(*smallest.expect)] = file.string();
  }
  if (!runs.result) return;
  name_files(*runs.result, files);
  if (runs.result->hunt) write_worst(*runs.result->hunt, runs.worst, folder);
}

}  // namespace manifuzz
