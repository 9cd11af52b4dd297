#include <filesystem>
#include <pugixml.hpp>
#include <string>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "support/run_program.hpp"
#include "support/source_tree.hpp"
#include "support/temporary_folder.hpp"

// scripts/engines --results and --history over the built manifuzz.

using namespace manifuzz::test;
using Catch::Contains;
using Json = nlohmann::json;

namespace {

Json json_in(const std::filesystem::path& path) {
  return Json::parse(text_of(path));
}

Outcome engines(const std::vector<std::string>& arguments,
                const std::vector<std::string>& environment = {}) {
  return run_program(with(with(with({"env", "MANIFUZZ=" + manifuzz_path()}, environment),
                               {(source_dir() / "scripts/engines").string()}),
                          arguments));
}

/// What fuzz counts of an oracle in 3,000 cases of seed 7.
Json counted(const std::string& oracle, const TemporaryFolder& folder) {
  const std::string file = (folder.path() / "fuzz.json").string();
  const Outcome outcome = run_program({"env", "-C", source_dir().string(), manifuzz_path(), "fuzz",
                                       "--subject", "clip64", "--oracle", oracle, "--cases", "3000",
                                       "--seed", "7", "--no-save", "--quiet", "--json", file});
  REQUIRE(outcome.status <= 1);
  return json_in(file);
}

int sum_of(const Json& counts) {
  int sum = 0;
  for (const auto& [kind, count] : counts.items()) sum += count.get<int>();
  return sum;
}

int wrong_of(const Json& verdicts) {
  int sum = 0;
  for (const char* const verdict :
       {"known", "oracle_wrong", "both_wrong", "crashed", "timed_out", "malformed"}) {
    sum += verdicts.at(verdict).get<int>();
  }
  return sum;
}

/// The two texts that a badge shows, and its title; fails where it is no well-formed SVG, or where
/// a text is wider than its field.
struct Badge {
  std::string name, message, title;
};

Badge badge_in(const std::filesystem::path& path) {
  pugi::xml_document document;
  REQUIRE(document.load_file(path.c_str()));
  const pugi::xml_node svg = document.child("svg");
  const auto texts = svg.child("g").children("text");
  std::vector<std::string> shown;
  double used = 0;
  for (const pugi::xml_node& text : texts) {
    shown.emplace_back(text.child_value());
    used += text.attribute("textLength").as_double();
    CHECK(text.attribute("textLength").as_double() > 4 * static_cast<double>(shown.back().size()));
  }
  REQUIRE(shown.size() == 2);
  CHECK(used < svg.attribute("width").as_double());
  CHECK(svg.attribute("aria-label").value() == shown[0] + ": " + shown[1]);
  return {shown[0], shown[1], svg.child("title").child_value()};
}

/// A folder of engines with one, `tiny`, whose releases npm's stand-in serves: 1.0.0 answers
/// rightly, 1.1.0 is not to be had, 2.0.0 turns its normals about. 3.0.0 is newer than what is
/// pinned.
class TinyEngine {
 public:
  TinyEngine() {
    std::filesystem::create_directories(folder_.path() / "oracle/tiny");
    folder_.write("oracle/tiny/engine.json", R"({"version": "2.0.0", "colliders": [
      {"name": "behaving", "description": "a stand-in", "command": "sh @/adapter"}]})");
    folder_.write("oracle/tiny/package.json", R"({"dependencies": {"tiny": "2.0.0"}})");
    folder_.write("oracle/tiny/adapter", "exec '" MANIFUZZ_TEST_PROGRAM
                                         "' $(cat \"$(dirname \"$0\")/node_modules/behaviour\")\n");
    const std::string npm = folder_.write("npm", R"(#!/bin/sh
echo "$*" >>"$0.asked"
case "$*" in
  "view tiny versions --json") echo '["1.0.0", "1.1.0", "2.0.0-beta.1", "2.0.0", "3.0.0"]' ;;
  "view tiny@"*) echo "${2#*@}" ;;
  *" install "*@1.1.0) echo "error: 1.1.0 was withdrawn" >&2; exit 1 ;;
  *" install "*) for last; do :; done; echo "{\"dependencies\": {\"tiny\": \"${last#*@}\"}}" >"$2/package.json" ;;
  *" ci "*) mkdir "$2/node_modules"
    if grep -q 2.0.0 "$2/package.json"; then echo reversed; else echo separation; fi >"$2/node_modules/behaviour" ;;
  *) exit 1 ;;
esac
)");
    std::filesystem::permissions(npm, std::filesystem::perms::owner_all);
  }

  Outcome history(const std::vector<std::string>& arguments) const {
    return engines(with({"--history"}, with(arguments, {"--cases", "500", "--seed", "7",
                                                        "--results", results().string()})),
                   {"MANIFUZZ_ENGINES_FOLDER=" + (folder_.path() / "oracle").string(),
                    "PATH=" + folder_.path().string() + ":" + std::getenv("PATH")});
  }

  std::filesystem::path results() const { return folder_.path() / "results"; }
  std::string asked_of_npm() const { return text_of(folder_.path() / "npm.asked"); }
  std::string kept() const { return text_of(folder_.path() / "oracle/tiny/package.json"); }

 private:
  TemporaryFolder folder_;
};

}  // namespace

TEST_CASE("results.json and badges have what fuzz counts of each collider that is asked") {
  const TemporaryFolder folder;
  const std::filesystem::path results = folder.path() / "results";
  const Outcome outcome =
      engines({"--only", "clip", "--only", "box2d", "--results", results.string(), "3000", "7"});
  REQUIRE(outcome.status == 0);
  const Json written = json_in(results / "results.json");
  CHECK(written.at("format") == "manifuzz/results/1");
  CHECK(written.at("cases") == 3000);
  CHECK(written.at("seed") == 7);
  REQUIRE(written.at("engines").size() == 2);

  const Json& clip = written["engines"][0];
  CHECK(clip.at("collider") == "clip");
  CHECK(sum_of(clip.at("wrong")) == 0);
  const Badge of_clip = badge_in(results / "badges/clip.svg");
  CHECK(of_clip.name == "manifuzz");
  CHECK(of_clip.message == "no wrong answer in 3000");

  const Json report = counted("box2d", folder);
  const Json& box2d = written["engines"][1];
  CHECK(box2d.at("collider") == "box2d");
  CHECK(box2d.at("engine") == "box2d");
  CHECK(box2d.at("version") == report.at("versions").at("box2d"));
  const int wrong = wrong_of(report.at("verdicts"));
  REQUIRE(wrong > 0);
  CHECK(sum_of(box2d.at("wrong")) == wrong);
  CHECK(box2d.at("explained") == report.at("verdicts").at("known"));
  CHECK(box2d.at("unexplained") == report.at("unexplained"));
  for (const auto& [kind, count] : box2d.at("wrong").items()) {
    CAPTURE(kind);
    CHECK(box2d.at("wrong_in_a_million").at(kind).get<double>() ==
          Approx(count.get<double>() * 1e6 / 3000));
    CHECK_THAT(outcome.out, Contains(kind + " " + count.dump()));
  }
  CHECK(box2d.at("ns").get<double>() > 0);
  const Badge of_box2d = badge_in(results / "badges/box2d.svg");
  CHECK(std::stod(of_box2d.message) == Approx(100.0 * wrong / 3000).epsilon(0.05));
  CHECK_THAT(of_box2d.message, Contains("% wrong, all explained"));
  CHECK_THAT(of_box2d.title, Contains(", " + std::to_string(wrong) + " wrong answers, 0 unexpl"));
}

TEST_CASE("what results are asked with is checked") {
  for (const std::vector<std::string>& wrong : {std::vector<std::string>{"--only", "nobody"},
                                                {"--results"},
                                                {"many"},
                                                {"--only"},
                                                {"--history", "nobody"},
                                                {"--history", "planck", "--cases", "0"}}) {
    CAPTURE(wrong);
    const Outcome outcome = engines(wrong);
    CHECK(outcome.status == 2);
    CHECK(is_one_clear_line(outcome.err));
  }
}

TEST_CASE("a history tells which fault came with which release, and why one was not asked") {
  const TinyEngine tiny;
  const std::string before = tiny.kept();
  const Outcome outcome = tiny.history({"behaving"});
  INFO(outcome.err);
  REQUIRE(outcome.status == 0);
  CHECK(tiny.kept() == before);
  const Json releases = json_in(tiny.results() / "history.json").at("engines").at(0).at("releases");
  REQUIRE(releases.size() == 3);
  CHECK(releases[0].at("version") == "1.0.0");
  CHECK(releases[0].at("faults") == Json::object());
  CHECK_FALSE(releases[0].contains("changes"));
  CHECK(releases[1].at("version") == "1.1.0");
  CHECK_THAT(releases[1].at("reason").get<std::string>(), Contains("1.1.0 was withdrawn"));
  CHECK(releases[2].at("version") == "2.0.0");
  CHECK(releases[2].at("since") == "1.0.0");
  const Json& change = releases[2].at("kind_changes").at(0);
  CHECK(change.at("fault") == "reversed");
  CHECK(change.at("change") == "came");
  CHECK(change.at("before") == 0);
  CHECK(change.at("now") == releases[2].at("wrong").at("reversed"));
  CHECK(change.at("now").get<int>() > 100);
  CHECK(releases[2].at("changes").at(0).at("fault") == "unexplained");
  CHECK(releases[2].at("changes").at(0).at("now") == releases[2].at("unexplained"));
  CHECK_THAT(outcome.out, Contains("behaving 2.0.0: came the kind reversed, 0 before, " +
                                   change.at("now").dump() + " now"));

  const std::string page = text_of(tiny.results() / "history.html");
  CHECK_THAT(page, Contains("<b>came</b> <span>reversed</span>"));
  CHECK_THAT(page, Contains("1.1.0 was withdrawn"));

  // What was asked is kept, what was not is tried again.
  const std::size_t asked = tiny.asked_of_npm().size();
  const std::string first = text_of(tiny.results() / "history.json");
  CHECK(tiny.history({}).status == 0);
  CHECK_THAT(tiny.asked_of_npm().substr(asked), Contains("tiny@1.1.0"));
  CHECK_THAT(tiny.asked_of_npm().substr(asked), !Contains(" ci "));
  CHECK(text_of(tiny.results() / "history.json") == first);
}
