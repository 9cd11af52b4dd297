#include <filesystem>

#include <catch2/catch.hpp>

#include "support/run_program.hpp"
#include "support/source_tree.hpp"
#include "support/temporary_folder.hpp"

using namespace manifuzz::test;
using Catch::Contains;

namespace {

namespace fs = std::filesystem;

/// A folder with a corpus of one case.
struct OneCase {
  TemporaryFolder folder;
  fs::path corpus = folder.path() / "corpus";
  fs::path witness = corpus / "witness.json";

  OneCase() {
    fs::create_directory(corpus);
    fs::copy(source_dir() / "corpus/defects/box2d/witness-box2d-no-contact-under-bias.json",
             witness);
  }
  std::string path(const std::string& name) const { return (folder.path() / name).string(); }
};

/// Refused at once, in one line, with status 2.
void check_refused(const std::vector<std::string>& command, const std::string& why) {
  const Outcome outcome = run_manifuzz(command);
  CAPTURE(command, outcome.err);
  CHECK(outcome.status == 2);
  CHECK(outcome.out.empty());
  CHECK(is_one_clear_line(outcome.err));
  CHECK_THAT(outcome.err, Contains(why));
}

std::vector<std::string> brief_campaign(const OneCase& given) {
  return {"fuzz", "--seed", "1", "--cases", "20", "--corpus", given.corpus.string()};
}

}  // namespace

TEST_CASE("two outputs may not be one file, however it is spelled or linked") {
  const OneCase given;
  fs::create_directory(given.path("a"));
  fs::create_directory_symlink("a", given.path("b"));
  const std::string file = given.folder.write("file", "mine");
  fs::create_symlink("file", given.path("link"));
  fs::create_hard_link(file, given.path("hard"));
  for (const auto& [one, other] :
       {std::pair("a/new", "a/./new"), {"a/new", "b/new"}, {"file", "link"}, {"file", "hard"}}) {
    CAPTURE(one, other);
    check_refused(
        with(brief_campaign(given), {"--json", given.path(one), "--report", given.path(other)}),
        "--report: --json writes to ");
  }
  check_refused(
      {"bench", "--quick", "--json", given.path("a/new.svg"), "--picture", given.path("b/new.svg")},
      "--picture: --json writes to ");
  check_refused(with(brief_campaign(given),
                     {"--json", given.path("new"), "--report", given.path("new/page.html")}),
                "--report: --json writes to ");
  CHECK(text_of(file) == "mine");
  CHECK_FALSE(fs::exists(given.path("a/new")));
}

TEST_CASE("no output takes the place of an input, however it is spelled or linked") {
  const OneCase given;
  const std::string before = text_of(given.witness);
  const std::string witness = given.witness.string();
  const std::string spelled = (given.corpus / ".." / "corpus" / "witness.json").string();
  const std::string link = given.path("link.svg");
  const std::string hard = given.path("hard.svg");
  fs::create_symlink(witness, link);
  fs::create_hard_link(witness, hard);
  for (const std::string& output : {spelled, link, hard}) {
    check_refused({"show", witness, "--svg", output}, "--svg: ");
    check_refused({"shrink", witness, "--output", output}, "--output: ");
    check_refused({"report", given.corpus, "--output", output}, "--output: ");
    check_refused({"replay", given.corpus, "--junit", output}, "--junit: ");
    check_refused(with(brief_campaign(given), {"--report", output}), "--report: ");
  }
  check_refused({"merge", given.corpus, "--output", (given.corpus / "all").string()},
                "whose cases are read");
  CHECK(text_of(given.witness) == before);
  CHECK_FALSE(fs::exists(given.corpus / "all"));
}

TEST_CASE("two outputs never go to one place, and none to what is read") {
  const OneCase given;
  const std::string one = (given.folder.path() / "one").string();
  const std::string same = (given.folder.path() / "." / "one").string();
  const std::string before = text_of(given.witness);
  for (const std::vector<std::string>& command :
       {std::vector<std::string>{"replay", given.corpus, "--json", "-", "--junit", "-"},
        {"replay", given.corpus, "--json", one, "--junit", same},
        {"replay", given.corpus, "--json", given.witness.string()},
        {"replay", given.corpus, "--junit", given.witness.string()},
        {"property", "--corpus", given.corpus, "--junit", given.witness.string()},
        {"smoke", "--corpus", given.corpus, "--junit", given.witness.string()},
        {"fuzz", "--corpus", given.corpus, "--report", given.witness.string()},
        {"fuzz", "--corpus", given.corpus, "--json", (given.corpus / "new" / "run.json").string()},
        {"replay", given.corpus, "--json", (given.corpus / ".." / "corpus" / "run.json").string()},
        {"show", given.witness.string(), "--svg", given.witness.string()},
        {"shrink", given.witness.string(), "--output", given.witness.string()}}) {
    const Outcome outcome = run_manifuzz(command);
    CAPTURE(command[0], outcome.err);
    CHECK(outcome.status == 2);
    CHECK(is_one_clear_line(outcome.err));
    CHECK(text_of(given.witness) == before);
    CHECK_FALSE(std::filesystem::exists(one));
  }
}

TEST_CASE("a baseline may be replaced by what is measured anew, and by nothing else") {
  const OneCase given;
  const std::string run = given.path("run.json");
  const auto campaign = with(brief_campaign(given), {"--no-save", "--quiet"});
  REQUIRE(run_manifuzz(with(campaign, {"--json", run})).status == 0);
  CHECK(run_manifuzz(with(campaign, {"--baseline", run, "--json", run})).status == 0);
  check_refused(with(campaign, {"--baseline", run, "--report", run}),
                "is one of the files that are read");
}

TEST_CASE("an output that cannot be made is told before anything is run") {
  const OneCase given;
  const std::string file = given.folder.write("file", "mine");
  const std::string too_long = given.path(std::string(300, 'x'));
  for (const std::string& folder : {file, file + "/below", too_long, std::string("/proc/corpus")}) {
    check_refused({"fuzz", "--seed", "1", "--cases", "20", "--corpus", folder}, "--corpus: ");
    check_refused({"stress", "--quick", "--pictures", folder}, "--pictures: ");
    check_refused({"merge", given.corpus, "--output", folder}, "--output: ");
  }
  const std::string folder = given.path("");
  for (const std::string& path : {folder, file + "/below", too_long, std::string("/proc/run")}) {
    check_refused(with(brief_campaign(given), {"--json", path}), "--json: ");
    check_refused({"replay", given.corpus, "--json", path}, "--json: ");
    check_refused({"show", given.witness, "--svg", path}, "--svg: ");
    check_refused({"report", given.corpus, "--output", path}, "--output: ");
  }
  check_refused({"show", given.witness, "--map", given.path("map.gif")}, "ends in .png");
  check_refused({"scene", "--frame", given.path("frame.png")}, "ends in .svg");
  check_refused({"bench", "--picture", given.path("p.gif")}, "ends in .svg or .png");
  CHECK(text_of(file) == "mine");
}

TEST_CASE("a folder for cases that cannot be made ends a campaign before its first case") {
  const OneCase given;
  const std::string asked = given.path("asked");
  const std::string program =
      given.folder.write("subject.sh", "while read -r line; do echo >>\"" + asked + "\"; done\n");
  check_refused({"fuzz", "--seed", "1", "--cases", "20", "--subject-command", "sh " + program,
                 "--corpus", given.folder.write("file", "") + "/corpus"},
                "cannot create the folder: Not a directory");
  CHECK_FALSE(fs::exists(asked));
  for (const std::string folder : {"sequences", "regressions"}) {
    const std::string corpus = given.path("corpus of " + folder);
    fs::create_directory(corpus);
    given.folder.write("corpus of " + folder + "/" + folder, "");
    check_refused({"fuzz", "--seed", "1", "--cases", "20", "--corpus", corpus},
                  folder + ": is no folder");
  }
}

TEST_CASE("what is tried is taken away again, and what was there stays") {
  const OneCase given;
  const std::string deep = given.path("new/and/deeper");
  check_refused(with(brief_campaign(given), {"--json", deep + "/run.json", "--report", deep}),
                "--report: ");
  check_refused({"fuzz", "--corpus", deep, "--json", "/proc/run.json"}, "--json: ");
  CHECK_FALSE(fs::exists(given.path("new")));
  const std::string link = given.path("link.html");
  fs::create_symlink(given.folder.write("page.html", "old"), link);
  CHECK(run_manifuzz({"report", given.corpus, "--maps", "0", "--quiet", "--output", link}).status ==
        0);
  CHECK(fs::is_symlink(link));
  CHECK(text_of(link) != "old");
}

TEST_CASE("a step summary that is another output is left out, and the run goes on") {
  const OneCase given;
  const std::string junit = given.path("junit.xml");
  fs::create_directory(given.path("a"));
  const Outcome outcome = run_program({"env", "GITHUB_ACTIONS=true",
                                       "GITHUB_STEP_SUMMARY=" + given.path("a/../junit.xml"),
                                       manifuzz_path(), "replay", given.corpus, "--junit", junit});
  CHECK(outcome.status == 0);
  CHECK(is_one_clear_line(outcome.err));
  CHECK_THAT(outcome.err, Contains("GITHUB_STEP_SUMMARY: "));
  CHECK_THAT(text_of(junit), Catch::StartsWith("<?xml"));
}
