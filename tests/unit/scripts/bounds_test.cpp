#include <cstdlib>
#include <filesystem>
#include <string>

#include <catch2/catch.hpp>

#include "support/run_program.hpp"
#include "support/source_tree.hpp"
#include "support/temporary_folder.hpp"

// scripts/bounds over a stand-in for the hunts.

using namespace manifuzz::test;
using Catch::Contains;

namespace {

/// What the script says where every hunt finds that share of a position's bound, and ends so.
Outcome bounds(const std::string& share, int status = 0,
               const std::vector<std::string>& more = {}) {
  const TemporaryFolder folder;
  const std::string rows =
      R"({"rows": [{"measure": "bound_share.position", "worst": )" + share +
      R"(, "worst_drawn": 0.25, "file": "found/worst/x.json"}, {"measure": "error", "worst": 0, )"
      R"("worst_drawn": 0, "file": ""}]})";
  const std::string program =
      folder.write("manifuzz", "#!/bin/sh\nfor word; do last=$word; done\necho '" + rows +
                                   "' > \"$last\"\nexit " + std::to_string(status) + "\n");
  std::filesystem::permissions(program, std::filesystem::perms::owner_all);
  return run_program(with(
      {"env", "MANIFUZZ_PROGRAM=" + program, (source_dir() / "scripts/bounds").string()}, more));
}

}  // namespace

TEST_CASE("a line a bound, and status 0, where all answers are within") {
  const Outcome outcome = bounds("0.4321");
  CHECK(outcome.status == 0);
  CHECK_THAT(outcome.out, Contains("position              clip64           0.432       0.250  "
                                   "found/worst/x.json\n"));
  CHECK(lines_of(outcome.out).size() == 7);
  CHECK(bounds("5e-05").status == 0);
  const Outcome of_one = bounds("0.4321", 0, {"--collider", "gjk"});
  CHECK(lines_of(of_one.out).size() == 2);
  CHECK_THAT(of_one.out, Contains("position              gjk              0.432       0.250"));
}

TEST_CASE("an answer beyond its bound, or a wrong one, is status 1") {
  CHECK(bounds("1.01").status == 1);
  CHECK(bounds("12.5").status == 1);
  CHECK(bounds("0.5", 1).status == 1);
}

TEST_CASE("what the bounds are asked with is checked, and a hunt that fails ends it") {
  for (const std::vector<std::string>& wrong : {std::vector<std::string>{"--cases", "many"},
                                                {"--cases"},
                                                {"--seed", "-1"},
                                                {"--climbs", "-2"},
                                                {"--collider"},
                                                {"clip"}}) {
    const Outcome outcome = bounds("0.5", 0, wrong);
    CHECK(outcome.status == 2);
    CHECK(is_one_clear_line(outcome.err));
  }
  CHECK(bounds("0.5", 2).status == 2);
  CHECK_THAT(bounds("0.5", 0, {"--help"}).out, Contains("scripts/bounds [--seed N] [--cases N]"));
}
