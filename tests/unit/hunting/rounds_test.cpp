#include "hunting/rounds.hpp"

#include <algorithm>

#include <catch2/catch.hpp>

#include "engines/colliders.hpp"
#include "hunting/archive_files.hpp"
#include "own_colliders/own_colliders.hpp"
#include "support/run_program.hpp"
#include "support/temporary_folder.hpp"
#include "unit/hunting/small_hunts.hpp"

using namespace manifuzz;
using namespace manifuzz::test;
using Catch::Contains;

namespace {

constexpr Rounds kRounds{.cases = 4000, .rounds = 2, .shares = 3};

ArchiveFolder archives_in(const TemporaryFolder& folder) {
  return {folder.path() / "archives", "a hunt", kRounds, {}};
}

/// A share, which reads the archives of the round before and writes its own.
Hunt run_share(const ArchiveFolder& folder, const RoundShare& share, int jobs) {
  HuntPlan hunt = plan_of(make_clip(), usual_oracle(), 1, jobs);
  hunt.compares = false;
  hunt.rounds = kRounds;
  narrow_to(kRounds, share, hunt.plan);
  hunt.earlier = read_rounds_before(folder, share.round);
  Hunt hunted = run(hunt);
  write_archive(folder, share, hunted.archived);
  return hunted;
}

/// All archives of a hunt whose shares run in this order in each round.
std::vector<std::string> archives_of(const std::vector<std::uint64_t>& shares, int jobs) {
  const TemporaryFolder folder;
  const ArchiveFolder archives = archives_in(folder);
  for (std::uint64_t round = 0; round < kRounds.rounds; ++round) {
    for (const std::uint64_t share : shares) run_share(archives, {round, share}, jobs);
  }
  std::vector<std::string> texts;
  for (std::uint64_t round = 0; round < kRounds.rounds; ++round) {
    for (std::uint64_t share = 0; share < kRounds.shares; ++share) {
      texts.push_back(text_of(archive_file(archives, {round, share})));
    }
  }
  return texts;
}

std::string why_unread(const ArchiveFolder& folder) {
  try {
    read_rounds_before(folder, 1);
  } catch (const UserError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("shares of a hunt's rounds find the same in any order, with any number of jobs") {
  const std::vector<std::string> in_order = archives_of({0, 1, 2}, 1);
  CHECK(in_order == archives_of({2, 0, 1}, 3));
}

TEST_CASE("a round begins with what all shares of the rounds before have found") {
  const TemporaryFolder folder;
  const ArchiveFolder archives = archives_in(folder);
  std::size_t most = 0;
  for (std::uint64_t share = 0; share < kRounds.shares; ++share) {
    most = std::max(most, run_share(archives, {0, share}, 2).cells.all);
  }
  const std::vector<ArchivedCase> best = read_rounds_before(archives, 1);
  Archive all;
  const Aim aim = aim_at({});
  Elite elite(aim);
  for (const ArchivedCase& one : best) add_to(all, elite, one, aim);
  CHECK(all.cell_count() > most);
  CHECK(run_share(archives, {1, 0}, 2).cells.all > all.cell_count());
}

TEST_CASE("the best of archives is the same whatever is added first") {
  const TemporaryFolder folder;
  const ArchiveFolder archives = archives_in(folder);
  std::vector<ArchivedCase> all;
  std::vector<ArchivedCase> by_and_by;
  for (std::uint64_t share = kRounds.shares; share-- > 0;) {
    const std::vector<ArchivedCase> more = run_share(archives, {0, share}, 2).archived;
    all.insert(all.end(), more.begin(), more.end());
    by_and_by.insert(by_and_by.end(), more.begin(), more.end());
    by_and_by = best_of(by_and_by, kRounds, {});
  }
  const std::vector<ArchivedCase> best = best_of(all, kRounds, {});
  CHECK(best.size() < all.size());
  CHECK(best == by_and_by);
  CHECK(best == read_rounds_before(archives, 1));
  std::ranges::reverse(all);
  CHECK(best == best_of(all, kRounds, {}));
}

TEST_CASE("each case of a hunt belongs to one share of one round") {
  for (const Rounds& rounds : {Rounds{17, 2, 3}, Rounds{6, 2, 3}, Rounds{40, 1, 7}}) {
    CaseNumber next = 0;
    for (std::uint64_t round = 0; round < rounds.rounds; ++round) {
      for (std::uint64_t share = 0; share < rounds.shares; ++share) {
        Plan plan;
        narrow_to(rounds, {round, share}, plan);
        CHECK(plan.first == next);
        CHECK(*plan.cases >= 1);
        next += *plan.cases;
      }
    }
    CHECK(next == rounds.cases);
  }
  CHECK_THROWS_WITH(expect_cases_for_all({5, 2, 3}), Contains("too many shares of 5 cases"));
  CHECK_NOTHROW(expect_cases_for_all({6, 2, 3}));
}

TEST_CASE("an archive that is missing, torn or another's is refused, by name") {
  const TemporaryFolder folder;
  ArchiveFolder archives = archives_in(folder);
  for (std::uint64_t share = 0; share < kRounds.shares; ++share) {
    const PairCase pair = generate(4, *find_regime("boxes"), share);
    write_archive(archives, {0, share}, {{share, {.is_there = true, .is_well_posed = true}, pair}});
  }
  const std::filesystem::path path = archive_file(archives, {0, 1});
  const std::string whole = text_of(path);
  const auto refused_as = [&](const std::string& text) {
    write_file(path, text);
    CHECK_THAT(why_unread(archives), Contains("round-0-share-1.archive: is no whole archive"));
  };
  for (std::size_t length = 0; length < whole.size(); length += 7)
    refused_as(whole.substr(0, length));
  refused_as(whole + "\n");
  std::string changed = whole;
  ++changed[whole.size() / 2];
  refused_as(changed);
  refused_as(text_of(archive_file(archives, {0, 2})));
  write_file(path, whole);
  archives.hunt = "another hunt";
  CHECK_THAT(why_unread(archives),
             Contains("round-0-share-0.archive: is of another hunt (a hunt)"));
  archives.hunt = "a hunt";
  std::filesystem::remove(path);
  CHECK_THAT(why_unread(archives), Contains("share-1.archive is not there"));
}
