// What properties of a collider measure on as many drawn and hunted cases.
//
//   manifuzz_property_measures draw SEED CASES SUBJECT
//   manifuzz_property_measures hunt SEED CASES SUBJECT
//
// SUBJECT is a collider, or the clip with one of the bugs of rare_bugs.cpp. A line a property: its
// name, the number of the first case that it fails on, from 1 on (0: it holds of all), and the
// greatest measure: the share of its bound, or 1 and the magnitude of a failure.

#include <algorithm>
#include <string_view>
#include <thread>

#include <fmt/format.h>

#include "engines/colliders.hpp"
#include "hunting/arguments.hpp"
#include "hunting/property_hunt.hpp"
#include "hunting/rare_bugs.hpp"
#include "hunting/rare_colliders.hpp"

namespace manifuzz::test {
namespace {

Collider subject_of(std::string_view name) {
  const bool is_bug = std::ranges::count(rare_bugs(), name, &RareBug::name) > 0;
  return is_bug ? with_rare_bug(name) : find_collider(std::string(name));
}

std::vector<HuntedProperty> draw(const PropertyHuntPlan& plan) {
  GenerationContext context;
  narrow_to({plan.subject}, context);
  const std::vector<const Regime*> from = regimes_for({plan.subject}, {});
  std::vector<HuntedProperty> met;
  for (const Property* const property : plan.properties) met.push_back({.property = property});
  for (CaseNumber number = 0; number < plan.cases; ++number) {
    const PairCase pair =
        generate(plan.seed, *from[number % from.size()], number / from.size(), context);
    for (HuntedProperty& one : met) {
      const PropertyOutcome outcome = check(*one.property, plan.subject, pair);
      one.worst = std::max(one.worst, measure_of(outcome));
      if (outcome.kind == PropertyOutcome::Kind::fails && !one.first) one.first = number;
    }
  }
  return met;
}

int table(std::string_view how, const PropertyHuntPlan& plan) {
  Interruption interruption;
  const std::vector<HuntedProperty> met =
      how == "draw" ? draw(plan) : hunt_properties(plan, interruption, [](const auto&) {}).hunted;
  for (const HuntedProperty& one : met) {
    fmt::print("{:<20}{:>12}{:>14.3g}\n", one.property->name, one.first ? *one.first + 1 : 0,
               one.worst);
  }
  return 0;
}

}  // namespace
}  // namespace manifuzz::test

int main(int argc, char** argv) {
  using namespace manifuzz;
  using namespace manifuzz::test;
  const std::string_view way = argc == 5 ? argv[1] : "";
  if ((way != "draw" && way != "hunt") || !number_in(argv[2]) || !number_in(argv[3])) {
    fmt::print(stderr,
               "manifuzz_property_measures: draw or hunt, a seed, a number of cases and a "
               "collider are expected\n");
    return 2;
  }
  PropertyHuntPlan plan{
      .properties = {},
      .subject = subject_of(argv[4]),
      .corpus = {},
      .seed = *number_in(argv[2]),
      .cases = *number_in(argv[3]),
      .jobs = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()))};
  for (const Property& property : properties()) plan.properties.push_back(&property);
  return table(way, plan);
}
