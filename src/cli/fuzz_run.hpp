#pragma once

#include <string>
#include <vector>

#include "cli/ci_output.hpp"
#include "cli/fuzz_report.hpp"

namespace manifuzz {

/// Takes the radii away where a party takes none.
void narrow_to_colliders(Plan& plan);

/// The campaign, until it is done or somebody asks to stop; progress goes to the terminal.
JobsResult run_watched(const Plan& plan, const KnownBuckets& known);

/// How saving went: one finding that cannot be written does not lose the others.
struct Saving {
  std::string first_error;
  bool interrupted = false;
  std::size_t unsaved = 0;
};

/// What a campaign found that is new goes to the folder `corpus`, even after the campaign was
/// interrupted, as far as there is time.
Saving save_new(std::vector<Finding>& found, const Plan& plan, const std::string& corpus,
                Interruption& interruption);

/// The campaign as a suite: a test for each regime, failing where anything is wrong with the
/// subject, which takes its share of the time; one for each bucket, each entry of the ledger and
/// the vacuous run that decide the status. The first failures with pictures, if those are wanted
/// and as far as there is time.
TestSuite fuzz_suite(const CampaignReport& report, bool with_pictures, Interruption& interruption);

}  // namespace manifuzz
