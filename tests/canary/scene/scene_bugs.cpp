#include "canary/scene/scene_bugs.hpp"

#include <algorithm>
#include <iostream>
#include <set>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "canary/edits.hpp"
#include "support/named_tests.hpp"
#include "support/source_tree.hpp"
#include "unit/scene/commands.hpp"
#include "unit/scene/crowd.hpp"

// Bugs planted into the scene: commands drawn by RapidCheck must find them, or a crowd.

namespace manifuzz::canary {
namespace {

constexpr int kRuns = 1500;
constexpr int kRunsUnedited = 200;
constexpr std::uint64_t kCrowds = 20;

class Silence : public rc::detail::TestListener {
 public:
  void onTestCaseFinished(const rc::detail::CaseDescription&) override {}
  void onShrinkTried(const rc::detail::CaseDescription&, bool) override {}
  void onTestFinished(const rc::detail::TestMetadata&, const rc::detail::TestResult&) override {}
};

bool is_unedited(const std::string& bug) {
  return bug.starts_with("unedited");
}

std::set<std::string>& planted() {
  static std::set<std::string> bugs;
  return bugs;
}

/// Whether commands find the bug; says which, shrunk.
bool commands_catch(const std::string& bug, test::MakeScene make) {
  rc::detail::TestMetadata metadata;
  metadata.id = bug;
  rc::detail::TestParams params;
  params.seed = 1;
  params.maxSuccess = is_unedited(bug) ? kRunsUnedited : kRuns;
  Silence silence;
  const auto result =
      rc::detail::checkTestable([make] { test::check_commands(make); }, metadata, params, silence);
  rc::detail::FailureResult failure;
  if (!result.match(failure)) return false;
  std::cout << bug << ": found after " << failure.numSuccess + 1 << " runs\n";
  for (const auto& [type, commands] : failure.counterExample) std::cout << commands << "\n";
  return true;
}

bool crowd_catches(test::MakeScene make) {
  for (std::uint64_t seed = 0; seed < kCrowds; ++seed) {
    if (test::crowd_complaint(make, seed)) return true;
  }
  return test::dense_crowd_complaint(make).has_value();
}

}  // namespace

bool add_scenes(const std::vector<Bug>& bugs, test::MakeScene make) {
  for (const Bug& bug : bugs) {
    const std::string name = bug.name;
    planted().insert(name);
    const std::string verb = is_unedited(name) ? " is not caught" : " is caught";
    test::add_test(name + verb, "[planted]", [=] {
      const Acting acting(bug);
      const bool caught = commands_catch(name, make) || crowd_catches(make);
      CHECK(caught == !is_unedited(name));
    });
  }
  return true;
}

}  // namespace manifuzz::canary

using namespace manifuzz;

TEST_CASE("every bug of the scene's table is planted") {
  const auto edits = canary::read_edits(test::source_dir() / "tests/canary/scene/edits.txt");
  CHECK(edits.size() >= 8);
  for (const canary::Edit& edit : edits) {
    CAPTURE(edit.bug);
    CHECK(canary::planted().contains(edit.bug));
  }
}
