#include "hunting/bytes_corpus.hpp"

#include <catch2/catch.hpp>

#include "corpus/corpus.hpp"
#include "generating/regime.hpp"
#include "hunting/libfuzzer_options.hpp"
#include "support/temporary_folder.hpp"

using namespace manifuzz;
using Catch::Contains;
using test::TemporaryFolder;

namespace {

namespace fs = std::filesystem;

const auto kAll = [](const PairCase&) { return true; };

std::size_t count_in(const fs::path& folder) {
  return static_cast<std::size_t>(
      std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

LibFuzzerOptions options_of(std::vector<std::string> words) {
  words.insert(words.begin(), "fuzzer");
  return libfuzzer_options(words);
}

}  // namespace

TEST_CASE("cases go from JSON to bytes and back, each once") {
  const TemporaryFolder folder;
  const Found bred{.regime = std::string(kRegimeOfHunts), .versions = {}};
  for (std::uint64_t i = 0; i < 20; ++i) {
    write_corpus_case(folder.path() / "cases",
                      {.any = generate(1, regimes()[i], i), .found = bred});
  }
  const fs::path cases = folder.path() / "cases";
  const fs::path bytes = folder.path() / "bytes";
  const fs::path again = folder.path() / "again";
  const Rewritten written = write_as_bytes({&cases, 1}, bytes, kAll);
  CHECK(written.written == 20);
  CHECK(written.left_out == 0);
  CHECK(count_in(bytes) == 20);
  write_as_bytes({&cases, 1}, bytes, kAll);
  CHECK(count_in(bytes) == 20);
  CHECK(write_as_json({&bytes, 1}, again).written == 20);
  for (const auto& entry : fs::directory_iterator(cases)) {
    CHECK(test::text_of(entry.path()) == test::text_of(again / entry.path().filename()));
  }
}

TEST_CASE("what a collider is not asked, and what is no case, is left out and counted") {
  const TemporaryFolder folder;
  write_corpus_case(folder.path() / "cases", {.any = generate(1, regimes()[0], 0)});
  const fs::path cases = folder.path() / "cases";
  const fs::path bytes = folder.path() / "bytes";
  const Rewritten none = write_as_bytes({&cases, 1}, bytes, [](const PairCase&) { return false; });
  CHECK(none.written == 0);
  CHECK(none.left_out == 1);
  const std::array inputs{fs::path(folder.write("short", "\n")),
                          fs::path(folder.write("long", std::string(5000, '\1'))),
                          fs::path(folder.write("empty", ""))};
  const Rewritten rewritten = write_as_json(inputs, folder.path() / "json");
  CHECK(rewritten.written == 0);
  CHECK(rewritten.left_out == 3);
}

TEST_CASE("files that are broken or not there are errors, in a line") {
  const TemporaryFolder folder;
  const std::array broken{fs::path(folder.write("broken.json", "{"))};
  CHECK_THROWS_WITH(write_as_bytes(broken, folder.path() / "bytes", kAll), Contains("broken.json"));
  const std::array missing{folder.path() / "missing"};
  CHECK_THROWS_AS(write_as_json(missing, folder.path() / "json"), UserError);
}

TEST_CASE("libFuzzer's words stay, and ours go") {
  const LibFuzzerOptions options = options_of(
      {"-runs=5", "--from", "a.json", "corpus", "--from=b", "--findings=found", "--stop", "more"});
  CHECK(options.rest == std::vector<std::string>{"fuzzer", "-runs=5", "corpus", "more"});
  CHECK(options.inputs == std::vector<fs::path>{"corpus", "more"});
  CHECK(options.from == std::vector<fs::path>{"a.json", "b"});
  CHECK(options.findings == "found");
  CHECK(options.stops);
  CHECK_FALSE(options.to_json);
  CHECK(options_of({"--to-json", "out", "corpus"}).to_json == "out");
}

TEST_CASE("a command line that lacks something says what") {
  CHECK_THROWS_WITH(options_of({"--from"}), Contains("a file or folder is expected"));
  CHECK_THROWS_WITH(options_of({"--findings", "-runs=1"}), Contains("is expected"));
  CHECK_THROWS_WITH(options_of({"--from", "a.json"}), Contains("corpus is expected"));
  CHECK_THROWS_WITH(options_of({"--to-json", "out"}), Contains("are expected"));
  CHECK_THROWS_WITH(options_of({"--form", "x"}), Contains("there is no option --form"));
}
