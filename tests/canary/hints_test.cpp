#include "campaign/hints/hints.hpp"

#include <map>
#include <string_view>

#include <catch2/catch.hpp>

#include "campaign/run.hpp"
#include "canary/planted.hpp"
#include "generating/regime.hpp"
#include "own_colliders/own_colliders.hpp"

// Bugs planted into a collider are no mistakes of an adapter, and no hint may say that they are.

namespace manifuzz::canary {
namespace {

/// A collider with a bug in it.
struct Planted {
  Bug bug;
  Collider collider;
};

std::vector<Planted>& planted() {
  static std::vector<Planted> all;
  return all;
}

struct Hinted {
  std::uint64_t wrong = 0;
  std::vector<Hint> hints;
};

Hinted hints_about(const Collider& subject, bool is_round) {
  Plan plan;
  plan.subject = subject;
  plan.oracle = make_clip64();
  for (const Regime& regime : regimes()) {
    if (regime.is_round == is_round && regime.name != "corpus") plan.regimes.push_back(&regime);
  }
  plan.seed = 1;
  plan.cases = 3000;
  plan.jobs = 2;
  Interruption interruption;
  const JobsResult run =
      run_jobs(plan, {0, plan.cases_max()}, interruption, [](const Progress&) {});
  return {run.tally->unexplained(), hints_of(*run.tally, plan, interruption)};
}

/// The planted bugs that are what an adapter does wrong.
const std::map<std::string_view, std::string_view> kMistakes{
    {"world_frame", "undeclared-world"},
    {"rotation_length_ignored", "unit-rotation"},
    {"local_length_ignored", "float-figures"},
};

void check_unnamed(const Bug& bug, const Collider& collider, const Hinted& hinted) {
  INFO(bug.name << " in " << collider.declaration.name);
  const auto mistake = kMistakes.find(bug.name);
  for (const Hint& hint : hinted.hints) {
    INFO(hint.mistake << ": " << hint.text);
    CHECK(hint.mistake == (mistake == kMistakes.end() ? "" : mistake->second));
  }
}

/// Checks each, of which at least so many must have been wrong often enough for a hint.
void check_unnamed(Collider (*of)(const Collider& collider), std::size_t telling_min) {
  std::size_t telling = 0;
  for (const auto& [bug, collider] : planted()) {
    const Hinted hinted = hints_about(of(collider), bug.is_round());
    if (hinted.wrong >= kHintedMin) ++telling;
    check_unnamed(bug, of(collider), hinted);
  }
  CHECK(telling >= telling_min);
}

}  // namespace

bool add_colliders(const std::vector<Bug>& bugs, const MakeCollider& make) {
  for (const Bug& bug : bugs) planted().push_back({bug, with_bug(bug, make(0))});
  return true;
}

bool add_round_colliders(const std::vector<Bug>& bugs, const MakeCollider& make,
                         MakeWithSecondPoint /*make_with_second_point*/) {
  return add_colliders(bugs, make);
}

Collider with_bug(const Bug& bug, Collider collider) {
  collider.collide = [bug, collide = collider.collide](const PairCase& pair) {
    const Acting acting(bug);
    return collide(pair);
  };
  collider.in_double = [bug, make = collider.in_double] { return with_bug(bug, make()); };
  return collider;
}

}  // namespace manifuzz::canary

using namespace manifuzz;
using namespace manifuzz::canary;

TEST_CASE("no hint takes a bug of a collider in float for a mistake of its adapter") {
  check_unnamed([](const Collider& collider) { return collider; }, 40);
}

TEST_CASE("no hint takes a bug of a collider in double for a mistake of its adapter") {
  check_unnamed([](const Collider& collider) { return collider.in_double(); }, 40);
}
