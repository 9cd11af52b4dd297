#include "hunting/archive.hpp"

#include <map>
#include <set>
#include <tuple>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "hunting/elite.hpp"

using namespace manifuzz;

namespace {

/// An observation with all of its bins alike but for one condition.
Observation observed(int bin, Condition other, int its_bin) {
  Observation of{.is_there = true, .is_well_posed = true};
  for (std::size_t i = 0; i < kConditions; ++i) {
    of.conditions[static_cast<Condition>(i)] = static_cast<std::uint8_t>(bin);
  }
  of.conditions[other] = static_cast<std::uint8_t>(its_bin);
  return of;
}

/// A case that is told by its number.
PairCase numbered(int number) {
  PairCase pair;
  pair.a.pose.position.x() = static_cast<float>(number);
  return pair;
}

int number_of(const Archive& archive, Archive::Set set, std::size_t k) {
  return static_cast<int>(archive[archive.cell(set, k).entry].pair.a.pose.position.x());
}

constexpr std::size_t kPairsOfConditions = kConditions * (kConditions - 1) / 2;

}  // namespace

TEST_CASE(
    "a first case fills a cell for each pair of conditions, and for each figure beside labels") {
  Archive archive;
  const auto taken = archive.add(observed(1, Condition::tilt, 2), 0.5, [] { return numbered(1); });
  CHECK(taken.new_cells == kPairsOfConditions + 3 + 3 + 8);
  CHECK(taken.entry.has_value());
  CHECK(archive.cell_count(Archive::Set::pairs) == kPairsOfConditions);
  CHECK(archive.cell_count() == taken.new_cells);
}

TEST_CASE("each set has a cell for its labels with a bin of its figures, and for nothing else") {
  using enum Archive::Set;
  const auto new_cells = [](Condition condition) {
    Archive archive;
    const auto counted = [&] {
      return std::array{archive.cell_count(labels), archive.cell_count(kinds),
                        archive.cell_count(counts)};
    };
    archive.add(observed(1, condition, 1), 0.5, [] { return numbered(1); });
    const auto before = counted();
    archive.add(observed(1, condition, 2), 0.5, [] { return numbered(1); });
    auto more = counted();
    for (std::size_t set = 0; set < more.size(); ++set) more[set] -= before[set];
    return more;
  };
  using Cells = std::array<std::size_t, 3>;
  CHECK(new_cells(Condition::reference_face) == Cells{3, 0, 0});
  CHECK(new_cells(Condition::corners) == Cells{3, 3, 0});
  CHECK(new_cells(Condition::count_b) == Cells{3, 3, 8});
  CHECK(new_cells(Condition::tilt) == Cells{1, 1, 1});
  CHECK(new_cells(Condition::radius_of_a) == Cells{0, 0, 1});
  CHECK(new_cells(Condition::turn_of_a) == Cells{0, 0, 0});
}

TEST_CASE("a cell keeps the first of the greatest") {
  Archive archive;
  const Observation same = observed(3, Condition::depth, 3);
  archive.add(same, 0.5, [] { return numbered(1); });
  archive.add(same, 0.5, [] { return numbered(2); });
  CHECK(number_of(archive, Archive::Set::pairs, 0) == 1);
  archive.add(same, 0.6, [] { return numbered(3); });
  archive.add(same, 0.4, [] { return numbered(4); });
  CHECK(number_of(archive, Archive::Set::pairs, 0) == 3);
  CHECK(archive.cell(Archive::Set::pairs, 0).visits == 4);
}

TEST_CASE("a case that is held stays when it has lost its last cell") {
  Archive archive;
  const Observation same = observed(3, Condition::depth, 3);
  const EntryId first = *archive.add(same, 0.5, [] { return numbered(1); }).entry;
  archive.hold(first);
  archive.add(same, 0.6, [] { return numbered(2); });
  archive.add(observed(4, Condition::depth, 4), 0.1, [] { return numbered(3); });
  CHECK(archive[first].pair == numbered(1));
  archive.let_go(first);
  // Its place is free now, and taken by the next one.
  CHECK(*archive.add(observed(5, Condition::depth, 5), 0.1, [] { return numbered(4); }).entry ==
        first);
}

TEST_CASE("whatever is added, each cell of pairs has what a plain map of them has") {
  const bool holds =
      rc::check([](const std::vector<std::tuple<unsigned, unsigned, unsigned>>& all) {
        Archive archive;
        std::map<std::tuple<std::size_t, std::size_t, int, int>, std::pair<double, int>> plain;
        int number = 0;
        for (const auto& [bin, its_bin, level] : all) {
          const Observation of =
              observed(static_cast<int>(bin % 3), Condition::gap, static_cast<int>(its_bin % 3));
          const double value = level % 5;
          ++number;
          archive.add(of, value, [&] { return numbered(number); });
          for (std::size_t i = 0; i < kConditions; ++i) {
            for (std::size_t j = i + 1; j < kConditions; ++j) {
              const auto key =
                  std::tuple(i, j, int{of.conditions.all()[i]}, int{of.conditions.all()[j]});
              const auto [at, is_new] = plain.try_emplace(key, value, number);
              if (!is_new && value > at->second.first) at->second = {value, number};
            }
          }
        }
        std::multiset<int> kept;
        std::multiset<int> expected;
        for (std::size_t k = 0; k < archive.cell_count(Archive::Set::pairs); ++k) {
          kept.insert(number_of(archive, Archive::Set::pairs, k));
        }
        for (const auto& [key, cell] : plain) expected.insert(cell.second);
        RC_ASSERT(kept == expected);
      });
  CHECK(holds);
}

TEST_CASE("the greatest are those of gauges that have any, the greatest first") {
  Archive archive;
  Elite elite(aim_at({}));
  CHECK(elite.by_gauge().empty());
  Observation right = observed(3, Condition::depth, 3);
  std::vector<EntryId> added;
  for (const double share : {0.25, 0.5, 0.5, 0.125}) {
    right[Gauge::position_share] = share;
    const auto entry = elite.add(right, {}, archive, [&] { return numbered(1); });
    if (entry) added.push_back(*entry);
  }
  REQUIRE(added.size() == 3);
  CHECK(elite.by_gauge() == std::vector<std::vector<EntryId>>{{added[1], added[0], added[2]}});
}

TEST_CASE("the greatest of a gauge are 512, and a case that is no longer one of them is let go") {
  Archive archive;
  Elite elite(aim_at({}));
  Observation right = observed(3, Condition::depth, 3);
  constexpr int cases = 600;
  for (int i = 1; i <= cases; ++i) {
    right[Gauge::depth_share] = static_cast<double>(i) / cases;
    elite.add(right, {}, archive, [&] { return numbered(i); });
  }
  const std::vector<EntryId> greatest = elite.by_gauge().at(0);
  CHECK(greatest.size() == 512);
  CHECK(archive[greatest.front()].pair == numbered(cases));
  CHECK(archive[greatest.back()].pair == numbered(cases - 511));
  CHECK(archive.all().size() == 512);
}
