#include "canary/sequence/sequence_bugs.hpp"

#include <iostream>
#include <set>

#include <catch2/catch.hpp>

#include "canary/edits.hpp"
#include "support/named_tests.hpp"
#include "support/source_tree.hpp"

// Bugs planted into the judge of sequences: it must say of some keeper what is not so.

namespace manifuzz::canary {
namespace {

std::set<std::string>& planted() {
  static std::set<std::string> bugs;
  return bugs;
}

}  // namespace

bool add_sequence_judges(const std::vector<Bug>& bugs, test::JudgeOfSequence judge) {
  for (const Bug& bug : bugs) {
    const std::string name = bug.name;
    planted().insert(name);
    const bool is_unedited = name.starts_with("unedited");
    const std::string verb = is_unedited ? " is not caught" : " is caught";
    test::add_test(name + verb, "[planted]", [=] {
      const Acting acting(bug);
      const auto complaint = test::complaint_about(judge);
      std::cout << name << ": " << complaint.value_or("nothing") << "\n";
      CHECK(complaint.has_value() == !is_unedited);
    });
  }
  return true;
}

}  // namespace manifuzz::canary

using namespace manifuzz;

TEST_CASE("every bug of the table of the judge of sequences is planted") {
  const auto edits = canary::read_edits(test::source_dir() / "tests/canary/sequence/edits.txt");
  CHECK(edits.size() >= 20);
  for (const canary::Edit& edit : edits) {
    CAPTURE(edit.bug);
    CHECK(canary::planted().contains(edit.bug));
  }
}
