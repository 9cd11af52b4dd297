#pragma once

#include <functional>
#include <memory>
#include <string>

#include "campaign/in_child.hpp"
#include "campaign/plan.hpp"
#include "process/process.hpp"

namespace manifuzz {

/// What a campaign looks like while it runs.
struct Progress {
  const Tally& tally;
  double seconds = 0;
};

struct JobsResult {
  std::unique_ptr<Tally> tally;
  double seconds = 0;
  bool interrupted = false;  ///< somebody asked to stop before the plan was done
  Fault unresponsive =
      Fault::none;                 ///< the party that died or hung again and again, which ended it
  std::string why_unresponsive{};  ///< its last end, in words
};

/// The cases from `begin` to before `end`.
struct Stretch {
  CaseNumber begin = 0;
  CaseNumber end = 0;
};

/// Runs every case of that stretch of the plan, in as many child processes. A child that dies or
/// hangs loses the case it was at, which becomes a finding, and another goes on behind it.
/// `on_progress` runs a few times a second.
JobsResult run_jobs(const Plan& plan, Stretch stretch, Interruption& interruption,
                    const std::function<void(const Progress&)>& on_progress);

}  // namespace manifuzz
