#include <filesystem>
#include <map>
#include <optional>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "base/text.hpp"
#include "external/external_collider.hpp"
#include "sequence/motions.hpp"
#include "sequence/sequence_judge.hpp"
#include "support/installed_collider.hpp"
#include "support/run_program.hpp"
#include "support/skip.hpp"
#include "support/source_tree.hpp"
#include "support/temporary_folder.hpp"
#include "unit/sequence/keepers.hpp"

using namespace manifuzz;
using namespace manifuzz::test;
using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

namespace {

SequenceCollider keeping(const std::string& behaviour) {
  return keeper_of_command(std::string(MANIFUZZ_TEST_KEEPING_PROGRAM) + " " + behaviour, 0.5);
}

SequenceJudgement judged(const SequenceCollider& subject, const Sequence& sequence) {
  return judge_sequence(sequence, subject, ask_sequence(subject, sequence));
}

Json fuzz(const TemporaryFolder& folder, const std::string& behaviour,
          const std::vector<std::string>& more) {
  const Outcome outcome = run_manifuzz(with(
      {"fuzz", "--subject-command", std::string(MANIFUZZ_TEST_KEEPING_PROGRAM) + " " + behaviour,
       "--sequences", "--seed", "1", "--time-limit", "0.5", "--regime", "turning_platform",
       "--corpus", (folder.path() / "corpus").string(), "--json", "-"},
      more));
  INFO(outcome.err);
  Json json = Json::parse(outcome.out, nullptr, false);
  REQUIRE(json.is_object());
  json["status"] = outcome.status;
  return json;
}

}  // namespace

TEST_CASE("a program that keeps points is judged frame by frame, by what it declares") {
  const SequenceCollider right = keeping("right");
  CHECK(right.declaration.name == "keeping");
  CHECK(right.declaration.claims == Claims::point);
  CHECK(right.keeping.gap.relative == 0.02);
  CHECK(right.keeping.points_max == 3);
  const SequenceCollider stale = keeping("stale");
  std::size_t wrong = 0;
  for (std::uint64_t index = 0; index < 40; ++index) {
    const Sequence sequence = draw_sequence(1, *find_motion("turning_platform"), index);
    CHECK(judged(right, sequence).bucket.verdict != Verdict::subject_wrong);
    const Bucket of_stale = judged(stale, sequence).bucket;
    CHECK(of_stale == judged(keeper_with(Mistake::stale_normal), sequence).bucket);
    wrong += of_stale.kind == Kind::normal ? 1 : 0;
  }
  CHECK(wrong > 0);
}

TEST_CASE("what a program loses is its sequence's verdict, and the next one begins anew") {
  const Sequence sequence = draw_sequence(1, *find_motion("sliding"), 0);
  const std::pair<const char*, Verdict> endings[] = {{"crashes", Verdict::crashed},
                                                     {"hangs", Verdict::timed_out},
                                                     {"garbage", Verdict::malformed},
                                                     {"nonsense", Verdict::malformed}};
  for (const auto& [behaviour, verdict] : endings) {
    CAPTURE(behaviour);
    const SequenceCollider subject = keeping(behaviour);
    for (int again = 0; again < 2; ++again) {
      const auto answers = ask_sequence(subject, sequence);
      REQUIRE(answers.size() == 3);
      CHECK(std::holds_alternative<KeptManifold>(answers[1]));
      CHECK(judge_sequence(sequence, subject, answers).bucket.verdict == verdict);
    }
  }
}

TEST_CASE("a program that claims a manifold may give both ends of a contact") {
  const SequenceCollider ends = keeping("both_ends");
  CHECK(ends.declaration.claims == Claims::manifold);
  CHECK(ends.keeping.match_by == MatchBy::either);
  for (std::uint64_t index = 0; index < 40; ++index) {
    const Sequence sequence = draw_sequence(1, *find_motion("rocking"), index);
    CHECK(judged(ends, sequence).bucket.verdict == Verdict::agree);
  }
}

namespace {

/// What an engine's keeper is right about, or wrong in a way that is known; none where the engine
/// is not installed, or its ledger not built.
std::optional<std::map<Verdict, int>> verdicts_on(const std::string& program,
                                                  std::string_view engine, std::uint64_t of_each) {
  if (!collider_with_ledger(engine)) return std::nullopt;
  const SequenceCollider keeper = keeper_of_command(program, 10, 60);
  std::map<Verdict, int> verdicts;
  for (const Motion& motion : motions()) {
    for (std::uint64_t index = 0; index < of_each; ++index) {
      const Sequence sequence =
          draw_sequence(1, motion, index, [&](const Sequence& s) { return takes(keeper, s); });
      const Bucket bucket = judged(keeper, sequence).bucket;
      CAPTURE(motion.name, index, to_string(bucket));
      CHECK((bucket.verdict == Verdict::agree || bucket.verdict == Verdict::known));
      ++verdicts[bucket.verdict];
    }
  }
  return verdicts;
}

std::string quoted_in_engine(std::string_view engine, std::string_view file) {
  return quoted_for_shell(in_engine(engine, file).string());
}

}  // namespace

TEST_CASE("planck's clips are kept without a fault but for what planck itself gets wrong") {
  const auto verdicts =
      verdicts_on("node " + quoted_in_engine("planck", "kept.mjs"), "planck", 100);
  if (!verdicts) return;
  CHECK(verdicts->at(Verdict::agree) > 780);
}

TEST_CASE("the contacts of a Munk2D space are right but for what Munk2D itself gets wrong") {
  const auto verdicts = verdicts_on(quoted_in_engine("pymunk", "installed/bin/python") + " " +
                                        quoted_in_engine("pymunk", "kept.py"),
                                    "pymunk", 50);
  if (!verdicts) return;
  CHECK(verdicts->at(Verdict::agree) > 380);
}

TEST_CASE(
    "a program that does not say how it keeps points is refused, as is one that is not there") {
  CHECK_THROWS_WITH(keeping("undeclared"), Catch::Contains("\"keeping\" is missing"));
  CHECK_THROWS_WITH(keeper_of_command("no-such-program-anywhere", 1),
                    Catch::Contains("no-such-program-anywhere"));
}

TEST_CASE("campaigns of a program's sequences shrink, save and repeat what they find") {
  const TemporaryFolder folder;
  const Json run = fuzz(folder, "stale", {"--cases", "60", "--shrink-seconds", "60"});
  CHECK(run["status"] == 1);
  CHECK(run["verdicts"]["subject_wrong"].get<int>() > 0);
  REQUIRE(run["buckets"].size() > 0);
  const std::string file = run["buckets"][0]["file"];
  CHECK(Json::parse(text_of(file))["frames"].size() == 2);
  CHECK(run["buckets"][0]["command"].get<std::string>().find(" --sequences ") != std::string::npos);
  CHECK(fuzz(folder, "right", {"--cases", "60"})["status"] == 0);
  CHECK(run_manifuzz({"show", file, "--sequences", "--subject-command",
                      std::string(MANIFUZZ_TEST_KEEPING_PROGRAM) + " stale"})
            .out.find("did not turn with its body") != std::string::npos);
  const Json dead = fuzz(folder, "crashes", {"--cases", "100", "--no-save"});
  CHECK(dead["stopped_early"] == true);
  CHECK(dead["verdicts"]["crashed"].get<int>() >= 20);
}

TEST_CASE("a program that keeps points is asked again about its sequences as subjects.json says") {
  const TemporaryFolder folder;
  const Json run = fuzz(folder, "stale", {"--cases", "20"});
  const std::string file = run["buckets"][0]["file"];
  const std::string corpus = (folder.path() / "corpus").string();
  const std::string command = std::string(MANIFUZZ_TEST_KEEPING_PROGRAM) + " stale";
  const Outcome unnamed = run_manifuzz({"show", file, "--corpus", corpus});
  CHECK(unnamed.status == 2);
  CHECK(is_one_clear_line(unnamed.err));
  CHECK_THAT(unnamed.err, Catch::Contains("was found with 'keeping'") &&
                              Catch::Contains("--sequences") && Catch::Contains("subjects.json"));
  CHECK(run_manifuzz({"replay", corpus}).status == 2);
  folder.write("subjects.json", Json({{"keeping", {{"command", command}}}}).dump());
  CHECK_THAT(run_manifuzz({"show", file, "--corpus", corpus}).out,
             Catch::Contains("did not turn with its body"));
  const Outcome replayed = run_manifuzz({"replay", corpus, "--json", "-"});
  CHECK(replayed.status == 1);  // wrong as before, and not accepted
  CHECK_THAT(replayed.err, Catch::Contains("keeping is " + command + ", as "));
  CHECK(Json::parse(replayed.out)["unasked"] == Json::array());
  CHECK(run_manifuzz({"shrink", file, "--corpus", corpus}).status == 0);
  folder.write("subjects.json", R"({"keeping": {"library": "./libkeeping.so"}})");
  const Outcome library = run_manifuzz({"show", file, "--corpus", corpus});
  CHECK(library.status == 2);
  CHECK_THAT(library.err, Catch::Contains("subjects.json: keeping: a library keeps no points"));
}
