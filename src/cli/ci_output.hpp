#pragma once

#include <span>
#include <string>

#include <CLI/CLI.hpp>

#include "cli/output.hpp"
#include "report/test_suite.hpp"

namespace manifuzz {

/// Where what a run came to goes besides a command's own outputs: a JUnit report, and, in a GitHub
/// workflow (GITHUB_ACTIONS=true), annotations and the step summary.
struct CiOutput {
  std::string junit;  ///< a file, or empty
  bool stdout_is_data =
      false;  ///< annotations then go to the standard error, which is read as well
};

/// Adds --junit.
void add_junit(CLI::App& app, CiOutput& ci);

/// Whether anybody is going to see the pictures of failures.
bool shows_pictures(const CiOutput& ci);

/// Writes them. A step summary that cannot be written is an error line, and no more.
void write_ci(const CiOutput& ci, std::span<const TestSuite> suites, Outputs& outputs);

}  // namespace manifuzz
