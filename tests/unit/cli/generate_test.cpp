#include <filesystem>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "corpus/corpus.hpp"
#include "generating/regime.hpp"
#include "support/run_program.hpp"
#include "support/temporary_folder.hpp"

using namespace manifuzz::test;
using manifuzz::CorpusCase;

namespace {

Outcome generate(const std::vector<std::string>& arguments) {
  return run_manifuzz(with({"generate"}, arguments));
}

CorpusCase read(const std::string& line) {
  return manifuzz::parse_case(line, manifuzz::FormatKey::required);
}

/// What `generate` writes with these arguments, read back.
std::vector<CorpusCase> generated(const std::vector<std::string>& arguments) {
  std::vector<CorpusCase> cases;
  for (const std::string& line : lines_of(generate(arguments).out)) cases.push_back(read(line));
  return cases;
}

}  // namespace

TEST_CASE("A case is a function of seed, regime and index") {
  const auto all = lines_of(generate({"--seed", "7", "--regime", "boxes", "--cases", "6"}).out);
  REQUIRE(all.size() == 6);
  CHECK(generate({"--seed", "7", "--regime", "boxes", "--first", "4", "--cases", "1"}).out ==
        all[4] + "\n");
  const auto turns = lines_of(
      generate({"--seed", "7", "--regime", "generic", "--regime", "boxes", "--cases", "6"}).out);
  REQUIRE(turns.size() == 6);
  CHECK(turns[1] == all[0]);
  CHECK(turns[5] == all[2]);
  CHECK(read(turns[0]).pair() != read(all[0]).pair());
  const auto other_seed = generated({"--seed", "8", "--regime", "boxes", "--cases", "1"});
  REQUIRE(other_seed.size() == 1);
  CHECK(other_seed[0].pair() != read(all[0]).pair());
}

TEST_CASE("Any 64-bit seed and index will do") {
  const std::string most = "18446744073709551615";
  CHECK(generate({"--seed", most, "--regime", "boxes", "--first", most, "--cases", "1"}).status ==
        0);
}

TEST_CASE("A seed that is drawn is printed and reproduces") {
  const Outcome drawn = generate({"--cases", "3"});
  REQUIRE(drawn.err.starts_with("seed "));
  const std::string seed = drawn.err.substr(5, drawn.err.size() - 6);
  CHECK(generate({"--seed", seed, "--cases", "3"}).out == drawn.out);
}

TEST_CASE("What generate writes, collide reads") {
  const Outcome cases = generate({"--seed", "3", "--cases", "500"});
  const Outcome answers = run_manifuzz({"collide", "--collider", "clip"}, cases.out);
  CHECK(answers.status == 0);
  CHECK(answers.err.empty());
  CHECK(lines_of(answers.out).size() == 500);
}

TEST_CASE("A line says where its case came from") {
  const auto cases = generated(
      {"--seed", "7", "--regime", "boxes", "--regime", "sliver", "--first", "5", "--cases", "3"});
  REQUIRE(cases.size() == 3);
  REQUIRE(cases[1].found.has_value());
  CHECK(cases[1].found->seed == 7);
  CHECK(cases[1].found->regime == "sliver");
  CHECK(cases[1].found->index == 5);
  CHECK(cases[1].found->versions.empty());
  REQUIRE(cases[2].found.has_value());
  CHECK(cases[2].found->regime == "boxes");
  CHECK(cases[2].found->index == 6);
}

TEST_CASE("A radius is that of each polygon, in place of the regime's own") {
  const std::vector<std::string> drawn{"--seed", "1", "--regime", "generic", "--cases", "20"};
  const auto own = generated(drawn);
  const auto rounded = generated(with(drawn, {"--radius", "0.1"}));
  REQUIRE(own.size() == 20);
  REQUIRE(rounded.size() == 20);
  const manifuzz::Regime& generic = *manifuzz::find_regime("generic");
  for (std::size_t i = 0; i < own.size(); ++i) {
    CHECK(own[i].pair() == manifuzz::generate(1, generic, i));
    CHECK(rounded[i].pair().a.polygon.radius == 0.1F);
    CHECK(rounded[i].pair().b.polygon.radius == 0.1F);
    CHECK(rounded[i].pair() == manifuzz::generate(1, generic, i, {.corpus = {}, .radius = 0.1F}));
  }
}

TEST_CASE("Every command takes the lines that generate writes") {
  const TemporaryFolder folder;
  const std::string lines =
      generate({"--seed", "2", "--regime", "tie_bias", "--cases", "1", "--radius", "0"}).out;
  const std::string corpus = (folder.path() / "corpus").string();
  std::filesystem::create_directory(corpus);
  folder.write("corpus/cases.jsonl", lines);
  CHECK(lines_of(run_manifuzz({"judge"}, lines).out).size() == 1);
  CHECK(run_manifuzz({"replay", corpus, "--subject", "clip"}).status == 0);
  CHECK(run_manifuzz({"fuzz", "--corpus", corpus, "--regime", "corpus", "--subject", "clip64",
                      "--oracle", "clip64", "--seed", "1", "--cases", "10", "--no-save"})
            .status == 0);
  const CorpusCase shrunk = read(run_manifuzz({"shrink", "-"}, lines).out);
  REQUIRE(shrunk.found.has_value());
  CHECK(shrunk.found->regime == "tie_bias");
}
