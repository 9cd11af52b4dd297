#include <filesystem>

#include <catch2/catch.hpp>

#include "support/bad_cases.hpp"
#include "support/run_program.hpp"
#include "support/temporary_folder.hpp"

using namespace manifuzz::test;
using Catch::Contains;
using Catch::StartsWith;

namespace {

/// A case whose A is good_case's with that many vertices, recorded with a bucket.
std::string recorded(const std::string& bucket, int vertices) {
  const std::string corners =
      vertices == 3 ? "[[-1,-1],[1,-1],[1,1]]" : "[[-1,-1],[1,-1],[1,1],[-1,1]]";
  return R"({"format": "manifuzz/case/1", "a": {"vertices": )" + corners +
         R"(}, "b": {"vertices": [[0,0],[2,0],[1,2]], "position": [0.5,0.75]}, "expect": {)" +
         R"("subject": "clip", "oracle": "box2d", "verdict": "tie", "bucket": ")" + bucket +
         R"(", "manifolds": []}})";
}

/// A corpus of three files of one bucket, and two of others.
struct SmallCorpus {
  TemporaryFolder folder;
  std::string path = (folder.path() / "corpus").string();

  SmallCorpus() {
    std::filesystem::create_directories(folder.path() / "corpus" / "ties");
    const std::string tie = "none/tie/count/incident/a";
    folder.write("corpus/ties/aaa.json", recorded(tie, 4));
    folder.write("corpus/ties/none-tie-count-incident-a-12345678.json", recorded(tie, 3));
    folder.write("corpus/ties/aaa.worst.json", recorded(tie, 3));
    folder.write("corpus/ties/witness-one.json", recorded("none/tie/normal/none/a", 4));
    folder.write("corpus/ties/witness-two.json", recorded("none/tie/normal/none/b", 4));
    folder.write("corpus/broken.json", "{");
  }
  Outcome show(const std::string& name) const {
    return run_manifuzz({"show", name, "--corpus", path});
  }
};

}  // namespace

TEST_CASE("a bucket means its smallest case, by slashes or dashes") {
  const SmallCorpus corpus;
  const Outcome slashes = corpus.show("none/tie/count/incident/a");
  CHECK(slashes.status == 0);
  CHECK(slashes.err == "using " + corpus.path +
                           "/ties/none-tie-count-incident-a-12345678.json, the smallest of 2 with "
                           "that bucket\n");
  CHECK(corpus.show("none-tie-count-incident-a").out == slashes.out);
  CHECK_THAT(corpus.show("none/tie/normal/none/b").err, Contains("/ties/witness-two.json\n"));
  CHECK(run_manifuzz({"--quiet", "show", "none/tie/count/incident/a", "--corpus", corpus.path})
            .err.empty());
}

TEST_CASE("the beginning of a file's name means that file") {
  const SmallCorpus corpus;
  for (const char* name : {"witness-o", "witness-one", "witness-one.json"}) {
    CAPTURE(name);
    const Outcome outcome = corpus.show(name);
    CHECK(outcome.status == 0);
    CHECK(outcome.err == "using " + corpus.path + "/ties/witness-one.json\n");
  }
  CHECK_THAT(corpus.show("aaa").err, Contains("/ties/aaa.json\n"));
  CHECK_THAT(corpus.show("aaa.w").err, Contains("/ties/aaa.worst.json\n"));
}

TEST_CASE("a beginning of several files lists them, five at most") {
  const SmallCorpus corpus;
  const Outcome two = corpus.show("witness-");
  CHECK(two.status == 2);
  CHECK(is_one_clear_line(two.err));
  CHECK_THAT(two.err,
             Contains("witness-: 2 files in ") &&
                 Contains("have names that begin so: witness-one.json, witness-two.json\n"));
  for (char last = 'a'; last <= 'e'; ++last) {
    corpus.folder.write(std::string("corpus/witness-") + last + ".json", recorded("", 4));
  }
  CHECK_THAT(corpus.show("witness-").err,
             Contains("7 files in ") && Contains("witness-e.json and 2 more\n"));
}

TEST_CASE("what names no case is one line with the nearest name") {
  const SmallCorpus corpus;
  for (const auto& [name, nearest] :
       {std::pair("none/tie/cuont/incident/a", "did you mean 'none/tie/count/incident/a'?"),
        std::pair("witness-won", "did you mean"),
        std::pair("xyzzy", "no such bucket or file in")}) {
    const Outcome outcome = corpus.show(name);
    CAPTURE(outcome.err);
    CHECK(outcome.status == 2);
    CHECK(is_one_clear_line(outcome.err));
    CHECK_THAT(outcome.err, Contains(nearest));
  }
  const Outcome nowhere = run_manifuzz({"show", "xyzzy", "--corpus", corpus.path + "/none"});
  CHECK(nowhere.status == 2);
  CHECK(is_one_clear_line(nowhere.err));
}

TEST_CASE("a file that exists always wins") {
  const SmallCorpus corpus;
  const Outcome outcome =
      run_program({"sh", "-c", "cd \"$1\" && \"$0\" show witness-one", manifuzz_path(),
                   std::filesystem::path(corpus.folder.write("witness-one", recorded("", 3)))
                       .parent_path()
                       .string()});
  CHECK(outcome.status == 0);
  CHECK(outcome.err.empty());
}

TEST_CASE("shrink takes a bucket as well") {
  const Outcome outcome = run_manifuzz(
      {"shrink", "none/tie/count/incident/a", "--corpus", MANIFUZZ_SOURCE_DIR "/corpus"});
  CHECK(outcome.status == 0);
  CHECK_THAT(outcome.err, StartsWith("using "));
  CHECK_THAT(outcome.out, Contains("none/tie/count/incident/a"));
}
