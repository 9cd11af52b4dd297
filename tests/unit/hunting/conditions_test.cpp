#include "hunting/conditions.hpp"

#include <set>

#include <catch2/catch.hpp>

#include "corpus/corpus.hpp"
#include "generating/regime.hpp"

using namespace manifuzz;

namespace {

/// The unit boxes that overlap by 0.1 in x and lie 0.5 apart in y.
PairCase boxes() {
  return parse_case(R"({"a": {"vertices": [[-1,-1],[1,-1],[1,1],[-1,1]]},
                        "b": {"vertices": [[-1,-1],[1,-1],[1,1],[-1,1]], "position": [1.9,0.5]}})",
                    FormatKey::optional)
      .pair();
}

}  // namespace

TEST_CASE("a figure's bin is its power of ten, nothing having one of its own") {
  CHECK(decade(0, -3) == 0);
  CHECK(decade(-1, -3) == 0);
  CHECK(decade(0.0009, -3) == 1);
  CHECK(decade(0.001, -3) == 2);
  CHECK(decade(0.00999, -3) == 2);
  CHECK(decade(0.01, -3) == 3);
  CHECK(decade(1e30, -3) == kBins - 1);
}

TEST_CASE("two boxes have the conditions that one reads off a drawing") {
  const Conditions of = conditions_of(exact::Truth(boxes()));
  CHECK(of[Condition::count_a] == 4);
  CHECK(of[Condition::count_b] == 4);
  CHECK(of[Condition::corners] == 0);
  CHECK(of[Condition::reference_side] == 1);  // A's face and B's tie: it is A's
  CHECK(of[Condition::reference_face] == 2);  // its second
  CHECK(of[Condition::incident_edge] == 4);   // B's last
  CHECK(of[Condition::points] == 2);
  CHECK(of[Condition::tilt] == 0);
  CHECK(of[Condition::lead_of_side] == 0);
  CHECK(of[Condition::depth] == decade(0.1 / std::sqrt(8.0), -10));
  CHECK(of[Condition::crossing_share] == decade(0.25, -10));
  CHECK(of[Condition::slab_margin] == decade(0.25, -10));
  CHECK(of[Condition::length_ratio] == 0);
  CHECK(of[Condition::turn_of_a] == 0);
  CHECK(of[Condition::radius_of_b] == 0);
}

TEST_CASE("a turn by 45 degrees has a bin of its own") {
  PairCase pair = boxes();
  pair.b.pose.rotation = {0.70710677F, -0.70710677F};
  CHECK(conditions_of(exact::Truth(pair))[Condition::turn_of_b] == kBins - 1);
}

TEST_CASE("every bin is one of the bins, and every condition has several, whatever the regime") {
  std::array<std::set<int>, kConditions> seen;
  for (const Regime& regime : regimes()) {
    for (std::uint64_t index = 0; index < 300; ++index) {
      const Conditions of = conditions_of(exact::Truth(generate(5, regime, index)));
      for (std::size_t i = 0; i < kConditions; ++i) {
        REQUIRE(of.all()[i] < kBins);
        seen[i].insert(of.all()[i]);
      }
    }
  }
  for (std::size_t i = 0; i < kConditions; ++i) {
    CAPTURE(kConditionNames[i]);
    CHECK(seen[i].size() > 2);
  }
}
