#pragma once

#include <span>
#include <string>

#include "report/ci/test_suite.hpp"

// The step of a GitHub workflow that this process runs in, as its environment describes it.

namespace manifuzz {

/// Whether there is one: GITHUB_ACTIONS=true.
bool is_in_workflow();

/// The file of the step's summary, or empty.
std::string step_summary_file();

/// What is wrong with these, with files as the repository has them.
std::string workflow_annotations(std::span<const TestSuite> suites);

/// Appends the suites to the step's summary, what other programs of this step wrote stays. Throws
/// UserError.
void append_step_summary(const std::string& file, std::span<const TestSuite> suites);

}  // namespace manifuzz
