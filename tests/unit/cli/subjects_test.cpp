#include <filesystem>
#include <unistd.h>

#include <catch2/catch.hpp>

#include "unit/cli/one_eyed.hpp"

using namespace manifuzz;
using namespace manifuzz::test;
using Catch::Contains;
using Catch::StartsWith;
namespace fs = std::filesystem;

namespace {

/// Replays the corpus, or a file of it, by the subjects that the cases name.
Outcome replay_as_named(const TemporaryFolder& folder, const std::vector<std::string>& paths = {}) {
  return run_manifuzz(
      with({"replay", "--json", "-"}, paths.empty() ? std::vector{corpus_in(folder)} : paths));
}

std::string named(const std::string& name, const std::string& command) {
  return Json({{name, {{"command", command}}}}).dump();
}

}  // namespace

TEST_CASE("replay asks the subject that a file names, by subjects.json in or beside the corpus") {
  const TemporaryFolder folder;
  const auto files = accept_findings(folder, one_eyed(folder));
  for (const char* where : {"corpus/subjects.json", "subjects.json"}) {
    CAPTURE(where);
    const std::string path = folder.write(where, named("one_eyed", one_eyed(folder)));
    const Outcome outcome = replay_as_named(folder);
    CHECK(outcome.status == 0);
    CHECK_THAT(outcome.err, Contains("one_eyed is sh ") && Contains(", as " + path + " says\n"));
    const Json run = json_of(outcome);
    CHECK(run["accepted"] == files.size());
    CHECK(run["subject"] == "one_eyed");
    CHECK(run["unasked"] == Json::array());
    fs::remove(path);
  }
}

TEST_CASE("nothing is started that stands beside a stranger's case, or is another user's") {
  const TemporaryFolder folder;
  const auto files = accept_findings(folder, one_eyed(folder));
  const std::string mark = (folder.path() / "started").string();
  const std::string starts = named("one_eyed", "touch '" + mark + "'; exit 3");
  folder.write("corpus/regressions/subjects.json", starts);
  folder.write("subjects.json", starts);
  for (const char* const command : {"show", "replay", "shrink"}) {
    CAPTURE(command);
    CHECK(run_manifuzz({command, files.front()}).status == 2);
    CHECK_FALSE(fs::exists(mark));
  }
  const std::string own = folder.write("corpus/subjects.json", starts);
  if (::chown(own.c_str(), 65534, 65534) != 0) return;  // only root can give a file away
  const Outcome outcome = replay_as_named(folder);
  CHECK(outcome.status == 2);
  CHECK_THAT(outcome.err, Contains(own + ": belongs to another user"));
  CHECK_FALSE(fs::exists(mark));
  const std::string mine = folder.write("mine.json", named("one_eyed", one_eyed(folder)));
  CHECK(run_manifuzz({"replay", corpus_in(folder), "--subjects", mine}).status == 0);
}

TEST_CASE("a file whose subject is not at hand is not asked, which is status 2, never a pass") {
  const TemporaryFolder folder;
  const auto files = save_findings(folder, one_eyed(folder));
  CHECK(run_manifuzz({"fuzz", "--ties", "--regime", "boxes", "--seed", "1", "--cases", "100",
                      "--shrink-seconds", "0", "--corpus", corpus_in(folder)})
            .status == 0);  // clip's cases are asked beside
  for (const std::string& subjects :
       {std::string("{}"), named("another", one_eyed(folder)), named("one_eyed", "exit 3"),
        named("one_eyed", "cat"), std::string(R"({"one_eyed": {"library": "./no-such.so"}})")}) {
    CAPTURE(subjects);
    folder.write("corpus/subjects.json", subjects);
    const Outcome outcome = replay_as_named(folder);
    CHECK(outcome.status == 2);
    const Json run = json_of(outcome);
    CHECK(run["failed"] == 0);
    CHECK(run["cases"] == files_of(folder).size() - files.size());
    REQUIRE(run["unasked"].size() == files.size());
    CHECK(run["unasked"][0]["subject"] == "one_eyed");
    CHECK(run["unasked"][0]["file"] == files.front());
  }
  const Outcome told = run_manifuzz({"replay", files.front()});
  CHECK_THAT(told.out, Contains("NOT ASKED " + files.front() + ": there is no collider one_eyed"));
  CHECK(lines_of(told.out).size() == 2);
  CHECK(lines_of(told.out).back() == "1 not asked");
  const Outcome junit = run_manifuzz({"replay", files.front(), "--junit", "-"});
  CHECK_THAT(junit.out, Contains("errors=\"1\"") && Contains("there is no collider one_eyed"));
}

TEST_CASE("a subject that is given is asked of every file, whoever that names") {
  const TemporaryFolder folder;
  const auto files = save_findings(folder, one_eyed(folder));
  folder.write("corpus/subjects.json", "{}");
  const Outcome outcome =
      run_manifuzz({"replay", corpus_in(folder), "--subject", "clip", "--json", "-"});
  CHECK(outcome.status == 0);
  CHECK(json_of(outcome)["passed"] == files.size());
}

TEST_CASE("show asks the collider that a file names, by subjects.json, and says where it cannot") {
  const TemporaryFolder folder;
  const std::string file = save_findings(folder, one_eyed(folder)).front();
  const std::string subjects = folder.write("subjects.json", named("one_eyed", one_eyed(folder)));
  const Outcome shown = run_manifuzz({"show", file, "--corpus", corpus_in(folder)});
  CHECK(shown.status == 0);
  CHECK_THAT(shown.out, Contains("subject: one_eyed 1") && Contains("oracle: box2d "));
  CHECK_THAT(run_manifuzz({"show", file, "--subject", "clip64"}).out, Contains("subject: clip64 "));
  const auto refused = [&](const std::string& complaint) {
    const Outcome outcome = run_manifuzz({"show", file, "--corpus", corpus_in(folder), "--quiet"});
    CHECK(outcome.status == 2);
    const std::vector<std::string> said = lines_of(outcome.err);  // what is started comes first
    CHECK(said.size() <= 2);
    CHECK_THAT(said.back(), StartsWith("manifuzz: ") && Contains(complaint));
  };
  folder.write("subjects.json",
               named("one_eyed", clip_but(folder, "another", "nothing", "exit 3")));
  refused("it is called 'one_eyed' there, but declares the name 'another'");
  fs::remove(subjects);
  refused(
      "was found with 'one_eyed', which is not built in; say how to start it: --subject "
      "./LIBRARY.so");
}

TEST_CASE("bad subjects.json are refused, by their name and the place", "[bad-input]") {
  const TemporaryFolder folder;
  save_findings(folder, one_eyed(folder));
  const std::vector<std::pair<std::string, std::string>> bad{
      {"", "not JSON"},
      {"[]", "$: is an array; an object is expected"},
      {R"({"one_eyed": 3})", "$.one_eyed: is a number; an object is expected"},
      {R"({"one_eyed": {}})", R"(either "command" or "library" is expected)"},
      {R"({"one_eyed": {"command": "a", "library": "b"}})", "is expected"},
      {R"({"one_eyed": {"command": ["a"]}})", "$.one_eyed.command"},
      {R"({"one_eyed": {"command": "a", "args": "b"}})", "unknown key \"args\""},
      {R"({"x": {"command": "a"}, "x": {"command": "a"}})", "repeated"}};
  for (const auto& [text, complaint] : bad) {
    CAPTURE(text);
    folder.write("corpus/subjects.json", text);
    const Outcome outcome = replay_as_named(folder);
    CHECK(outcome.status == 2);
    CHECK(is_one_clear_line(outcome.err));
    CHECK_THAT(outcome.err, Contains("subjects.json: ") && Contains(complaint));
  }
}
