#pragma once

#include <string>

#include "campaign/run.hpp"

namespace manifuzz {

/// `run_campaign` with its progress on the terminal, as this program on this machine runs it.
/// `command` is how one that repeats a case begins, up to --regime.
Campaign run_with_progress(const Plan& plan, const KnownBuckets& known, const SaveTo& save_to,
                           const std::string& command);

}  // namespace manifuzz
