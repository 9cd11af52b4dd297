#include "report/ci/ci_output.hpp"

#include <fmt/format.h>

#include "report/ci/junit.hpp"
#include "report/ci/workflow.hpp"

namespace manifuzz {

void check_outputs(CommandFiles files, CiOutput& ci) {
  files.outputs.push_back({"--junit", ci.junit});
  const std::string summary = step_summary_file();
  if (is_apart({"GITHUB_STEP_SUMMARY", summary}, files)) {
    ci.summary = summary;
  } else {
    write_complaint("GITHUB_STEP_SUMMARY: is another output or an input; the summary is left out");
  }
  ci.stdout_is_data = check_outputs(files);
}

bool is_wanted(const CiOutput& ci) {
  return !ci.junit.empty() || is_in_workflow();
}

void write_ci(const CiOutput& ci, std::vector<TestSuite> suites, Outputs& outputs) {
  auto& errors = suites.front().errors;
  errors.insert(errors.end(), outputs.errors().begin(), outputs.errors().end());
  outputs.write(!ci.junit.empty(), [&] { write_data(ci.junit, junit_xml(suites)); });
  if (!is_in_workflow()) return;
  const std::string text = workflow_annotations(suites);
  ci.stdout_is_data ? write_error(text) : write_to_reader(text);
  Outputs of_workflow;  // whose errors decide no status
  of_workflow.write(!ci.summary.empty(), [&] { append_step_summary(ci.summary, suites); });
}

int run_for_ci(std::string_view command, const CiOutput& ci, const std::function<int()>& run) {
  try {
    return run();
  } catch (const std::exception& error) {
    const auto* const bad = dynamic_cast<const BadOutput*>(&error);
    if (bad != nullptr && bad->concerns("--junit")) throw;
    TestSuite suite{fmt::format("manifuzz {}", command), "", {}};
    suite.errors.emplace_back(error.what());
    Outputs outputs;
    write_ci(ci, {suite}, outputs);
    throw;
  }
}

}  // namespace manifuzz
