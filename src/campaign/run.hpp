#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "campaign/plan.hpp"
#include "campaign/result.hpp"
#include "campaign/save.hpp"
#include "process/pool.hpp"

namespace manifuzz {

/// What a campaign looks like while it runs.
struct Progress {
  const Tally& tally;
  double seconds = 0;    ///< since the first answer
  std::string saving{};  ///< once it has run: what is being done about a finding, for people
};

using OnProgress = std::function<void(const Progress&)>;

struct JobsResult {
  std::unique_ptr<Tally> tally;
  double seconds = 0;                  ///< since the first answer
  bool interrupted = false;            ///< somebody asked to stop before the plan was done
  std::optional<CaseNumber> sought{};  ///< the first with which the plan is to end
  std::uint64_t looks = 0;             ///< at the risk, where that is to end it
  bool is_risk_met = false;            ///< at the last of them it was low enough
  /// Who gave no answer again and again, which ended it.
  Fault given_up = Fault::none;
  std::string why_given_up{};  ///< what became of its last answer, in words
};

/// Adds a part of a run to what there is of it.
void add(JobsResult& all, const JobsResult& part);

inline bool has_ended(const JobsResult& run) {
  return run.interrupted || run.given_up != Fault::none;
}

/// The verdict on a case. Where both plainly agree, only one case in `judge_every` is judged.
Judgement judgement_on(const Plan& plan, CaseNumber number,
                       const std::shared_ptr<const exact::Truth>& truth,
                       const ColliderAnswer& subject, const ColliderAnswer& oracle);

/// Runs these cases of the plan, in as many child processes as it has jobs. A child that dies or
/// hangs loses the case it was at, which becomes a finding, and another goes on behind it.
/// `on_progress` runs a few times a second.
JobsResult run_jobs(const Plan& plan, SharedQueue::Block cases, Interruption& interruption,
                    const OnProgress& on_progress);

/// A campaign that was run.
struct Campaign {
  Plan plan;
  JobsResult run;
  std::vector<Finding> findings;
  Saving saving;
  CampaignResult result;
};

/// Where a result comes from, which the campaign cannot know.
struct Origin {
  std::string command;                ///< how one that repeats a case begins, up to --regime
  nlohmann::ordered_json provenance;  ///< machine, compiler and versions
};

/// Runs a plan's cases, until it is done or somebody asks to stop.
using RunCases = std::function<JobsResult(Interruption& interruption)>;

/// What a plan's cases gave, in whatever way they were run: what is new is shrunk and saved, what
/// decides the status first; once somebody has asked to stop, it is saved as it was seen.
Campaign run_campaign_by(const RunCases& run_cases, const Plan& plan, const Known& known,
                         const SaveTo& save_to, const Origin& origin,
                         const OnProgress& on_progress);

/// The campaign, until it is done or somebody asks to stop; then what it found that is new is
/// shrunk and saved, what decides the status first; once somebody has asked to stop, it is saved as
/// it was seen. `on_progress` runs a few times a second, and before each finding that is saved.
/// What the plan's context refers to must outlive the campaign.
Campaign run_campaign(const Plan& plan, const Known& known, const SaveTo& save_to,
                      const Origin& origin, const OnProgress& on_progress);

}  // namespace manifuzz
