#pragma once

#include <optional>
#include <string>

#include <nlohmann/json.hpp>

#include "campaign/merge.hpp"
#include "campaign/replay.hpp"
#include "campaign/run.hpp"

// What campaigns, replays, properties and lists print, for people.

namespace manifuzz {

/// Regimes, verdicts (zeros too), findings with their commands, and what is new, worse and gone
/// against a baseline.
std::string summary_table(const Campaign& campaign,
                          const std::optional<CampaignResult>& baseline = {});

/// What of that decides the status, alone; nothing where all is well.
std::string objections(const Campaign& campaign);

/// One line of a running campaign: cases, rate, verdicts that count, time left.
std::string progress_line(const Plan& plan, const Progress& progress);

/// How many findings of so many cases were written to that folder, and the verdicts of the result.
std::string merged_text(const MergedRuns& runs, std::size_t cases, const std::string& folder);

/// What failed, a line each.
std::string replay_failures(const ReplayRun& run);
/// A line that counts.
std::string replay_counts(const ReplayRun& run);
/// What `replay --json` writes beside where it ran; `unread` files could not be read.
void append_replay_json(nlohmann::ordered_json& json, const ReplayRun& run, std::size_t unread);

/// What RapidCheck says, how to repeat a failure, and where its case was written.
std::string property_text(const CheckedProperty& checked);
/// A property that holds, in a line.
std::string property_line(const CheckedProperty& checked);

/// What there is, a line each, with its description.
std::string list_regimes();
std::string list_sweeps();
std::string list_scenes();
std::string list_ledger();

}  // namespace manifuzz
