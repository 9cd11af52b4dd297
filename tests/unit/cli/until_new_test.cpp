#include <filesystem>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "support/run_program.hpp"
#include "support/temporary_folder.hpp"

using namespace manifuzz::test;
using Catch::Contains;
using Json = nlohmann::ordered_json;

namespace {

std::vector<std::string> until_new(const std::string& corpus,
                                   const std::vector<std::string>& more) {
  return with({"fuzz", "--until-new", "--seed", "3", "--corpus", corpus}, more);
}

/// What a campaign says, but for its speed.
Json findings_of(const Outcome& outcome) {
  INFO(outcome.err);
  Json json = Json::parse(outcome.out, nullptr, false);
  REQUIRE(json.is_object());
  for (const char* key : {"jobs", "seconds", "cases_per_second"}) json.erase(key);
  return json;
}

bool has_new(const Json& json) {
  for (const Json& bucket : json["buckets"]) {
    if (bucket["new"] == true) return true;
  }
  return false;
}

}  // namespace

TEST_CASE("a campaign until something new ends with it, the same whatever the jobs", "[longer]") {
  const TemporaryFolder one;
  const TemporaryFolder two;
  std::uint64_t cases_before = 0;
  bool took_several_rounds = false;
  for (int again = 0; again < 12; ++again) {  // each knows what those before have saved
    const auto run = [&](const TemporaryFolder& folder, const char* jobs) {
      std::filesystem::create_directory(folder.path() / "corpus");
      return run_program({"sh",
                          "-c",
                          "cd \"$0\" && shift && \"$@\"",
                          folder.path().string(),
                          "sh",
                          manifuzz_path(),
                          "fuzz",
                          "--until-new",
                          "--ties",
                          "--regime",
                          "tie_bias",
                          "--regime",
                          "sliver",
                          "--seed",
                          "3",
                          "--cases",
                          "200000",
                          "--json",
                          "-",
                          "--jobs",
                          jobs});
    };
    const Outcome with_one = run(one, "1");
    const Json json = findings_of(with_one);
    CHECK(json == findings_of(run(two, "2")));
    REQUIRE(has_new(json));
    const auto cases = json["cases"].get<std::uint64_t>();
    CHECK(cases < 200'000);
    CHECK(cases >= cases_before);
    took_several_rounds = took_several_rounds || cases > 1024;
    cases_before = cases;
    for (const Json& bucket : json["buckets"]) {
      CHECK(std::filesystem::exists(one.path() / bucket["file"].get<std::string>()));
    }
  }
  CHECK(took_several_rounds);
}

TEST_CASE("where the corpus shows all there is, it ends at its limit and says so") {
  const TemporaryFolder folder;
  const std::string corpus = (folder.path() / "corpus").string();
  run_manifuzz({"fuzz", "--regime", "boxes", "--seed", "3", "--cases", "3000", "--corpus", corpus});
  const Outcome outcome = run_manifuzz(until_new(corpus, {"--regime", "boxes", "--cases", "3000"}));
  CHECK(outcome.status == 0);
  CHECK_THAT(outcome.out, Contains(": 3000 cases in ") && Contains("\nnothing new: "));
}

TEST_CASE("until something new, time may be the limit") {
  const TemporaryFolder folder;
  const Outcome outcome = run_manifuzz(until_new((folder.path() / "corpus").string(),
                                                 {"--regime", "separated", "--seconds", "0.5"}));
  CHECK(outcome.status == 0);
  CHECK_THAT(outcome.out, Contains("\nnothing new: "));
}
