#include <filesystem>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "corpus/corpus.hpp"
#include "support/interruption.hpp"
#include "support/run_program.hpp"
#include "support/temporary_folder.hpp"

using namespace manifuzz::test;
using Json = nlohmann::ordered_json;

namespace {

std::vector<std::string> fuzz(const TemporaryFolder& folder, const std::vector<std::string>& more) {
  return with({"fuzz", "--corpus", (folder.path() / "corpus").string()}, more);
}

Json summary(const Outcome& outcome) {
  INFO(outcome.err);
  Json json = Json::parse(outcome.out, nullptr, false);
  REQUIRE(json.is_object());
  return json;
}

}  // namespace

TEST_CASE("a campaign's JSON has every key that is promised, and every verdict, zeros too") {
  const TemporaryFolder folder;
  const Outcome outcome =
      run_manifuzz(fuzz(folder, {"--seed", "1", "--cases", "4000", "--no-save", "--json", "-"}));
  CHECK(outcome.status == 0);
  const Json json = summary(outcome);
  for (const char* key :
       {"machine", "compiler", "seed", "versions", "cases", "seconds", "cases_per_second", "jobs",
        "touching", "near", "verdicts", "unexplained", "regimes", "buckets"}) {
    CHECK(json.contains(key));
  }
  CHECK(json["cases"] == 4000);
  CHECK(json["verdicts"].size() == 11);
  CHECK(json["regimes"].size() == 27);
  CHECK(outcome.out.find("\"/") == std::string::npos);  // no absolute path
  CHECK_FALSE(std::filesystem::exists(folder.path() / "corpus"));
}

TEST_CASE("a finding is saved once, and its command repeats it, saved or not") {
  const TemporaryFolder folder;
  const std::vector<std::string> campaign{"--seed",   "2",        "--cases",  "20000",
                                          "--regime", "tie_bias", "--radius", "0",
                                          "--ties",   "--json",   "-"};
  const Json first = summary(run_manifuzz(fuzz(folder, campaign)));
  bool found = false;
  for (const Json& bucket : first["buckets"]) {
    CHECK(bucket["new"] == true);
    CHECK(std::filesystem::exists(bucket["file"].get<std::string>()));
    if (bucket["verdict"] != "known") continue;
    found = true;
    const Json again = summary(run_manifuzz(fuzz(
        folder, {"--seed", "2", "--regime", "tie_bias", "--radius", "0", "--cases", "1", "--first",
                 std::to_string(bucket["first_index"].get<std::uint64_t>()), "--json", "-"})));
    REQUIRE(again["buckets"].size() == 1);
    CHECK(again["buckets"][0]["bucket"] == bucket["bucket"]);
    CHECK(again["buckets"][0]["new"] == false);
  }
  CHECK(found);
  const Json second = summary(run_manifuzz(fuzz(folder, campaign)));
  CHECK(second["verdicts"] == first["verdicts"]);
  for (const Json& bucket : second["buckets"]) CHECK(bucket["new"] == false);
}

TEST_CASE("the number of jobs changes nothing in the summary but the speed") {
  const TemporaryFolder folder;
  const auto with_jobs = [&](const char* jobs) {
    Json json = summary(run_manifuzz(fuzz(
        folder, {"--seed", "3", "--cases", "6000", "--jobs", jobs, "--no-save", "--json", "-"})));
    for (const char* key : {"jobs", "seconds", "cases_per_second"}) json.erase(key);
    return json;
  };
  CHECK(with_jobs("1") == with_jobs("3"));
}

TEST_CASE("a wrong subject is status 1") {
  const TemporaryFolder folder;
  const Outcome outcome =
      run_manifuzz(fuzz(folder, {"--subject", "box2d", "--oracle", "clip", "--regime", "tie_bias",
                                 "--seed", "1", "--cases", "5000", "--no-save"}));
  CHECK(outcome.status == 1);
  CHECK(outcome.out.find("new box2d: missed contact") != std::string::npos);
}

TEST_CASE("a run in which nothing touches is vacuous, unless it is the regime for that") {
  const TemporaryFolder folder;
  CHECK(run_manifuzz(
            fuzz(folder, {"--regime", "separated", "--seed", "1", "--cases", "2000", "--no-save"}))
            .status == 0);
  // A corpus of nothing but polygons far apart is all that its regime has to draw from.
  const std::filesystem::path corpus = folder.path() / "corpus";
  std::filesystem::create_directory(corpus);
  folder.write("corpus/apart.json",
               R"({"format": "manifuzz/case/1", "a": {"vertices": [[0,0],[1,0],[0,1]]}, )"
               R"("b": {"vertices": [[0,0],[1,0],[0,1]], "position": [900,900]}})");
  const Outcome vacuous = run_manifuzz(
      fuzz(folder, {"--regime", "corpus", "--seed", "1", "--cases", "2000", "--no-save"}));
  CHECK(vacuous.status == 1);
  CHECK(vacuous.out.find("vacuous") != std::string::npos);
}

TEST_CASE("a run whose cases are all unsupported is vacuous, however few") {
  const TemporaryFolder folder;
  for (const char* const cases : {"1", "2000"}) {
    const auto arguments =
        fuzz(folder, {"--regime", "circles", "--seed", "1", "--no-save", "--subject", "gjk-clip"});
    const Outcome text = run_manifuzz(with(arguments, {"--cases", cases}));
    CHECK(text.status == 1);
    CHECK(text.out.find("vacuous: gjk-clip or box2d takes none of these cases") !=
          std::string::npos);
    const Outcome outcome = run_manifuzz(with(arguments, {"--cases", cases, "--json", "-"}));
    CHECK(outcome.status == 1);
    const Json json = summary(outcome);
    CHECK(json["vacuous"] == true);
    CHECK(json["verdicts"]["unsupported"] == json["cases"]);
  }
}

TEST_CASE("a program that dies before its first answer is no success where it is asked nothing") {
  const TemporaryFolder folder;
  const Outcome outcome =
      run_manifuzz(fuzz(folder, {"--regime", "circles", "--seed", "1", "--cases", "1000",
                                 "--subject-command", "false", "--oracle", "clip", "--no-save"}));
  CHECK(outcome.status == 1);
  CHECK(outcome.out.find("vacuous") != std::string::npos);
}

TEST_CASE("bad usage of fuzz is one clear line and status 2") {
  const TemporaryFolder folder;
  const std::string broken = folder.write("broken.json", "{");
  const std::vector<std::vector<std::string>> bad{
      {"--regime", "no_such"},
      {"--subject", "no_such"},
      {"--cases", "0"},
      {"--cases", "-1"},
      {"--seconds", "-1"},
      {"--cases", "1", "--seconds", "1"},
      {"--jobs", "0"},
      {"--jobs", "100000"},
      {"--seed", "1e3"},
      {"--subject", "box2d", "--tie-bias", "0.1"},
      {"--radius", "nan"},
      {"--first", "x"},
      {"--no-such-option"},
      {"--corpus", broken},
      {"--radius", "1e300"},
      {"--corpus", ""},
      {"--first", "18446744073709551615", "--cases", "100"}};
  for (const auto& arguments : bad) {
    std::vector<std::string> all = with({"fuzz", "--no-save"}, arguments);
    if (arguments[0] != "--cases" && arguments[0] != "--seconds") {
      all.insert(all.end(), {"--cases", "10"});
    }
    const Outcome outcome = run_manifuzz(all);
    INFO(arguments[0] << ": " << outcome.err);
    CHECK(outcome.status == 2);
    CHECK(is_one_clear_line(outcome.err));
  }
}

TEST_CASE("an interrupted campaign keeps what it found") {
  const TemporaryFolder folder;
  const std::string json = (folder.path() / "summary.json").string();
  const std::filesystem::path corpus = folder.path() / "corpus";
  const Outcome outcome =
      run_interruptible(fuzz(folder, {"--subject-command", interrupting_clip(folder, 4000),
                                      "--regime", "tie_bias", "--regime", "sliver", "--seconds",
                                      "3600", "--seed", "1", "--ties", "--json", json}));
  INFO(outcome.err);
  CHECK(outcome.status == 130);  // what it found is known, or a tie
  CHECK(outcome.out.find("interrupted") != std::string::npos);
  const Json run = Json::parse(text_of(json));
  CHECK(run["cases"] >= 3000);  // but for the blocks that were begun
  CHECK(run["buckets"].size() > 5);
  CHECK(std::filesystem::exists(corpus / "defects" / "box2d"));
  const Outcome replayed = run_manifuzz({"replay", corpus, "--json", "-"});
  CHECK(replayed.status == 0);  // each file shows the bucket that it is named after
  CHECK(Json::parse(replayed.out)["cases"] == run["buckets"].size());
  for (const manifuzz::CorpusCase& known : manifuzz::read_corpus({&corpus, 1}).cases) {
    CAPTURE(known.path);
    // The case itself is one of the neighbours, of those that there was time for.
    CHECK(known.expect->severity.value_or(1) > 0);
  }
}

TEST_CASE("a finding that cannot be saved loses neither the table nor the other files") {
  const TemporaryFolder folder;
  const std::string json = (folder.path() / "summary.json").string();
  std::filesystem::create_directories(folder.path() / "corpus/defects");
  folder.write("corpus/defects/box2d", "a file where a folder should be");
  const Outcome outcome = run_manifuzz(
      fuzz(folder, {"--seed", "1", "--cases", "20000", "--regime", "tie_bias", "--json", json}));
  CHECK(outcome.status == 2);
  CHECK(is_one_clear_line(outcome.err));
  CHECK(outcome.err.find(" could not be saved: ") != std::string::npos);
  CHECK(outcome.out.find("clip against box2d") != std::string::npos);
  CHECK(std::filesystem::exists(json));
}

TEST_CASE("a reader of stdout that is gone changes neither the status nor the files") {
  const TemporaryFolder folder;
  const std::string json = (folder.path() / "summary.json").string();
  const std::string script =
      "\"$0\" fuzz --subject box2d --oracle clip --regime tie_bias --seed 1 --cases 5000 "
      "--no-save --json \"$1\" | true; exit ${PIPESTATUS[0]}";
  const Outcome outcome = run_program({"bash", "-c", script, manifuzz_path(), json});
  CHECK(outcome.status == 1);
  CHECK(std::filesystem::exists(json));
}

TEST_CASE("commands of findings are one shell word an argument") {
  const TemporaryFolder folder;
  const std::string corpus = (folder.path() / "it's here").string();
  const Json json = summary(run_manifuzz(
      {"fuzz", "--seed", "1", "--cases", "2000", "--no-save", "--corpus", corpus, "--json", "-"}));
  REQUIRE_FALSE(json["buckets"].empty());
  const Outcome again =
      run_program({"bash", "-c", json["buckets"][0]["command"].get<std::string>() + " --no-save"});
  INFO(again.err);
  CHECK(again.status == 0);
}
