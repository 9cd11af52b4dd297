#pragma once

#include <functional>

#include "campaign/findings.hpp"
#include "campaign/jobs.hpp"

namespace manifuzz {

/// Runs the plan: every case of it, or, where it ends at what is new, in rounds, up to the end of
/// the first round that fills a bucket which is not among the known. Rounds depend on the plan's
/// cases alone, so that any number of jobs finds the same.
JobsResult run_plan(const Plan& plan, const KnownBuckets& known, Interruption& interruption,
                    const std::function<void(const Progress&)>& on_progress);

}  // namespace manifuzz
