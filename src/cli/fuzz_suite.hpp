#pragma once

#include "campaign/run.hpp"
#include "report/test_suite.hpp"

namespace manifuzz {

/// The campaign as a suite: a test for each regime, failing where anything is wrong with the
/// subject, which takes its share of the time; one for each bucket, each entry of the ledger and
/// the vacuous run that decide the status. The first failures with pictures, as far as there is
/// time.
TestSuite fuzz_suite(const Campaign& campaign, Interruption& interruption);

}  // namespace manifuzz
