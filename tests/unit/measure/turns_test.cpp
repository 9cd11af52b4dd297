#include "measure/scene/turns.hpp"

#include <map>
#include <set>

#include <catch2/catch.hpp>

using manifuzz::whose_turn;

TEST_CASE(
    "each has one turn a step, each turn equally often, and follows each other equally often") {
  for (std::size_t count = 3; count <= 9; ++count) {
    CAPTURE(count);
    std::map<std::pair<std::size_t, std::size_t>, int> has_turn;
    std::map<std::pair<std::size_t, std::size_t>, int> follows;
    for (std::size_t step = 0; step < 2 * count; ++step) {
      std::set<std::size_t> all;
      for (std::size_t turn = 0; turn < count; ++turn) {
        const std::size_t who = whose_turn(step, turn, count);
        all.insert(who);
        ++has_turn[{who, turn}];
        if (turn > 0) ++follows[{who, whose_turn(step, turn - 1, count)}];
      }
      CHECK(all.size() == count);
      CHECK(*all.rbegin() == count - 1);
    }
    CHECK(has_turn.size() == count * count);
    for (const auto& [which, times] : has_turn) CHECK(times == 2);
    CHECK(follows.size() == count * (count - 1));
    for (const auto& [which, times] : follows) CHECK(times == 2);
  }
}

TEST_CASE("two take turns, and one has all of them") {
  for (const std::size_t step : {0, 1, 2}) {
    CHECK(whose_turn(step, 0, 2) == 0);
    CHECK(whose_turn(step, 1, 2) == 1);
    CHECK(whose_turn(step, 0, 1) == 0);
  }
}
