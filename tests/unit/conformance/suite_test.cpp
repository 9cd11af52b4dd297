#include "conformance/suite.hpp"

#include <algorithm>
#include <set>
#include <string>

#include <catch2/catch.hpp>

#include "base/json.hpp"
#include "conformance/conformance_case.hpp"
#include "corpus/corpus.hpp"
#include "generating/regime.hpp"
#include "support/run_program.hpp"
#include "support/source_tree.hpp"
#include "support/temporary_folder.hpp"

using namespace manifuzz;
using namespace manifuzz::test;

namespace {

std::filesystem::path stored_suite() {
  return source_dir() / "corpus/conformance/cases.jsonl";
}

std::string name_of(const std::string& line) {
  const JsonTree tree = parse_json(line);
  return std::string(JsonView(tree).at("name").string());
}

}  // namespace

TEST_CASE("each line of the stored suite is written for its name again, bit for bit") {
  const auto lines = lines_of(text_of(stored_suite()));
  CHECK(lines.size() == 2000);
  for (const std::string& line : lines) {
    const std::string name = name_of(line);
    INFO(name);
    const auto pair = named_pair(name, source_dir() / "corpus");
    REQUIRE(pair);
    REQUIRE(conformance_line(name, *pair) == line);
  }
}

TEST_CASE("the stored suite has every regime, the worst cases and the causes of the ledger") {
  std::set<std::string> sources;
  for (const std::string& line : lines_of(text_of(stored_suite()))) {
    sources.insert(name_of(line).substr(0, name_of(line).find('/')));
  }
  for (const Regime& regime : regimes()) {
    INFO(regime.name);
    CHECK(sources.contains(std::string(regime.name)) == (regime.name != "corpus"));
  }
  CHECK(sources.contains("worst"));
  CHECK(sources.contains("ledger"));
}

TEST_CASE("the stored suite takes no more than two megabytes") {
  CHECK(text_of(stored_suite()).size() <= 2'000'000);
}

TEST_CASE("a suite is filled up with the seed's cases of every regime, each once") {
  const TemporaryFolder corpus;
  const Suite made = suite({.corpus = corpus.path(), .seed = 7, .cases = 90}, [](std::size_t) {});
  CHECK(made.lines.size() == 90);
  CHECK(std::set(made.lines.begin(), made.lines.end()).size() == 90);
  CHECK(std::ranges::all_of(made.sources, [](const SuiteSource& source) {
    return source.name == "worst" || source.name == "ledger" || source.name == "picks" ||
           source.taken >= 3;
  }));
}

TEST_CASE("a pick that names no case is one line on where it stands") {
  const TemporaryFolder corpus;
  std::filesystem::create_directory(corpus.path() / "conformance");
  corpus.write("conformance/picks.txt", "# remark\nboxes/1/2  # of a bug\nnoboxes/1/2\n");
  const Outcome outcome = run_manifuzz({"conformance", "--corpus", corpus.path().string()});
  CHECK(outcome.status == 2);
  CHECK(is_one_clear_line(outcome.err));
  CHECK_THAT(outcome.err, Catch::Contains("picks.txt:3: \"noboxes/1/2\" names no case"));
}

TEST_CASE("whatever reads a corpus passes over the conformance suite") {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.path() / "conformance");
  folder.write("conformance/cases.jsonl", text_of(stored_suite()));
  folder.write("boxes.json", text_of(source_dir() / "corpus/seeds/regime-boxes.json"));
  const Outcome outcome = run_manifuzz({"replay", folder.path().string(), "--subject", "clip"});
  CHECK(outcome.status == 0);
  const std::filesystem::path folders[] = {folder.path()};
  const Corpus corpus = read_corpus(folders);
  CHECK(corpus.errors.empty());
  CHECK(corpus.cases.size() == 1);
}
