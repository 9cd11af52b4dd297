#include <filesystem>
#include <map>
#include <regex>

#include <catch2/catch.hpp>

#include "support/run_program.hpp"
#include "support/temporary_folder.hpp"

// However many processes share a campaign, what it writes is the same to the byte but for times.

using namespace manifuzz::test;
namespace fs = std::filesystem;

namespace {

struct Written {
  std::string json;
  std::map<std::string, std::string> files;  ///< of the corpus, by path

  bool operator==(const Written&) const = default;
};

/// Without what says how fast it was, and in how many processes.
std::string without_times(const std::string& json) {
  return std::regex_replace(
      json, std::regex(R"re("(seconds|cases_per_second|jobs)": [-+.e0-9]+)re"), "\"$1\": 0");
}

/// A campaign in a folder of its own, as its relative paths are part of what it writes.
Written written_with(const std::string& jobs, const std::string& options) {
  const TemporaryFolder folder;
  const Outcome outcome = run_program(
      {"sh", "-c", "cd \"$1\" && exec \"$0\" fuzz --corpus corpus --seed 1 --jobs $2 --json - $3",
       manifuzz_path(), folder.path().string(), jobs, options});
  CAPTURE(jobs, outcome.err);
  CHECK(outcome.status <= 1);
  Written written{without_times(outcome.out), {}};
  for (const auto& entry : fs::recursive_directory_iterator(folder.path() / "corpus")) {
    if (!entry.is_regular_file()) continue;
    written.files[entry.path().lexically_relative(folder.path()).string()] = text_of(entry.path());
  }
  return written;
}

}  // namespace

TEST_CASE("a campaign writes the same bytes with 1, 2, 7 and 16 jobs, and saves the same") {
  for (const char* const options :
       {"--subject box2d --oracle clip --regime tie_bias --regime sliver --cases 2000 "
        "--shrink-seconds 0",
        "--regime tie_bias --ties --cases 20 --shrink-seconds 1000"}) {
    const Written alone = written_with("1", options);
    CHECK(alone.json.size() > 1000);
    CHECK(alone.files.size() >= 2);
    for (const char* const jobs : {"2", "7", "16"}) {
      CAPTURE(jobs, options);
      const Written shared = written_with(jobs, options);
      CHECK(shared.json == alone.json);
      CHECK(shared.files == alone.files);
    }
  }
}
