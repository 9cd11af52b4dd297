#pragma once

#include <string>
#include <vector>

#include "campaign/jobs.hpp"
#include "campaign/result.hpp"
#include "campaign/save.hpp"

namespace manifuzz {

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

/// The campaign, until it is done or somebody asks to stop; then what it found that is new is
/// shrunk and saved, what decides the status first; once somebody has asked to stop, it is saved as
/// it was seen. `on_progress` runs a few times a second, and before each finding that is saved.
/// What the plan's context refers to must outlive the campaign.
Campaign run_campaign(const Plan& plan, const KnownBuckets& known, const SaveTo& save_to,
                      const Origin& origin, const OnProgress& on_progress);

}  // namespace manifuzz
