#include <filesystem>
#include <iterator>

#include <catch2/catch.hpp>

#include "support/run_program.hpp"
#include "support/source_tree.hpp"
#include "support/temporary_folder.hpp"
#include "unit/report/svg_reader.hpp"

using namespace manifuzz::test;
using Catch::Contains;

namespace {

/// A smoke run of a second over one case of the corpus.
Outcome smoke(const TemporaryFolder& folder, const std::vector<std::string>& more) {
  const char* const name = "witness-box2d-no-contact-under-bias.json";
  const std::filesystem::path corpus = folder.path() / "corpus";
  std::filesystem::create_directories(corpus);
  std::filesystem::copy(source_dir() / "corpus/defects/box2d" / name, corpus / name,
                        std::filesystem::copy_options::overwrite_existing);
  const std::vector<std::string> arguments{
      "smoke",     "--seed",   "1",    "--seconds", "3",
      "--no-save", "--corpus", corpus, "--junit",   (folder.path() / "junit.xml").string()};
  return run_manifuzz(with(arguments, more));
}

}  // namespace

TEST_CASE("smoke replays, checks properties and runs a campaign, in one JUnit report") {
  const TemporaryFolder folder;
  const Outcome outcome = smoke(folder, {});
  CAPTURE(outcome.out);
  CHECK(outcome.status == 0);
  CHECK(outcome.err.empty());
  CHECK_THAT(outcome.out, Contains("1 case, 1 passed, 0 failed"));
  CHECK_THAT(outcome.out, Contains("ok   swapping-mirrors: "));
  CHECK_THAT(outcome.out, Contains("clip against box2d 2.4.1: "));
  const auto suites = [&] {
    std::vector<std::string> names;
    for (const Element& element : read_svg(text_of(folder.path() / "junit.xml"))) {
      if (element.name == "testsuite") names.push_back(element.attributes.at("name"));
    }
    return names;
  }();
  CHECK(suites ==
        std::vector<std::string>{"manifuzz replay", "manifuzz property", "manifuzz fuzz"});
}

TEST_CASE("smoke fails with a subject that is wrong") {
  const TemporaryFolder folder;
  const Outcome outcome = smoke(folder, {"--subject", "box2d", "--oracle", "clip"});
  CHECK(outcome.status == 1);
  CHECK_THAT(outcome.out, Contains("1 case, 0 passed, 1 failed"));
}

TEST_CASE("a collider that never answers in time still has its smoke run") {
  const TemporaryFolder folder;
  const std::string program =
      folder.write("silent.sh", "#!/bin/sh\nread line\necho '{\"points\": []}'\nexec sleep 1000\n");
  std::filesystem::permissions(program, std::filesystem::perms::owner_all);
  const Outcome outcome = smoke(folder, {"--subject-command", program});
  CAPTURE(outcome.err);
  CHECK(outcome.status == 1);
  CHECK_THAT(outcome.out, Contains("time was up"));
}

TEST_CASE("bad usage of smoke is one clear line and status 2") {
  const TemporaryFolder folder;
  for (const char* const seconds : {"0", "19", "-1", "x"}) {
    const Outcome outcome = run_manifuzz({"smoke", "--seconds", seconds});
    CHECK(outcome.status == 2);
    CHECK(is_one_clear_line(outcome.err));
  }
}
