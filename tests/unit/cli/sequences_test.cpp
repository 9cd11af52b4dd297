#include <filesystem>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "corpus/corpus.hpp"
#include "support/run_program.hpp"
#include "support/temporary_folder.hpp"

using namespace manifuzz::test;
using Json = nlohmann::ordered_json;

namespace {

std::string sequences(const std::string& motion, int count) {
  const Outcome drawn = run_manifuzz(
      {"generate", "--seed", "1", "--regime", motion, "--cases", std::to_string(count)});
  REQUIRE(drawn.status == 0);
  return drawn.out;
}

Json fuzz(const TemporaryFolder& folder, const std::vector<std::string>& more, int status) {
  const Outcome outcome =
      run_manifuzz(with({"fuzz", "--subject", "cached-bullet", "--seed", "1", "--corpus",
                         (folder.path() / "corpus").string(), "--json", "-"},
                        more));
  INFO(outcome.err);
  CHECK(outcome.status == status);
  Json json = Json::parse(outcome.out, nullptr, false);
  REQUIRE(json.is_object());
  return json;
}

}  // namespace

TEST_CASE("a motion's sequences are a function of seed, name and index") {
  const auto all = lines_of(sequences("sliding", 5));
  REQUIRE(all.size() == 5);
  const Outcome third = run_manifuzz(
      {"generate", "--seed", "1", "--regime", "sliding", "--first", "2", "--cases", "1"});
  CHECK(lines_of(third.out) == std::vector<std::string>{all[2]});
  CHECK(Json::parse(all[2])["found"]["regime"] == "sliding");
}

TEST_CASE("a collider that keeps points answers each frame with a line, and is judged so") {
  const std::string drawn = sequences("turning_platform", 3);
  std::size_t frames = 0;
  for (const std::string& line : lines_of(drawn)) frames += Json::parse(line)["frames"].size();
  const auto answers = lines_of(run_manifuzz({"collide", "--collider", "cached"}, drawn).out);
  REQUIRE(answers.size() == frames);
  const Json first = Json::parse(answers.front());
  CHECK(first["collider"] == "cached");
  CHECK(first["sequence"] == 0);
  CHECK(first["frame"] == 0);
  CHECK(Json::parse(answers.back())["sequence"] == 2);
  const Outcome judged = run_manifuzz({"judge", "--subject", "cached"}, drawn);
  CHECK(judged.status == 0);
  const auto lines = lines_of(judged.out);
  REQUIRE(lines.size() == frames);
  CHECK(Json::parse(lines.front())["verdict"] == "agree");
  CHECK(Json::parse(lines.front())["kind"] == "none");
}

TEST_CASE("sequences and pair cases are told apart in one clear line") {
  const TemporaryFolder folder;
  const std::string sequence = folder.write("one.jsonl", sequences("sliding", 1));
  const std::string pair = folder.write(
      "pair.jsonl", run_manifuzz({"generate", "--regime", "boxes", "--cases", "1"}).out);
  struct Bad {
    std::vector<std::string> arguments;
    std::string complaint;
  };
  for (const Bad& bad : std::initializer_list<Bad>{
           {{"judge", sequence}, "is a sequence"},
           {{"collide", "--collider", "clip", sequence}, "is a sequence"},
           {{"judge", "--subject", "cached", pair}, "is a pair case"},
           {{"show", pair, "--subject", "cached"}, "is a pair case"},
           {{"show", sequence, "--subject", "clip"}, "clip keeps no points"},
           {{"show", sequence, "--map", "x.png"}, "--map: applies only to pair cases"},
           {{"shrink", sequence, "--subject", "cached"}, "cached is right on it"},
           {{"property", "--subject", "cached"}, "cached keeps points from frame to frame"},
           {{"fuzz", "--subject", "cached", "--regime", "sliver"},
            "sliver is a regime of pair cases"},
           {{"fuzz", "--regime", "sliding"}, "sliding is a motion"},
           {{"fuzz", "--subject", "cached", "--radius", "1"},
            "--radius: applies only to pair cases"},
           {{"fuzz", "--subject", "cachd"}, "there is no collider 'cachd'"}}) {
    const Outcome outcome = run_manifuzz(bad.arguments);
    CAPTURE(bad.arguments, outcome.err);
    CHECK(outcome.status == 2);
    CHECK(is_one_clear_line(outcome.err));
    CHECK(outcome.err.find(bad.complaint) != std::string::npos);
  }
}

TEST_CASE("a campaign of sequences counts them and their frames, whatever the jobs") {
  const TemporaryFolder folder;
  const auto with_jobs = [&](const std::string& jobs) {
    Json json = fuzz(folder, {"--cases", "400", "--jobs", jobs, "--no-save"}, 0);
    for (const char* key : {"jobs", "seconds", "cases_per_second"}) json.erase(key);
    return json;
  };
  const Json json = with_jobs("1");
  CHECK(json["sequences"] == 400);
  CHECK(json["frames"].get<int>() > 4 * 400);
  CHECK(json["regimes"].size() == 8);
  CHECK(json["regimes"][0]["cases"] == 50);
  CHECK(json["regimes"][0]["touching"].get<int>() > 0);
  CHECK(json["verdicts"]["known"].get<int>() > 0);
  CHECK(json == with_jobs("3"));
}

TEST_CASE("new buckets of sequences are shrunk and saved, and their commands repeat them") {
  const TemporaryFolder folder;
  const std::vector<std::string> campaign{"--regime", "turning_platform", "--cases",
                                          "100",      "--shrink-seconds", "60"};
  const Json first = fuzz(folder, campaign, 0);
  REQUIRE(first["buckets"].size() > 0);
  for (const Json& bucket : first["buckets"]) {
    CHECK(bucket["new"] == true);
    const std::string file = bucket["file"];
    CHECK(std::filesystem::path(file).parent_path().filename() == "sequences");
    const auto known = manifuzz::read_case_file(file, manifuzz::CaseKind::sequence);
    CHECK(known.expect->bucket == bucket["bucket"]);
    CHECK(known.sequence().frames.size() <= 3);
    CHECK(bucket["command"].get<std::string>().find(" --subject cached-bullet --corpus ") !=
          std::string::npos);
    const Json again = fuzz(folder,
                            {"--regime", "turning_platform", "--cases", "1", "--first",
                             std::to_string(bucket["first_index"].get<int>())},
                            0);
    REQUIRE(again["buckets"].size() == 1);
    CHECK(again["buckets"][0]["bucket"] == bucket["bucket"]);
    CHECK(again["buckets"][0]["new"] == false);
    const Outcome shown = run_manifuzz({"show", file, "--svg", "-"});
    CHECK(shown.out.find("<svg") != std::string::npos);
  }
  const std::string corpus = (folder.path() / "corpus").string();
  CHECK(run_manifuzz({"replay", corpus}).status == 0);
  CHECK(run_manifuzz({"shrink", corpus}).status == 0);
  // Commands that read pair cases pass over them.
  CHECK(run_manifuzz({"fuzz", "--seed", "1", "--cases", "200", "--corpus", corpus}).status == 0);
  const std::string merged = (folder.path() / "merged").string();
  CHECK(run_manifuzz({"merge", corpus, "--output", merged}).status == 0);
  CHECK(run_manifuzz({"replay", merged}).status == 0);
}

TEST_CASE("a campaign of sequences that is interrupted saves what it has found") {
  const TemporaryFolder folder;
  const std::string corpus = (folder.path() / "corpus").string();
  // By an event: the signal comes once what is found is there to be counted.
  const std::string script =
      "\"$0\" fuzz --subject cached-bullet --seed 1 --seconds 600 --jobs 2 --corpus \"$1\" "
      "--json \"$2\" > /dev/null & p=$!; until pgrep -P $p > /dev/null; do sleep 0.05; done; "
      "sleep 1; kill -INT $p; wait $p";
  const std::string json = (folder.path() / "run.json").string();
  const Outcome outcome = run_program({"sh", "-c", script, manifuzz_path(), corpus, json});
  INFO(outcome.err);
  CHECK(outcome.status == 130);
  const Json run = Json::parse(text_of(json));
  CHECK(run["interrupted"] == true);
  REQUIRE(run["buckets"].size() > 0);
  for (const Json& bucket : run["buckets"]) {
    CHECK(std::filesystem::exists(bucket["file"].get<std::string>()));
  }
}

TEST_CASE("what applies to pair cases alone is refused for sequences, whatever its value") {
  const std::vector<std::string> keeper = {"--subject", "cached"};
  const std::pair<std::vector<std::string>, std::string> refused[] = {
      {{"generate", "--regime", "sliding", "--corpus", "corpus"}, "--corpus: applies only to pair"},
      {with({"fuzz", "--cases", "1", "--oracle", "box2d"}, keeper),
       "--oracle: applies only to pair"},
      {with({"fuzz", "--cases", "1", "--in-process"}, keeper), "--in-process: applies only to"},
      {with({"judge", "--oracle", "box2d"}, keeper), "--oracle: applies only to pair"},
      {{"collide", "--collider", "cached", "--in-process"}, "--in-process: applies only to"}};
  for (const auto& [command, said] : refused) {
    CAPTURE(command);
    const Outcome outcome = run_manifuzz(command);
    CHECK(outcome.status == 2);
    CHECK(is_one_clear_line(outcome.err));
    CHECK_THAT(outcome.err, Catch::Contains(said));
  }
}
