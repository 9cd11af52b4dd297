#pragma once

#include <span>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "campaign/budgets.hpp"
#include "campaign/findings.hpp"
#include "campaign/jobs.hpp"
#include "cli/baseline.hpp"

namespace manifuzz {

/// A finished campaign, as its report needs it.
struct CampaignReport {
  const Plan& plan;
  const JobsResult& run;
  const std::vector<Finding>& findings;
  std::vector<LedgerCount> ledger;
  std::optional<EarlierRun> baseline;
  std::size_t unsaved = 0;  ///< new buckets that were not written, since somebody was in a hurry
  std::string command;      ///< the beginning of a command that repeats a case, up to --regime
};

/// A run of so many cases outside the regime `separated` in which nothing touched proves nothing.
inline constexpr std::uint64_t kVacuousCases = 1000;
struct RegimeCount {
  std::string_view name;
  std::uint64_t cases = 0;
  std::uint64_t touching = 0;
};
bool is_vacuous(std::span<const RegimeCount> regimes);
bool is_vacuous(const CampaignReport& report);

/// Whether a finding is one that the status must tell: anything against the subject, and what is
/// new against the oracle.
bool decides_status(const Finding& finding);

/// Whether the campaign found what its status must tell: anything against the subject, a bucket of
/// the oracle's that is new, an entry of the ledger over its budget, or a vacuous run.
bool has_failed(const CampaignReport& report);

/// The command that repeats the first case of a finding.
std::string command_of(const CampaignReport& report, const Finding& finding);

/// For people: regimes, verdicts (zeros too), findings with their commands.
std::string summary_table(const CampaignReport& report);

/// What of that decides the status, alone; nothing where all is well.
std::string objections(const CampaignReport& report);

nlohmann::ordered_json summary_json(const CampaignReport& report);

/// One line of a running campaign: cases, rate, verdicts that count, time left.
std::string progress_line(const Plan& plan, const Progress& progress);

}  // namespace manifuzz
