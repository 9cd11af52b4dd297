#include <filesystem>
#include <iterator>
#include <string>

#include <catch2/catch.hpp>

#include "support/run_program.hpp"
#include "support/source_tree.hpp"
#include "support/temporary_folder.hpp"

// scripts/ci over a stand-in for manifuzz that writes down how it was called.

using namespace manifuzz::test;
using Catch::Contains;

namespace {

/// Somebody's repository with a case in its corpus; the stand-in saves a new one beside it.
struct Repository {
  TemporaryFolder folder;

  explicit Repository(int status) {
    std::filesystem::create_directories(folder.path() / "corpus" / "ties");
    folder.write("corpus/old.json", "{}");
    // Older than whatever a run saves.
    std::filesystem::last_write_time(
        folder.path() / "corpus/old.json",
        std::filesystem::file_time_type::clock::now() - std::chrono::hours(1));
    const std::string program = folder.write(
        "stand-in",
        "#!/bin/sh\n{ printf '<%s>' \"$@\"; echo; } >> called\n"
        "echo '{}' > corpus/ties/new.json\n"
        "for word; do [ \"$before\" != --junit ] || echo xml > \"$word\"; before=$word; done\n"
        "exit " +
            std::to_string(status) + "\n");
    std::filesystem::permissions(program, std::filesystem::perms::owner_all);
  }

  Outcome ci(const std::vector<std::string>& variables) const {
    const std::vector<std::string> command{"env", "-C", folder.path().string(),
                                           "MANIFUZZ=./stand-in", "MANIFUZZ_SEED=7"};
    return run_program(with(with(command, variables), {(source_dir() / "scripts/ci").string()}));
  }
  std::string called() const { return text_of(folder.path() / "called"); }
};

}  // namespace

TEST_CASE("CI runs a smoke test of clip if nothing else is asked for") {
  const Repository repository(0);
  const Outcome outcome = repository.ci({});
  CAPTURE(outcome.err);
  CHECK(outcome.status == 0);
  CHECK(repository.called() ==
        "<smoke><--junit><manifuzz-results/junit.xml><--subject><clip><--oracle><box2d>"
        "<--seed><7><--corpus><corpus>\n"
        "<report><manifuzz-results/findings><--maps><0><--subject><clip><--oracle><box2d>"
        "<--output><manifuzz-results/report.html>\n");
  CHECK(text_of(repository.folder.path() / "manifuzz-results/status") == "passed\n");
}

TEST_CASE("what CI is told is data to the shell") {
  const Repository repository(0);
  const std::string evil = "node x.mjs; $(touch pwned) `touch pwned` \" ' > pwned";
  CHECK(repository
            .ci({"MANIFUZZ_SUBJECT_COMMAND=" + evil, "MANIFUZZ_ORACLE=$(touch pwned)",
                 "MANIFUZZ_MODE=fuzz", "MANIFUZZ_SECONDS=5; touch pwned"})
            .status == 0);
  CHECK_THAT(repository.called(), Contains("<--subject-command><" + evil + ">") &&
                                      Contains("<--seconds><5; touch pwned>"));
  CHECK_FALSE(std::filesystem::exists(repository.folder.path() / "pwned"));
}

TEST_CASE("CI passes the status on, and says it in a word where a workflow asks") {
  for (const auto& [status, word] : {std::pair(0, "passed"), {1, "failed"}, {2, "error"}}) {
    const Repository repository(status);
    const Outcome outcome = repository.ci({"GITHUB_OUTPUT=outputs", "MANIFUZZ_OUTPUT=out"});
    CHECK(outcome.status == status);
    CHECK(text_of(repository.folder.path() / "outputs") ==
          "junit=out/junit.xml\nstatus=" + std::string(word) + "\nresults=out\n");
  }
}

TEST_CASE("CI takes nothing of an earlier run for this one's") {
  const Repository repository(0);
  repository.ci({"MANIFUZZ_MODE=fuzz"});
  const auto results = repository.folder.path() / "manifuzz-results";
  repository.folder.write("manifuzz-results/results.json", "{}");
  CHECK(repository.ci({"GITHUB_OUTPUT=outputs", "MANIFUZZ=/bin/false"}).status == 1);
  for (const char* const name : {"junit.xml", "results.json", "report.html", "findings/ties"}) {
    CAPTURE(name);
    CHECK_FALSE(std::filesystem::exists(results / name));
  }
  CHECK(text_of(repository.folder.path() / "outputs") ==
        "junit=\nstatus=failed\nresults=manifuzz-results\n");
}

TEST_CASE("CI keeps what was saved, and not what was known") {
  const Repository repository(1);
  repository.ci({});
  const auto findings = repository.folder.path() / "manifuzz-results/findings";
  CHECK(std::filesystem::exists(findings / "ties/new.json"));
  CHECK_FALSE(std::filesystem::exists(findings / "old.json"));
}

TEST_CASE("a mode that there is not is one clear line, and an error to a workflow") {
  const Repository repository(0);
  const Outcome outcome = repository.ci({"MANIFUZZ_MODE=all", "GITHUB_OUTPUT=outputs"});
  CHECK(outcome.status == 2);
  CHECK(is_one_clear_line(outcome.err));
  CHECK(text_of(repository.folder.path() / "outputs") ==
        "junit=\nstatus=error\nresults=manifuzz-results\n");
}

TEST_CASE("what CI cannot run is no finding") {
  const Repository repository(0);
  repository.folder.write("file", "mine");
  for (const char* const broken : {"MANIFUZZ_OUTPUT=file/x", "MANIFUZZ=/no/such/program"}) {
    CAPTURE(broken);
    CHECK(repository.ci({broken}).status == 2);
  }
}

TEST_CASE("CI keeps its results out of the corpus, which stays as it is") {
  const Repository repository(0);
  repository.folder.write("corpus/status", "mine");
  for (const char* const output : {"corpus", "corpus/ties/", "./corpus/../corpus/new"}) {
    const Outcome outcome = repository.ci({std::string("MANIFUZZ_OUTPUT=") + output});
    CAPTURE(output);
    CHECK(outcome.status == 2);
    CHECK(is_one_clear_line(outcome.err));
  }
  CHECK(text_of(repository.folder.path() / "corpus/status") == "mine");
  std::filesystem::create_directory(repository.folder.path() / "findings");
  repository.folder.write("findings/old.json", "{}");
  CHECK(repository.ci({"MANIFUZZ_OUTPUT=.", "MANIFUZZ_CORPUS=findings"}).status == 2);
  CHECK(text_of(repository.folder.path() / "findings/old.json") == "{}");
  CHECK_FALSE(std::filesystem::exists(repository.folder.path() / "corpus/new"));
}

TEST_CASE("CI takes folders that look like options") {
  const Repository repository(0);
  std::filesystem::rename(repository.folder.path() / "corpus", repository.folder.path() / "-x");
  CHECK(repository.ci({"MANIFUZZ_OUTPUT=--help", "MANIFUZZ_CORPUS=-x"}).status == 0);
  CHECK(text_of(repository.folder.path() / "--help/status") == "passed\n");
}

TEST_CASE("the seed is that of the commit under test") {
  const Repository repository(0);
  repository.ci({"MANIFUZZ_SEED=", "GITHUB_SHA=000000000000010123456789abcdef0123456789"});
  CHECK_THAT(repository.called(), Contains("<--seed><16>"));
}
