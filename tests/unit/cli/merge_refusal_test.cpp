#include <algorithm>
#include <filesystem>

#include <catch2/catch.hpp>

#include "corpus/corpus.hpp"
#include "unit/cli/merge_runs.hpp"

using namespace manifuzz;
using namespace manifuzz::test;
namespace fs = std::filesystem;

TEST_CASE("a result of a wrong shape is left out by its path, and ends no merge") {
  const TemporaryFolder folder;
  const Json good = count(folder, "q", 0, 500);
  count(folder, "r", 250, 500);
  for (const auto& [key, value] :
       {std::pair<const char*, Json>("cases", "x"), {"buckets", 7}, {"verdicts", Json::array()}}) {
    Json bad = good;
    bad[key] = value;
    folder.write("bad.json", bad.dump());
    const Outcome outcome = merge(folder, {"bad.json", "r.json"}, "all");
    CAPTURE(key, outcome.err);
    CHECK(outcome.status == 2);
    const std::vector<std::string> lines = lines_of(outcome.err);
    REQUIRE(lines.size() == 2);
    CHECK(lines[0].find(std::string("bad.json: $.") + key + ": is a") != std::string::npos);
    CHECK(Json::parse(text_of(folder.path() / "all.json"))["cases"] == 500);
  }
}

TEST_CASE("merging refuses what would cost a file that is there, before anything is written") {
  const TemporaryFolder folder;
  run(folder, "p", 0, 500);
  const std::string before = text_of(folder.path() / "p.json");
  const std::string mine = folder.write("mine.json", "mine");
  const std::string corpus = (folder.path() / "p").string();
  const std::string output = (folder.path() / "all").string();
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{corpus, corpus + ".json", "--output", output, "--json",
                                 corpus + ".json"},
        {corpus, "--output", output, "--json", mine},
        {corpus, "--output", "-"}}) {
    const Outcome outcome = run_manifuzz(with({"merge"}, arguments));
    CHECK(outcome.status == 2);
    CHECK(is_one_clear_line(outcome.err));
    CHECK_FALSE(fs::exists(output));
  }
  CHECK(text_of(corpus + ".json") == before);
  CHECK(text_of(mine) == "mine");
}

TEST_CASE("merging that cannot be done leaves nothing behind") {
  const TemporaryFolder folder;
  run(folder, "p", 0, 500);
  fs::create_directory(folder.path() / "empty");
  for (const char* const output : {"new/and/deeper", "empty"}) {
    const std::string summary = folder.write("file", "x") + "/below/a/file.json";
    const Outcome outcome =
        run_manifuzz({"merge", (folder.path() / "p").string(), (folder.path() / "p.json").string(),
                      "--output", (folder.path() / output).string(), "--json", summary});
    CHECK(outcome.status == 2);
  }
  CHECK_FALSE(fs::exists(folder.path() / "new"));
  CHECK(fs::is_empty(folder.path() / "empty"));
  fs::create_symlink("nowhere", folder.path() / "link");
  CHECK(run_manifuzz({"merge", (folder.path() / "p").string(), "--output",
                      (folder.path() / "link").string()})
            .status == 2);
  CHECK(fs::is_symlink(folder.path() / "link"));
}

TEST_CASE("one pair with one look by two subjects is two findings, and both are kept") {
  const TemporaryFolder folder;
  CorpusCase known;
  {
    const TemporaryFolder scratch;
    run(scratch, "p", 0, 2000);
    const fs::path found = scratch.path() / "p";
    known = read_corpus({&found, 1}).cases.front();
  }
  known.expect->bucket = "subject/subject_wrong/depth/none/a";
  for (const char* const subject : {"one", "two"}) {
    known.expect->subject = subject;
    write_corpus_case(folder.path() / subject, known);
  }
  REQUIRE(run_manifuzz({"merge", (folder.path() / "one").string(), (folder.path() / "two").string(),
                        "--output", (folder.path() / "all").string()})
              .status == 0);
  const fs::path all = folder.path() / "all";
  std::vector<std::string> subjects;
  for (const CorpusCase& kept : read_corpus({&all, 1}).cases) {
    subjects.push_back(kept.expect->subject);
  }
  std::ranges::sort(subjects);
  CHECK(subjects == std::vector<std::string>{"one", "two"});
}
