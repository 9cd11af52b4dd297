#include "cli/baseline.hpp"

#include <cmath>

#include <catch2/catch.hpp>

#include "cases/user_error.hpp"
#include "support/temporary_folder.hpp"

using namespace manifuzz;

namespace {

Finding finding(Kind kind, double magnitude) {
  Finding found;
  found.bucket = {.fault = Fault::subject, .verdict = Verdict::subject_wrong, .kind = kind};
  found.tally.magnitude = magnitude;
  return found;
}

using Names = std::vector<std::string>;

}  // namespace

TEST_CASE("a run against an earlier one: what is new, worse, still there, gone") {
  const test::TemporaryFolder folder;
  const auto path = folder.write("earlier.json", R"({"buckets": [
    {"bucket": "subject/subject_wrong/depth/none/a", "magnitude": 0.1},
    {"bucket": "subject/subject_wrong/count/none/a", "magnitude": 0.1},
    {"bucket": "subject/subject_wrong/features/none/a", "magnitude": 0}]})");
  const std::vector<Finding> now{finding(Kind::normal, 0.1), finding(Kind::depth, 0.1),
                                 finding(Kind::count, 0.2)};
  const Comparison comparison = compared(read_baseline(path).buckets, now);
  CHECK(comparison.appeared == Names{"subject/subject_wrong/normal/none/a"});
  CHECK(comparison.still == Names{"subject/subject_wrong/depth/none/a"});
  CHECK(comparison.worse == Names{"subject/subject_wrong/count/none/a"});
  CHECK(comparison.gone == Names{"subject/subject_wrong/features/none/a"});
  CHECK(comparison_json(comparison)["new"].size() == 1);
}

TEST_CASE("a magnitude beyond JSON is read back as infinite") {
  const test::TemporaryFolder folder;
  const auto path = folder.write("earlier.json", R"({"buckets": [
    {"bucket": "subject/subject_wrong/depth/none/a", "magnitude": null}]})");
  CHECK(std::isinf(read_baseline(path).buckets.at(0).magnitude));
}

TEST_CASE("what two runs do not share is said") {
  const nlohmann::ordered_json one{{"seed", 1}, {"cases", 10}, {"regimes", {"boxes"}}};
  nlohmann::ordered_json other = one;
  CHECK(differences_in_words(one, other).empty());
  other["seed"] = 2;
  other["regimes"] = {"grid"};
  CHECK(differences_in_words(one, other)
            .starts_with("the baseline differs in seed (1, now 2), regimes:"));
}

TEST_CASE("a baseline that is no report is a user's error") {
  const test::TemporaryFolder folder;
  for (const auto* text : {"", "[]", "{\"buckets\": 3}", "{\"buckets\": {}}", "{\"buckets\": null}",
                           "{\"buckets\": [{}]}"}) {
    CHECK_THROWS_AS(read_baseline(folder.write("earlier.json", text)), UserError);
  }
  CHECK_THROWS_AS(read_baseline("no-such-file"), UserError);
}
