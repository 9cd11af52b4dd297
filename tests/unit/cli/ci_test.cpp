#include <algorithm>
#include <filesystem>
#include <iterator>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "support/interruption.hpp"
#include "support/run_program.hpp"
#include "support/source_tree.hpp"
#include "support/temporary_folder.hpp"
#include "unit/report/svg_reader.hpp"

using namespace manifuzz::test;
using Catch::Contains;

namespace {

const char* const kWitness = "witness-box2d-no-contact-under-bias";

/// A repository of one case, which Box2D gets wrong, with its picture; and a step of a workflow.
struct Step {
  TemporaryFolder folder;
  std::filesystem::path corpus = folder.path() / "corpus";
  std::filesystem::path summary = folder.path() / "summary.md";

  Step() {
    std::filesystem::create_directory(corpus);
    for (const char* const extension : {".json", ".svg"}) {
      const std::string name = kWitness + std::string(extension);
      std::filesystem::copy(source_dir() / "corpus/defects/box2d" / name, corpus / name);
    }
  }
  std::string witness() const { return (corpus / (kWitness + std::string(".json"))).string(); }
  std::string junit() const { return (folder.path() / "junit.xml").string(); }

  Outcome run(const std::vector<std::string>& arguments) const {
    const std::vector<std::string> command{"env",
                                           "GITHUB_ACTIONS=true",
                                           "GITHUB_STEP_SUMMARY=" + summary.string(),
                                           "GITHUB_WORKSPACE=" + folder.path().string(),
                                           "GITHUB_SERVER_URL=https://github.com",
                                           "GITHUB_REPOSITORY=me/engine",
                                           "GITHUB_SHA=abc123",
                                           manifuzz_path()};
    return run_program(with(command, arguments));
  }
};

std::vector<std::string> broken_replay(const Step& step) {
  return {"replay", step.corpus.string(), "--subject", "box2d", "--oracle", "clip"};
}

}  // namespace

TEST_CASE("a workflow that breaks a case shows it: annotation, picture, command") {
  const Step step;
  const Outcome outcome = step.run(broken_replay(step));
  CHECK(outcome.status == 1);
  CHECK(outcome.err.empty());
  const std::vector<std::string> lines = lines_of(outcome.out);
  REQUIRE(lines.size() == 3);
  CHECK_THAT(lines[0], Catch::StartsWith("FAIL "));
  CHECK_THAT(lines[1], Contains("1 case, 0 passed, 1 failed"));
  CHECK_THAT(lines[2], Catch::StartsWith("::error title=manifuzz replay%3A ") &&
                           Contains(",file=corpus/witness-box2d-no-contact-under-bias.json::"));
  const std::string summary = text_of(step.summary);
  CHECK_THAT(summary, Contains("## manifuzz replay: 1 of 1 failed"));
  CHECK_THAT(summary, Contains("A solid, B dotted"));
  CHECK_THAT(summary, Contains("S box2d: no contact"));
  CHECK_THAT(summary,
             Contains(std::string("![the case](https://github.com/me/engine/raw/abc123/corpus/") +
                      kWitness + ".svg)"));
  CHECK_THAT(summary, Contains(" --subject box2d --oracle clip\n```"));
}

TEST_CASE("summaries of one step follow each other, and one that passes is short") {
  const Step step;
  CHECK(step.run({"replay", step.corpus.string()}).status == 0);
  const std::string first = text_of(step.summary);
  CHECK_THAT(first, Contains("manifuzz replay: passed") && !Contains("###"));
  step.run({"replay", step.corpus.string()});
  CHECK(text_of(step.summary).size() == 2 * first.size());
}

TEST_CASE("annotations leave the data on stdout alone") {
  const Step step;
  const Outcome outcome = step.run(with(broken_replay(step), {"--json", "-"}));
  CHECK(nlohmann::json::parse(outcome.out)["failed"] == 1);
  CHECK_THAT(outcome.err, Catch::StartsWith("::error title="));
}

TEST_CASE("a summary that cannot be written is an error line, and no result is lost") {
  Step step;
  step.summary = step.folder.path() / "no" / "such" / "folder";
  const Outcome outcome = step.run(with(broken_replay(step), {"--junit", step.junit()}));
  CHECK(outcome.status == 1);
  CHECK(is_one_clear_line(outcome.err));
  CHECK_THAT(outcome.err, Contains("cannot write the step summary"));
  CHECK_THAT(outcome.out, Contains("::error"));
  CHECK(read_svg(text_of(step.junit())).size() == 4);
}

TEST_CASE("outside a workflow there are no annotations") {
  const Step step;
  const Outcome outcome = run_program(with({manifuzz_path()}, broken_replay(step)));
  CHECK(outcome.status == 1);
  CHECK(lines_of(outcome.out).size() == 2);
  CHECK(outcome.err.empty());
}

TEST_CASE("fuzz writes a test for each regime, and one for each bucket that decides its status") {
  const Step step;
  const std::vector<std::string> campaign{
      "fuzz", "--regime", "tie_bias",           "--regime",  "boxes",   "--seed",    "1", "--cases",
      "4000", "--corpus", step.corpus.string(), "--no-save", "--junit", step.junit()};
  CHECK(run_manifuzz(campaign).status == 0);
  auto elements = read_svg(text_of(step.junit()));
  REQUIRE(elements.size() == 4);
  CHECK(elements[2].attributes.at("name") == "tie_bias");
  CHECK(elements[3].attributes.at("name") == "boxes");

  const Outcome wrong = step.run(with(campaign, {"--subject", "box2d", "--oracle", "clip"}));
  CHECK(wrong.status == 1);
  elements = read_svg(text_of(step.junit()));
  CHECK(elements[1].attributes.at("failures") != "0");
  CHECK_THAT(elements[2].attributes.at("name"), Catch::StartsWith("subject/subject_wrong/"));
  CHECK(elements[3].name == "failure");
  CHECK_THAT(elements[3].text, Contains(" --first ") && Contains("A solid, B dotted"));
  const auto regime = std::find_if(elements.begin(), elements.end(), [](const Element& element) {
    return element.name == "testcase" && element.attributes.at("name") == "tie_bias";
  });
  REQUIRE(regime != elements.end());
  CHECK_THAT((regime + 1)->attributes.at("message"), Contains("cases against it"));
  CHECK_THAT(text_of(step.summary), Contains("| subject\\_wrong | "));
}

TEST_CASE("property writes a test for each property, with what breaks it and how to repeat it") {
  const Step step;
  const std::string blind = step.folder.write(
      "blind.sh", "#!/bin/sh\nwhile read -r line; do echo '{\"points\": []}'; done\n");
  const Outcome outcome =
      step.run({"property", "swapping-mirrors", "never-empty", "--subject-command", "sh " + blind,
                "--seed", "1", "--cases", "100", "--no-save", "--corpus", step.corpus.string(),
                "--junit", step.junit()});
  CAPTURE(outcome.out, outcome.err);
  CHECK(outcome.status == 1);
  const auto elements = read_svg(text_of(step.junit()));
  REQUIRE(elements.size() == 5);
  CHECK(elements[1].attributes.at("tests") == "2");
  CHECK(elements[1].attributes.at("failures") == "1");
  CHECK(elements[2].attributes.at("name") == "swapping-mirrors");
  CHECK(elements[3].attributes.at("name") == "never-empty");
  CHECK_THAT(elements[4].attributes.at("message"), Contains("no contact for an overlap of {"));
  CHECK_THAT(elements[4].text, Contains("A solid, B dotted"));
  const std::string command = lines_of(elements[4].text).at(1);
  CHECK_THAT(command, Catch::StartsWith("RC_PARAMS="));
  CHECK_THAT(run_program({"bash", "-c", command + " --no-save"}).out, Contains("FAIL never-empty"));
  CHECK_THAT(text_of(step.summary), Contains("## manifuzz property: 1 of 2 failed"));
}

TEST_CASE("CI is told of files that cannot be read, and the result of the others") {
  Step step;
  step.folder.write("corpus/broken.json", "{");
  for (const std::vector<std::string>& command :
       {std::vector<std::string>{"replay", step.corpus},
        {"smoke", "--seconds", "3", "--seed", "1", "--no-save", "--corpus", step.corpus}}) {
    std::filesystem::remove(step.summary);
    const Outcome outcome = step.run(with(command, {"--junit", step.junit()}));
    CAPTURE(command[0], outcome.err);
    CHECK(outcome.status == 2);
    const auto elements = read_svg(text_of(step.junit()));
    CHECK(elements[0].attributes.at("errors") == "1");
    CHECK(elements[1].attributes.at("tests") == "2");
    CHECK_THAT(outcome.out, Contains("::error title=manifuzz replay::") && Contains("broken.json"));
    CHECK_THAT(text_of(step.summary), Contains("## manifuzz replay: 1 error\n"));
  }
}

TEST_CASE("CI is told why a command did nothing") {
  const Step step;
  step.folder.write("corpus/broken.json", "{");
  for (const std::vector<std::string>& command :
       {std::vector<std::string>{"replay", "nowhere.json"},
        {"property", "--corpus", step.corpus},
        {"fuzz", "--corpus", step.corpus},
        {"fuzz", "--subject", "./no-such-library.so"},
        {"smoke", "--seconds", "3", "--corpus", step.corpus, "--oracle", "./no-such-library.so"}}) {
    const Outcome outcome = step.run(with(command, {"--junit", step.junit()}));
    CAPTURE(command[0], outcome.err);
    CHECK(outcome.status == 2);
    CHECK_THAT(outcome.out, Contains("::error title=manifuzz " + command[0] + "::"));
    const auto elements = read_svg(text_of(step.junit()));
    CHECK(elements[0].attributes.at("errors") == "1");
    CHECK(elements[1].attributes.at("name") == "manifuzz " + command[0]);
    std::filesystem::remove(step.junit());
  }
}

TEST_CASE("a smoke run that is short of time passes") {
  const Step step;
  const Outcome outcome =
      step.run({"smoke", "--seconds", "0.01", "--seed", "1", "--no-save", "--corpus", step.corpus});
  CHECK(outcome.status == 0);
}

TEST_CASE("a smoke run that is interrupted says so, and does not pass") {
  // The subject is asked for the replay, then for properties; the oracle not again before the
  // campaign.
  for (const auto& [option, nth] :
       {std::pair("--subject-command", 1), {"--subject-command", 30}, {"--oracle-command", 300}}) {
    const Step step;
    const Outcome stopped =
        run_interruptible({"smoke", "--seed", "1", "--no-save", "--corpus", step.corpus, "--junit",
                           step.junit(), option, interrupting_clip(step.folder, nth)});
    CAPTURE(option, nth, stopped.err);
    // On a busy machine an answer may have been late before, which is something found.
    CHECK((stopped.status == 130 || stopped.status == 1));
    CHECK_THAT(stopped.err, Contains("smoke: interrupted before it was done"));
    CHECK(read_svg(text_of(step.junit()))[0].attributes.at("errors") == "1");
  }
}

TEST_CASE("a report may go to the standard output, which then has nothing else") {
  const Step step;
  for (const std::vector<std::string>& command :
       {std::vector<std::string>{"replay", step.corpus},
        {"property", "never-empty", "--cases", "10", "--seed", "1", "--corpus", step.corpus},
        {"smoke", "--seconds", "0.01", "--seed", "1", "--no-save", "--corpus", step.corpus},
        {"fuzz", "--cases", "20", "--seed", "1", "--no-save", "--corpus", step.corpus}}) {
    const Outcome outcome = run_manifuzz(with(command, {"--junit", "-"}));
    CAPTURE(command[0], outcome.err);
    CHECK(outcome.status == 0);
    CHECK_THAT(outcome.out, Catch::StartsWith("<?xml") && Catch::EndsWith("</testsuites>\n"));
    CHECK(read_svg(outcome.out)[0].name == "testsuites");
  }
}

TEST_CASE("CI is told of outputs that could not be written") {
  const Step step;
  const std::string full = "/dev/full";
  const std::vector<std::string> campaign{"fuzz", "--cases",   "20",       "--seed",
                                          "1",    "--no-save", "--corpus", step.corpus};
  for (const std::vector<std::string>& command :
       {std::vector<std::string>{"replay", step.corpus, "--json", full},
        with(campaign, {"--json", full}), with(campaign, {"--report", full})}) {
    const Outcome outcome = step.run(with(command, {"--junit", step.junit()}));
    CAPTURE(command[0], command.back());
    CHECK(outcome.status == 2);
    const auto elements = read_svg(text_of(step.junit()));
    CHECK(elements[0].attributes.at("errors") == "1");
    CHECK(elements[0].attributes.at("tests") != "1");
    CHECK_THAT(outcome.out, Contains("No space left on device"));
  }
}

TEST_CASE("CI is told of outputs that cannot be made, and nothing is run for them") {
  const Step step;
  const std::string folder = step.folder.path().string();
  for (const std::vector<std::string>& command :
       {std::vector<std::string>{"replay", step.corpus, "--json", folder},
        {"fuzz", "--cases", "20", "--corpus", step.corpus, "--report", folder}}) {
    const Outcome outcome = step.run(with(command, {"--junit", step.junit()}));
    CAPTURE(command[0], outcome.err);
    CHECK(outcome.status == 2);
    CHECK(is_one_clear_line(outcome.err));
    const auto elements = read_svg(text_of(step.junit()));
    CHECK(elements[0].attributes.at("errors") == "1");
    CHECK(elements[0].attributes.at("tests") == "1");
    CHECK_THAT(outcome.out, Contains("is a folder; a file is expected"));
  }
}

TEST_CASE("what was found before somebody interrupted is told") {
  for (const std::vector<std::string>& command :
       {std::vector<std::string>{"property", "never-empty", "swapping-mirrors", "--cases",
                                 "100000"},
        {"smoke"}}) {
    const Step step;
    const Outcome outcome = run_interruptible(
        with(command, {"--subject-command", interrupting_blind(step.folder, 100), "--seed", "1",
                       "--no-save", "--corpus", step.corpus, "--junit", step.junit()}));
    CAPTURE(command[0], outcome.err);
    CHECK(outcome.status == 1);  // what was found
    CHECK_THAT(outcome.err, Contains("interrupted before it was done"));
    const auto elements = read_svg(text_of(step.junit()));
    CHECK(elements[0].attributes.at("failures") == "1");
    CHECK(elements[0].attributes.at("errors") == "1");
  }
}
