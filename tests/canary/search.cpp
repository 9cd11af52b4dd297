#include "canary/search.hpp"

#include <algorithm>
#include <chrono>
#include <iostream>
#include <stdexcept>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "canary/edits.hpp"
#include "corpus/shrink.hpp"
#include "generating/drafts.hpp"
#include "generating/regime.hpp"
#include "support/named_tests.hpp"
#include "support/source_tree.hpp"

namespace manifuzz::canary {
namespace {

constexpr std::uint64_t kSeed = 1;
/// A copy as it is must stay unblamed on this share of the cases in which a bug must be caught.
constexpr std::uint64_t kUneditedShare = 20;

std::string heading() {
  return fmt::format("{:<35} {:<78} {:<15} {:>7} {:>8} {:>8} {:>6}\n", "planted bug", "caught by",
                     "regime", "cases", "seconds", "vertices", "digits");
}

std::string row(const std::string& name, const std::optional<Sighting>& caught) {
  if (!caught) return fmt::format("{:<35} not caught\n", name);
  const PairCase& pair = caught->shrunk.pair;
  return fmt::format("{:<35} {:<78} {:<15} {:>7} {:>8.3f} {:>4} + {} {:>6}\n", name,
                     caught->noticed.by, caught->regime, caught->cases, caught->seconds,
                     pair.a.polygon.count, pair.b.polygon.count, digits_of(pair));
}

void check_caught(const PlantedBug& bug) {
  // What it shrinks to, which takes as long again, is shown by the whole table.
  const std::uint64_t cases_max = is_unedited(bug) ? bug.cases_max / kUneditedShare : bug.cases_max;
  const auto caught = bug.search({.seed = kSeed, .cases_max = cases_max, .shrinks = false});
  std::cout << heading() << row(bug.name, caught);
  CHECK(caught.has_value() == !is_unedited(bug));
}

std::vector<Edit> table() {
  std::vector<Edit> all;
  for (const char* part :
       {"edits.txt", "round_edits.txt", "methods_edits.txt", "pair_edits.txt", "batch_edits.txt"}) {
    const std::vector<Edit> edits = read_edits(test::source_dir() / "tests/canary" / part);
    all.insert(all.end(), edits.begin(), edits.end());
  }
  return all;
}

/// The bugs planted by an edit: its own, and those of the kernels that run what it edits.
std::vector<const PlantedBug*> planted_by(const Edit& edit) {
  std::vector<const PlantedBug*> all;
  for (const PlantedBug& bug : planted_bugs()) {
    if (bug.name == edit.bug || bug.name.starts_with(edit.bug + "_in_")) all.push_back(&bug);
  }
  return all;
}

/// Throws std::runtime_error where the build planted no bug of that name.
const PlantedBug& planted(const std::string& name) {
  const auto bug = std::find_if(planted_bugs().begin(), planted_bugs().end(),
                                [&name](const PlantedBug& b) { return b.name == name; });
  if (bug == planted_bugs().end()) throw std::runtime_error("not planted: " + name);
  return *bug;
}

}  // namespace

std::optional<Sighting> search(const Haystack& haystack, const Notice& notice,
                               const Shrink& shrink) {
  using Clock = std::chrono::steady_clock;
  const auto seconds_since = [](Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
  };
  const auto start = Clock::now();
  for (std::uint64_t number = haystack.first; number < haystack.cases_max; ++number) {
    const std::size_t count = haystack.regimes.size();
    const Regime& regime = haystack.regimes[(number + haystack.seed) % count];
    const PairCase pair = generate(haystack.seed, regime, number / count);
    const auto noticed = notice(number, pair);
    if (noticed && !haystack.known_looks.contains(noticed->look)) {
      Sighting sighting{*noticed, std::string(regime.name), number + 1, seconds_since(start), {}};
      const auto shrink_start = Clock::now();
      sighting.shrunk = haystack.shrinks ? shrink(number, pair, *noticed) : Shrunk{.pair = pair};
      sighting.shrink_seconds = seconds_since(shrink_start);
      return sighting;
    }
  }
  return std::nullopt;
}

bool is_unedited(const PlantedBug& bug) {
  return bug.name.starts_with("unedited");
}

int digits_of(PairCase pair) {
  int digits = 0;
  for (const float* number : free_numbers(pair)) {
    digits = std::max(digits, significant_digits(*number));
  }
  return digits;
}

std::vector<PlantedBug>& planted_bugs() {
  static std::vector<PlantedBug> bugs;
  return bugs;
}

void add_planted_bug(PlantedBug bug) {
  const std::string name = is_unedited(bug) ? bug.name + " is not caught" : bug.name + " is caught";
  test::add_test(name, "[planted]", [bug] { check_caught(bug); });
  planted_bugs().push_back(std::move(bug));
}

}  // namespace manifuzz::canary

using namespace manifuzz::canary;

// If this stops failing, the checks above have stopped to see anything.
TEST_CASE("a planted bug fails the check that nothing is wrong", "[!shouldfail]") {
  const PlantedBug& bug = planted("normal_not_turned");
  CHECK_FALSE(bug.search({kSeed, bug.cases_max / kUneditedShare}).has_value());
}

TEST_CASE("a bug planted into the judge fails the check that nothing is wrong", "[!shouldfail]") {
  const PlantedBug& bug = planted("fault_swapped");
  CHECK_FALSE(bug.search({kSeed, bug.cases_max / kUneditedShare}).has_value());
}

TEST_CASE(
    "at least 100 bugs are planted into the clean code, 8 into the judge, 60 into the kernels, 30 "
    "into the other methods") {
  int in_clipping = 0;
  int in_kernels = 0;
  int in_judge = 0;
  int in_methods = 0;
  std::size_t planted_in_all = 0;
  for (const Edit& edit : table()) {
    const auto bugs = planted_by(edit);
    INFO(edit.bug);
    CHECK(!bugs.empty());
    planted_in_all += bugs.size();
    if (edit.old_line.empty()) continue;
    const bool is_clipping =
        edit.file.starts_with("src/clipping/") || edit.file.starts_with("src/own_colliders/");
    const bool is_kernel = edit.file.starts_with("src/kernel/");
    const bool is_method = edit.file.starts_with("src/methods/");
    ++(is_clipping ? in_clipping : is_kernel ? in_kernels : is_method ? in_methods : in_judge);
  }
  CHECK(planted_in_all == planted_bugs().size());  // unlike names, and nothing left out
  CHECK(in_clipping >= 100);
  CHECK(in_judge >= 8);
  CHECK(in_kernels >= 60);
  CHECK(in_methods >= 30);
}

TEST_CASE("the table of planted bugs", "[.table]") {
  std::vector<double> seconds;
  std::cout << heading();
  for (const Edit& edit : table()) {
    for (const PlantedBug* bug : planted_by(edit)) {
      if (is_unedited(*bug)) continue;
      const auto caught = bug->search({kSeed, bug->cases_max});
      std::cout << row(bug->name, caught) << std::flush;
      CHECK(caught.has_value());
      if (caught) seconds.push_back(caught->seconds);
    }
  }
  std::sort(seconds.begin(), seconds.end());
  REQUIRE(!seconds.empty());
  std::cout << fmt::format("{} caught, median {:.3f} s, longest {:.3f} s\n", seconds.size(),
                           seconds[seconds.size() / 2], seconds.back());
}
