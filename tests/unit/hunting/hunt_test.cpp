#include "hunting/hunt.hpp"

#include <chrono>
#include <thread>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "base/file.hpp"
#include "engines/colliders.hpp"
#include "hunting/rare_bugs.hpp"
#include "hunting/rare_colliders.hpp"
#include "hunting/worst_cases.hpp"
#include "own_colliders/own_colliders.hpp"
#include "support/installed_collider.hpp"
#include "support/source_tree.hpp"
#include "support/temporary_folder.hpp"
#include "unit/hunting/small_hunts.hpp"

using namespace manifuzz;
using namespace manifuzz::test;

TEST_CASE("any number of jobs finds the same") {
  const Hunt alone = run(plan_of(make_clip(), usual_oracle(), 6000, 1));
  const Hunt shared = run(plan_of(make_clip(), usual_oracle(), 6000, 3));
  CHECK(alone.generations == shared.generations);
  CHECK(alone.cells == shared.cells);
  CHECK(alone.cells_drawn == shared.cells_drawn);
  CHECK(alone.campaign.result.verdicts == shared.campaign.result.verdicts);
  REQUIRE(alone.worst.size() == shared.worst.size());
  for (std::size_t i = 0; i < alone.worst.size(); ++i) {
    CHECK(alone.worst[i].value == shared.worst[i].value);
    CHECK(alone.worst[i].number == shared.worst[i].number);
    CHECK(alone.worst[i].pair == shared.worst[i].pair);
    CHECK(alone.worst[i].drawn == shared.worst[i].drawn);
  }
}

TEST_CASE("a longer hunt begins as a shorter one, so that a case is there again by its number") {
  const Hunt shorter = run(plan_of(make_clip(), make_clip(), 3000, 2));
  HuntPlan longer = plan_of(make_clip(), make_clip(), 5000, 2);
  std::vector<std::pair<CaseNumber, PairCase>> met;
  longer.plan.jobs = 1;
  const Hunt whole = run(longer);
  for (const WorstFound& found : shorter.worst) {
    if (!found.pair) continue;
    for (const WorstFound& later : whole.worst) {
      if (later.gauge == found.gauge) CHECK(later.value >= found.value);
      if (later.gauge == found.gauge && later.number == found.number)
        CHECK(later.pair == found.pair);
    }
  }
}

TEST_CASE("a hunt fills more cells, and finds worse, than as many drawn cases") {
  const Hunt hunt = run(plan_of(make_clip(), make_clip(), 30'000, 2));
  CHECK(hunt.cells.all > hunt.cells_drawn->all);
  CHECK(hunt.cells.of_pairs > hunt.cells_drawn->of_pairs);
  for (const WorstFound& found : hunt.worst) {
    CAPTURE(name_of(found.gauge, kGaugeNames));
    // In float some normal is off by half of its bound within a few thousand cases, drawn or
    // hunted.
    const double least = found.gauge == Gauge::normal_share ? 0.99 : 1;
    CHECK(found.value >= least * *found.drawn);
    CHECK(found.value < 1);  // the clip is right, within its bounds
  }
}

TEST_CASE("of a collider too slow for one generation in its time, cases are drawn for comparison") {
  Collider slow = make_clip();
  slow.with_tie_bias = nullptr;
  slow.collide = [clip = make_clip()](const PairCase& pair) {
    std::this_thread::sleep_for(std::chrono::milliseconds(4));
    return clip.collide(pair);
  };
  HuntPlan plan = plan_of(slow, make_clip(), 0, 1);
  plan.plan.cases.reset();
  plan.plan.seconds = 2;
  const Hunt hunt = run(plan);
  CHECK(hunt.generations == 1);
  CHECK(hunt.campaign.result.cases() > 0);
  CHECK(hunt.cells_drawn->all > 0);
}

TEST_CASE("a hunt that names a measure breeds more from its greatest, and so fills fewer cells") {
  HuntPlan plan = plan_of(make_clip(), make_clip(), 10'000, 2);
  plan.compares = false;
  const Hunt of_all = run(plan);
  plan.measure = Measure::bound_share;
  const Hunt of_shares = run(plan);
  CHECK(of_shares.cells.all < of_all.cells.all);
  CHECK(of_shares.cells.all > of_all.cells.all / 2);
}

TEST_CASE("a bug that drawing meets once in a million cases is found, shrunk and saved",
          "[longer]") {
  const TemporaryFolder folder;
  HuntPlan plan = plan_of(with_rare_bug("deep_on_a_short_face"), make_clip(), 150'000, 2);
  plan.compares = false;
  Hunt hunt = run(plan, {.folder = folder.path().string(), .shrink_seconds = 30});
  const Finding* found = nullptr;
  for (const Finding& finding : hunt.campaign.findings) {
    if (finding.bucket.fault == Fault::subject) found = &finding;
  }
  REQUIRE(found != nullptr);
  CHECK(has_failed(hunt.campaign.result));
  const CorpusCase saved = read_case_file(found->file);
  CHECK(saved.found->regime == "hunt");
  CHECK(rare_bugs_met_by(exact::Truth(saved.pair())) >> index_of_bug("deep_on_a_short_face") & 1);
  const std::array known{folder.path()};
  keep_worst(hunt, known, folder.path());
  const auto error = std::ranges::find(hunt.worst, Gauge::error, &WorstFound::gauge);
  REQUIRE(error != hunt.worst.end());
  CHECK(error->value > 0.2);
  CHECK(std::filesystem::exists(worst_file(folder.path(), "planted", Gauge::error)));
  CHECK(error->file == worst_file(folder.path(), "planted", Gauge::error).string());
}

namespace {

/// A hunt that finds a planted bug, and saves it to the folder. `on_saving` runs before each
/// finding is saved.
Hunt hunt_saving_to(const std::filesystem::path& folder, const std::function<void()>& on_saving) {
  HuntPlan plan = plan_of(with_rare_bug("climb_stops_short"), make_clip(), 100'000, 2);
  plan.compares = false;
  return run(plan, {.folder = folder.string(), .shrink_seconds = 1},
             [&](const HuntProgress& progress) {
               if (!progress.cases.saving.empty()) on_saving();
             });
}

}  // namespace

TEST_CASE("what is found stands in a file while a hunt runs, and goes when it is saved",
          "[longer]") {
  const TemporaryFolder folder;
  const std::filesystem::path journal = folder.path() / "hunt-4.jsonl";
  bool was_there = false;
  const Hunt hunt = hunt_saving_to(
      folder.path(), [&] { was_there = was_there || std::filesystem::exists(journal); });
  REQUIRE(has_failed(hunt.campaign.result));
  CHECK(was_there);
  CHECK_FALSE(std::filesystem::exists(journal));
}

TEST_CASE("while a hunt runs, the worst until then stand in its file, also of a right collider") {
  const TemporaryFolder folder;
  const std::filesystem::path journal = folder.path() / "found" / "hunt-4.jsonl";
  HuntPlan plan = plan_of(make_clip(), make_clip(), 2000, 1);
  plan.compares = false;
  const Hunt shorter = run(plan);
  plan.plan.cases = 20'000;
  std::string last;
  run(plan, {.folder = journal.parent_path().string()}, [&](const HuntProgress&) {
    if (std::filesystem::exists(journal)) last = InputFile(journal.string()).read_all();
  });
  for (const WorstFound& found : shorter.worst) {
    if (!found.pair) continue;
    std::string line;
    append_case_line(line, *found.pair);
    const std::string vertices = line.substr(line.find("\"a\""), 200);
    CHECK_THAT(last, Catch::Contains(vertices));
  }
  CHECK_FALSE(std::filesystem::exists(journal));
}

TEST_CASE("what a killed hunt has left stays, and so does what could not be saved", "[longer]") {
  const TemporaryFolder folder;
  const std::filesystem::path left = folder.path() / "hunt-4.jsonl";
  const std::filesystem::path own = folder.path() / "hunt-4-2.jsonl";
  write_file(left, "of another hunt\n");
  SECTION("a hunt has a file of its own") {
    const Hunt hunt = hunt_saving_to(folder.path(), [&] { CHECK(std::filesystem::exists(own)); });
    REQUIRE(has_failed(hunt.campaign.result));
    CHECK_FALSE(std::filesystem::exists(own));
  }
  SECTION("a folder that takes no finding and no worst case") {
    write_file(folder.path() / "regressions", "");
    write_file(folder.path() / "worst", "");
    const Hunt hunt = hunt_saving_to(folder.path(), [] {});
    CHECK(hunt.campaign.saving.unwritten > 1);
    CHECK_THAT(InputFile(own.string()).read_all(), Catch::Contains("\"vertices\""));
  }
  CHECK(InputFile(left.string()).read_all() == "of another hunt\n");
}

TEST_CASE("cases to begin with are the first, and are bred from") {
  HuntPlan plan = plan_of(make_clip(), make_clip(), 2000, 1);
  plan.compares = false;
  for (std::uint64_t i = 0; i < 10; ++i) {
    plan.founders.push_back(generate(77, *find_regime("sliver"), i));
  }
  std::vector<CaseNumber> met;
  const Shared<std::array<std::uint64_t, 10>> seen;
  plan.on_hunted = [&](CaseNumber number, const JudgedPair& judged) {
    if (number < 10 && judged.truth->pair() == plan.founders[number]) ++(*seen)[number];
  };
  run(plan);
  for (const std::uint64_t count : *seen) CHECK(count == 1);
}

TEST_CASE("what a hunt looks for the worst of is all that it keeps the worst of") {
  HuntPlan plan = plan_of(make_clip(), make_clip(), 2000, 1);
  plan.measure = Measure::bound_share;
  const Hunt hunt = run(plan);
  CHECK(hunt.worst.size() == 3);
  for (const WorstFound& found : hunt.worst) CHECK(measure_of(found.gauge) == Measure::bound_share);
}

TEST_CASE("each bug that is planted to be rare is met by a case that is well posed") {
  // Line i is the first case that meets bug i in the hunts of seeds 1 to 3.
  const std::filesystem::path file = source_dir() / "tests" / "hunting" / "rare_bugs.jsonl";
  const Corpus met = read_corpus({&file, 1});
  REQUIRE(met.cases.size() == rare_bugs().size());
  for (std::size_t i = 0; i < met.cases.size(); ++i) {
    CAPTURE(rare_bugs()[i].name);
    CHECK((rare_bugs_met_by(exact::Truth(met.cases[i].pair())) >> i & 1) != 0);
  }
}

TEST_CASE("what the files of the worst cases say is so") {
  Interruption interruption;
  std::size_t compared = 0;
  const std::filesystem::path worst = source_dir() / "corpus" / "worst";
  for (const ColliderEntry& entry : colliders()) {
    if (!std::filesystem::is_directory(worst / entry.name)) continue;
    const auto found = installed_collider(entry.name);
    if (!found) continue;
    const Collider& collider = *found;
    for (std::size_t k = 0; k < kGauges; ++k) {
      const auto gauge = static_cast<Gauge>(k);
      const auto file = worst_file(source_dir() / "corpus", collider.declaration.name, gauge);
      if (!std::filesystem::exists(file)) continue;
      CAPTURE(file);
      const CorpusCase known = read_case_file(file.string());
      const auto observed = observed_now(collider, known.pair(), interruption);
      REQUIRE(observed);
      CHECK(known.note == note_of_worst(gauge, (*observed)[gauge]));
      ++compared;
    }
  }
  CHECK(compared > 0);
}
