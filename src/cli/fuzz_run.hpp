#pragma once

#include <string>
#include <vector>

#include "campaign/findings.hpp"
#include "campaign/jobs.hpp"
#include "campaign/result.hpp"

namespace manifuzz {

/// Takes the radii away where a party takes none.
void narrow_to_colliders(Plan& plan);

/// How saving went: one finding that cannot be written does not lose the others.
struct Saving {
  std::string first_error;
  bool interrupted = false;
  std::size_t unsaved = 0;  ///< new findings that were not written, since there was no time
};

/// A campaign that was run.
struct Campaign {
  Plan plan;
  JobsResult run;
  std::vector<Finding> findings;
  Saving saving;
  CampaignResult result;
};

/// Where a campaign's findings go.
struct SaveTo {
  std::string folder;   ///< a corpus; empty: nowhere
  Deadline deadline{};  ///< what is not saved until then is not
};

/// The campaign, until it is done or somebody asks to stop, with progress on the terminal; then
/// what it found that is new is shrunk and saved, what decides the status first; once somebody has
/// asked to stop, it is saved as it was seen. `command` is the beginning of one that repeats a
/// case, up to
/// --regime. What the plan's context refers to must outlive the campaign.
Campaign run_campaign(Plan plan, const KnownBuckets& known, const SaveTo& save_to,
                      const std::string& command);

}  // namespace manifuzz
