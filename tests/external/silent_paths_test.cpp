#include <algorithm>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "cli/commands.hpp"
#include "engines/asked_engines.hpp"
#include "engines/colliders.hpp"
#include "support/installed_collider.hpp"
#include "support/run_program.hpp"
#include "support/source_tree.hpp"
#include "support/temporary_folder.hpp"

// No path on which a wrong answer can be reported is silent: each is asked about a collider with a
// planted bug, and must say so. A command without a row here fails.

using namespace manifuzz;
using namespace manifuzz::test;
using Json = nlohmann::ordered_json;

namespace {

using Words = std::vector<std::string>;

/// A folder with what the paths need: a collider that always gives the same contact, and a case.
struct Bench {
  TemporaryFolder folder;
  /// The planted bug: whatever the shapes, one point far away along x.
  std::string wrong = "sh " + folder.write("wrong.sh",
                                           "while read -r line; do echo '{\"points\": "
                                           "[{\"position\": [500,0], \"depth\": 3}], "
                                           "\"normal\": [1,0]}'; done\n");
  std::string boxes = folder.write(
      "boxes.json",
      R"({"format": "manifuzz/case/1", "a": {"vertices": [[-1,-1],[1,-1],[1,1],[-1,1]]}, )"
      R"("b": {"vertices": [[-1,-1],[1,-1],[1,1],[-1,1]], "position": [0.5,1.9]}})");

  std::string in(const std::string& name) const { return (folder.path() / name).string(); }
  Words corpus() const { return {"--corpus", in("corpus")}; }
  Words subject() const { return {"--subject-command", wrong}; }
  Words as_oracle() const { return {"--subject", "clip", "--oracle-command", wrong}; }
  Words few() const { return {"--regime", "boxes", "--seed", "1", "--cases", "200"}; }
};

Outcome ask(const Bench& bench, const std::vector<Words>& parts) {
  Words all;
  for (const Words& part : parts) all = with(all, part);
  return run_program(with({"env", "GITHUB_ACTIONS=true", manifuzz_path()}, all),
                     text_of(bench.boxes));
}

/// A way to be told of a wrong answer.
struct Path {
  std::string command;
  std::string mode;
  std::function<Outcome(const Bench&)> run;
  int status = 1;
  std::string said;  ///< a part of what is said on either stream, or in the file that it writes
  std::string file{};
};

const std::vector<Path>& paths() {
  static const std::vector<Path> all = {
      {"fuzz", "the subject",
       [](const Bench& b) {
         return ask(b, {{"fuzz"}, b.subject(), b.few(), b.corpus()});
       },
       1, "new "},
      {"fuzz", "the oracle",
       [](const Bench& b) {
         return ask(b, {{"fuzz"}, b.as_oracle(), b.few(), b.corpus()});
       },
       1, "new "},
      {"fuzz", "an annotation",
       [](const Bench& b) {
         return ask(b, {{"fuzz"}, b.subject(), b.few(), b.corpus()});
       },
       1, "::error title=manifuzz fuzz"},
      {"fuzz", "JUnit",
       [](const Bench& b) {
         return ask(b, {{"fuzz", "--junit", b.in("run.xml")}, b.subject(), b.few(), b.corpus()});
       },
       1, "<failure", "run.xml"},
      {"fuzz", "JSON",
       [](const Bench& b) {
         return ask(b, {{"fuzz", "--json", b.in("run.json")}, b.subject(), b.few(), b.corpus()});
       },
       1, "subject_wrong", "run.json"},
      {"fuzz", "--until-new",
       [](const Bench& b) {
         return ask(b, {{"fuzz", "--until-new"}, b.subject(), b.few(), b.corpus()});
       },
       1, "new "},
      {"fuzz", "--share",
       [](const Bench& b) {
         return ask(b, {{"fuzz", "--share", "0/2"}, b.subject(), b.few(), b.corpus()});
       },
       1, "new "},
      {"fuzz", "a baseline that has nothing of it",
       [](const Bench& b) {
         ask(b, {{"fuzz", "--subject", "clip64", "--oracle", "clip", "--no-save", "--json",
                  b.in("before.json")},
                 b.few()});
         return ask(b,
                    {{"fuzz", "--no-save", "--oracle", "clip", "--baseline", b.in("before.json")},
                     b.subject(),
                     b.few()});
       },
       1, "new"},
      {"fuzz", "sequences",
       [](const Bench& b) {
         return ask(b, {{"fuzz", "--sequences", "--regime", "turning_platform", "--seed", "1",
                         "--cases", "50", "--no-save", "--subject-command",
                         std::string(MANIFUZZ_TEST_KEEPING_PROGRAM) + " stale"},
                        b.corpus()});
       },
       1, "new "},
      {"hunt", "the subject",
       [](const Bench& b) {
         return ask(b, {{"hunt"}, b.subject(), b.few(), b.corpus()});
       },
       1, "new "},
      {"hunt", "JSON",
       [](const Bench& b) {
         return ask(b, {{"hunt", "--json", b.in("run.json")}, b.subject(), b.few(), b.corpus()});
       },
       1, "subject_wrong", "run.json"},
      {"replay", "the subject",
       [](const Bench& b) {
         return ask(b, {{"replay", b.boxes}, b.subject()});
       },
       1, "FAIL "},
      {"replay", "JUnit",
       [](const Bench& b) {
         return ask(b, {{"replay", b.boxes, "--junit", b.in("run.xml")}, b.subject()});
       },
       1, "<failure", "run.xml"},
      {"replay", "JSON",
       [](const Bench& b) {
         return ask(b, {{"replay", b.boxes, "--json", b.in("run.json")}, b.subject()});
       },
       1, "\"failed\": 1", "run.json"},
      {"replay", "an annotation",
       [](const Bench& b) {
         return ask(b, {{"replay", b.boxes}, b.subject()});
       },
       1, "::error title=manifuzz replay"},
      {"property", "the subject",
       [](const Bench& b) {
         return ask(b, {{"property", "--cases", "50", "--seed", "1"}, b.subject(), b.corpus()});
       },
       1, "FAIL"},
      {"property", "--hunt",
       [](const Bench& b) {
         return ask(
             b, {{"property", "--hunt", "--cases", "50", "--seed", "1"}, b.subject(), b.corpus()});
       },
       1, "FAIL"},
      {"property", "--hunt, JUnit",
       [](const Bench& b) {
         return ask(
             b, {{"property", "--hunt", "--cases", "50", "--seed", "1", "--junit", b.in("run.xml")},
                 b.subject(),
                 b.corpus()});
       },
       1, "<failure", "run.xml"},
      {"property", "JUnit",
       [](const Bench& b) {
         return ask(b, {{"property", "--cases", "50", "--seed", "1", "--junit", b.in("run.xml")},
                        b.subject(),
                        b.corpus()});
       },
       1, "<failure", "run.xml"},
      {"init", "what it accepts",
       [](const Bench& b) {
         return ask(b, {{"init", b.in("begun"), "--cases", "500"}, b.subject()});
       },
       0, "wrong in "},
      {"smoke", "the subject",
       [](const Bench& b) {
         return ask(
             b, {{"smoke", "--seconds", "3", "--seed", "1", "--no-save"}, b.subject(), b.corpus()});
       },
       1, "FAIL"},
      {"judge", "the subject",
       [](const Bench& b) {
         return ask(b, {{"judge", b.boxes}, b.subject()});
       },
       1, "_wrong"},
      {"judge", "the oracle",
       [](const Bench& b) {
         return ask(b, {{"judge", b.boxes}, b.as_oracle()});
       },
       1, "_wrong"},
      {"judge", "answers in a file",
       [](const Bench& b) {
         const std::string answers = b.folder.write(
             "answers.jsonl",
             "{\"points\": [{\"position\": [500,0], \"depth\": 3}], \"normal\": [1,0]}\n");
         return ask(b, {{"judge", "--subject", "clip", "--manifolds", answers, b.boxes}});
       },
       1, "_wrong"},
      {"merge", "JSON of two runs",
       [](const Bench& b) {
         ask(b, {{"fuzz", "--no-save", "--json", b.in("one.json")}, b.subject(), b.few()});
         return ask(
             b, {{"merge", b.in("one.json"), "--output", b.in("all"), "--json", b.in("all.json")}});
       },
       0, "subject_wrong", "all.json"},
      {"show", "the verdict",
       [](const Bench& b) {
         return ask(b, {{"show", b.boxes}, b.subject()});
       },
       0, "wrong"},
      {"shrink", "a folder's findings stay findings",
       [](const Bench& b) {
         return ask(b, {{"shrink", b.boxes, "--output", b.in("small.json")}, b.subject()});
       },
       0, "subject_wrong", "small.json"},
  };
  return all;
}

/// Commands that report no wrong answer, and where what they report is planted.
const std::map<std::string_view, std::string_view> kNoPath{
    {"accept", "it marks findings of others"},
    {"bench", "it measures; its referee is held in unit/measure"},
    {"collide", "it prints answers"},
    {"conformance", "it asks no collider; the checkers of its cases are held against the judge"},
    {"digest", "it hashes answers; other hashes are everywhere/check's to tell"},
    {"generate", "it asks nobody"},
    {"list", "it asks nobody"},
    {"report", "it shows what others found; page/ holds that"},
    {"scene", "its mismatches are planted in canary/scene"},
    {"stress", "its breaking points are planted in unit/cli/stress_baseline_test"}};

}  // namespace

TEST_CASE("every path on which a wrong answer can be reported reports a planted one") {
  for (const Path& path : paths()) {
    CAPTURE(path.command, path.mode);
    const Bench bench;
    const Outcome outcome = path.run(bench);
    CAPTURE(outcome.out, outcome.err);
    CHECK(outcome.status == path.status);
    const std::string told = path.file.empty()
                                 ? outcome.out + outcome.err
                                 : text_of(std::filesystem::path(bench.in(path.file)));
    CHECK_THAT(told, Catch::Contains(path.said));
  }
}

TEST_CASE("every command has a path there, or a reason why it has none") {
  std::set<std::string_view> known;
  for (const Path& path : paths()) known.insert(path.command);
  for (const auto& [command, reason] : kNoPath) {
    CAPTURE(command, reason);
    CHECK(known.insert(command).second);
  }
  for (const Command& command : commands()) {
    CAPTURE(command.name);
    CHECK(known.erase(command.name) == 1);
  }
  CHECK(known.empty());
}

TEST_CASE("every engine that is installed reports, and is reported, as subject and as oracle") {
  for (const ColliderEntry& entry : colliders()) {
    const auto collider = installed_collider(entry.name);
    if (!collider) continue;
    CAPTURE(entry.name);
    const Bench bench;
    const auto buckets_of = [&](const Words& colliders) {
      const Outcome outcome = ask(bench, {{"fuzz", "--no-save", "--json", "-", "--regime", "boxes",
                                           "--radius", "0", "--seed", "1", "--cases", "60"},
                                          colliders,
                                          bench.corpus()});
      CAPTURE(outcome.err);
      CHECK(outcome.status == 1);
      std::set<std::string> faults;
      const Json json = Json::parse(outcome.out.substr(outcome.out.find('{')));
      for (const Json& bucket : json.at("buckets")) {
        const std::string name = bucket.at("bucket");
        faults.insert(name.substr(0, name.find('/')));
      }
      return faults;
    };
    const std::string name(entry.name);
    const auto of_subject = buckets_of({"--subject-command", bench.wrong, "--oracle", name});
    CHECK((of_subject.contains("subject") || of_subject.contains("both")));
    const auto of_oracle = buckets_of({"--subject", name, "--oracle-command", bench.wrong});
    CHECK((of_oracle.contains("oracle") || of_oracle.contains("both")));
  }
}
