#pragma once

#include <functional>
#include <memory>
#include <string>

#include "campaign/plan.hpp"
#include "process/pool.hpp"

namespace manifuzz {

/// What a campaign looks like while it runs.
struct Progress {
  const Tally& tally;
  double seconds = 0;
  std::string saving{};  ///< once it has run: what is being done about a finding, for people
};

using OnProgress = std::function<void(const Progress&)>;

struct JobsResult {
  std::unique_ptr<Tally> tally;
  double seconds = 0;
  bool interrupted = false;  ///< somebody asked to stop before the plan was done
  /// Who gave no answer again and again, which ended it.
  Fault given_up = Fault::none;
  std::string why_given_up{};  ///< what became of its last answer, in words
};

/// Runs these cases of the plan, in as many child processes as it has jobs. A child that dies or
/// hangs loses the case it was at, which becomes a finding, and another goes on behind it.
/// `on_progress` runs a few times a second.
JobsResult run_jobs(const Plan& plan, SharedQueue::Block cases, Interruption& interruption,
                    const OnProgress& on_progress);

}  // namespace manifuzz
