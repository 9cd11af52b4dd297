#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "base/json.hpp"
#include "campaign/hints/hint.hpp"
#include "campaign/hunts/hunt_result.hpp"
#include "campaign/plan.hpp"
#include "campaign/risk/risk.hpp"
#include "corpus/corpus.hpp"
#include "judging/bucket.hpp"
#include "judging/judge.hpp"
#include "process/interruption.hpp"

namespace manifuzz {

/// Counts are so small that sums of them are exact, in this program and in any that reads JSON.
inline constexpr std::uint64_t kCountMax = std::uint64_t{1} << 53;

/// A regime's counts.
struct RegimeResult : RegimeTally {
  std::string name;
};

/// How often an entry of the ledger fired.
struct LedgerResult {
  std::string id;
  std::uint64_t hits = 0;
  std::map<std::string, std::uint64_t> regimes;  ///< its hits in each where it fired
  std::vector<std::string> over_budget;          ///< the regimes in which it fired too often
};

/// The findings of one bucket.
struct BucketResult {
  std::string bucket;
  std::string verdict{};
  std::uint64_t count = 0;
  std::uint64_t seed = 0;         ///< of its first case
  std::uint64_t first_index = 0;  ///< of its first case, in `regime`
  std::string regime{};
  WorstError error{};           ///< may be infinite
  std::string file{};           ///< of the corpus, or empty
  std::string command{};        ///< repeats the first case
  bool is_new = false;          ///< neither corpus nor baseline showed it before
  bool is_accepted = false;     ///< the corpus accepts it, no worse and no more often
  std::string objection{};      ///< why not, where it accepts less
  bool is_in_baseline = false;  ///< it is known, and no worse than in the baseline
  std::map<std::string, std::uint64_t> regimes{};  ///< the count in each where it was met
  std::map<std::string, std::uint64_t> agreed{};   ///< of these, agreed contacts
};

/// Which cases were run: of each regime so many from `first` on, under a seed.
struct CasesRun {
  std::uint64_t seed = 0;
  std::uint64_t first = 0;
  std::map<std::string, std::uint64_t> cases;  ///< by regime
  double seconds = 0;

  friend auto operator<=>(const CasesRun&, const CasesRun&) = default;
};

/// What a case's verdict depends on besides the case: results of the same settings are comparable.
struct Settings {
  std::string subject;
  std::string oracle;
  std::vector<std::pair<std::string, std::string>> versions;
  TieBias tie_bias{};            ///< the subject's
  std::optional<double> radius;  ///< of each polygon; none: the regime's own
  std::uint64_t judge_every = 1;
  std::vector<std::string> allowances{};  ///< what is not judged, or judged more mildly, and why
  std::string hunt{};                     ///< what bred the cases, in words; empty: they are drawn

  friend bool operator==(const Settings&, const Settings&) = default;
};

/// Whether it was these two that ran.
bool is_of(const Settings& settings, const std::string& subject, const std::string& oracle);

/// Whether both count some case.
bool overlap(const CasesRun& part, const CasesRun& with);

/// Makes parts of which one goes on where another ends, in every regime, one; sorts them.
void join(std::vector<CasesRun>& parts);

/// The result of a campaign, or of several as one: all that `fuzz --json` writes.
struct CampaignResult {
  nlohmann::ordered_json machine = nlohmann::ordered_json::object();  ///< as `provenance` has it
  std::string compiler;
  Settings settings;
  std::vector<CasesRun> parts;  ///< one of a campaign, of several all that are apart; sorted
  std::uint64_t jobs = 0;
  std::array<std::uint64_t, kVerdictNames.size()> verdicts{};
  std::uint64_t by_tolerance = 0;     ///< right only by the tolerance that a collider declares
  std::uint64_t agreeing_judged = 0;  ///< of the agreeing cases, those that were judged too
  Errors of_subject;                  ///< the worst errors of wrong answers
  Errors of_oracle;
  bool interrupted = false;
  std::uint64_t unshrunk = 0;        ///< new findings that there was no time to make smaller
  std::vector<std::string> stale{};  ///< files whose finding is accepted and comes no more
  bool stopped_early = false;        ///< a collider gave no answer again and again
  bool budgets_hold = false;         ///< whether the ledger's budgets apply to it
  std::vector<RegimeResult> regimes;
  std::vector<LedgerResult> ledger;
  std::vector<BucketResult> buckets;
  std::vector<Hint> hints{};  ///< known mistakes of an adapter that make the wrong answers
  /// The chance that an interval of the risk misses; none: what is needed was not counted.
  std::optional<double> risk_error{};
  std::string ended_by{};  ///< risk, cases, seconds or another, where the risk was to end it
  std::optional<HuntResult> hunt{};

  std::uint64_t cases() const { return sum_of(regimes, &RegimeTally::cases); }
  std::uint64_t touching() const { return sum_of(regimes, &RegimeTally::touching); }
  std::uint64_t near() const { return sum_of(regimes, &RegimeTally::near); }
  std::uint64_t frames() const { return sum_of(regimes, &RegimeTally::frames); }
  /// Whether its cases are sequences, whose frames are counted too.
  bool has_frames() const { return frames() > 0; }
  std::uint64_t agreeing() const { return verdicts[static_cast<std::size_t>(Verdict::agree)]; }
  std::uint64_t unexplained() const;          ///< nor accepted
  std::uint64_t accepted() const;             ///< not explained, but accepted
  double seconds() const;                     ///< of all parts
  std::optional<std::uint64_t> seed() const;  ///< none: several
  std::uint64_t first() const;                ///< the least index in each regime
};

/// Whether no case was answered, for one of both could take none of them.
bool is_all_unsupported(const CampaignResult& result);

/// A run of no case proves nothing, nor does one whose cases are all unsupported, nor one of so
/// many outside the regime `separated` in which nothing touched.
inline constexpr std::uint64_t kVacuousCases = 1000;
bool is_vacuous(const CampaignResult& result);

/// Whether the status must tell of a finding: anything against the subject, and what is new against
/// the oracle, unless it is accepted or the baseline has it. A bucket that this version does not
/// know is nothing to be silent about.
bool decides_status(const BucketResult& found);

/// How many cases of a regime have findings against the subject that decide the status.
std::uint64_t failures_in(const CampaignResult& result, const std::string& regime);

/// Whether the status must tell of it: such a bucket, an entry of the ledger over its budget, or a
/// vacuous run.
bool has_failed(const CampaignResult& result);

/// What `fuzz --json` writes.
nlohmann::ordered_json json_of(const CampaignResult& result);

/// What was written so: every part that is read has its type, and no case is counted twice; sums
/// are taken from the rows. Unknown keys are let be, for they may be a later version's. Throws
/// UserError that begins with a path.
CampaignResult read_campaign_result(const JsonView& root);

/// What a measuring command wrote with --json.
struct ResultFile {
  std::string path;
  std::string_view kind;  ///< the command: fuzz, replay, bench, stress or scene
  nlohmann::ordered_json json;
  std::optional<CampaignResult> campaign{};  ///< the same, of fuzz
};

/// The result in a file. Throws UserError that begins with the file's name.
ResultFile read_result(const std::string& path);

/// What runs left behind: cases and results, told apart by what is in them.
struct RunFiles {
  Corpus corpus;  ///< its errors name what is neither, its files are all that were read
  std::vector<ResultFile> results;
};

/// Everything in these files and folders, sorted by path; "-" is the standard input. What is broken
/// gives an error line, the rest is read all the same.
RunFiles read_run_files(std::span<const std::filesystem::path> paths);

/// Budgets hold for the regimes as they are, as far as the colliders take them: a plan with radii
/// of its own is not held to them.
bool holds_budgets(const Plan& plan);

/// Whether something was met more often in so many cases of a regime than its budget and five
/// standard deviations of chance allow. The regime `corpus`, which depends on what the corpus
/// holds, has none.
bool is_over_budget(double per_million, std::string_view regime, std::uint64_t hits,
                    std::uint64_t cases);

/// Every entry of the plan's oracle.
std::vector<LedgerResult> ledger_counts(const Tally& tally, const Plan& plan);

/// How a run's buckets compare with an earlier run's, by their names.
struct BucketComparison {
  std::vector<std::string> appeared;  ///< in this run alone
  std::vector<std::string> gone;      ///< in the earlier one alone
  std::vector<std::string> still;     ///< in both, and no worse
  std::vector<std::string> worse;     ///< in both, its magnitude grown by more than a tenth
};

/// What `fuzz --json` wrote. Throws UserError that names the file.
CampaignResult read_baseline(const std::string& path);

/// One line that names the terms (subject, oracle, seed, first, cases, regimes) in which two runs
/// differ, so that the comparison is not fair; empty where there are none.
std::string differences_in_words(const CampaignResult& earlier, const CampaignResult& now);

BucketComparison compared(const CampaignResult& earlier, const CampaignResult& now);

/// Marks what decides no status beside a baseline: all that is not new and no worse there.
void hold_against(const CampaignResult& earlier, CampaignResult& now);

/// For people: what differs in the terms, and the buckets that are new, worse or gone.
std::string comparison_text(const CampaignResult& earlier, const CampaignResult& now);
/// How many buckets those are, and what differs in the terms, in a line without its end.
std::string comparison_line(const CampaignResult& earlier, const CampaignResult& now);
nlohmann::ordered_json comparison_json(const BucketComparison& comparison);

/// What several corpora know of one finding.
struct MergedFinding {
  CorpusCase smallest;              ///< the least complex
  std::optional<CorpusCase> worst;  ///< of the greatest magnitude as it was seen, if another case
};

/// One of each finding (`finding_key`), in the order of the keys; cases that no comparison found
/// (of a property, written by hand) all, but each pair once. Paths of the form name.worst.json are
/// what name.json was shrunk from. Of equally bad witnesses the first in the order of a campaign is
/// kept: by index, then by the regime's place in the list.
std::vector<MergedFinding> merged_findings(const std::vector<CorpusCase>& cases);

/// What several runs left behind, as if one campaign had run all their cases.
struct MergedRuns {
  std::vector<MergedFinding> findings{};
  std::vector<CorpusCase> worst{};  ///< cases that hunts keep, of which a sum names the worst
  std::optional<CampaignResult> result{};  ///< none without any
  std::vector<std::string> errors;         ///< one line for each file that is left out
};

/// Findings are merged as above. Results of `fuzz` are added up in their order: counts are sums, a
/// bucket's first case is the least by index, regime and seed, its magnitude the greatest, and a
/// hunt's worst is the worst of all. Sums may be added up again. A result of other settings than
/// most have, or with cases that are counted already, is left out.
MergedRuns merged_runs(const RunFiles& files);

/// Writes the findings to a folder as a campaign would have, and names their files in the result.
/// Throws UserError, where it is interrupted too.
void write_findings(MergedRuns& runs, const std::filesystem::path& folder,
                    Interruption& interruption);

}  // namespace manifuzz
