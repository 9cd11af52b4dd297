// How many evaluations until a bug is met, by drawing and by hunting, for each of the planted bugs.
//
//   manifuzz_rare_bugs draw SEED CASES    how often drawn cases of all regimes meet each bug
//   manifuzz_rare_bugs hunt SEED CASES    the first case of a hunt that meets each bug
//
// A line a bug: its name, and the count or the first case's number, from 1 on; 0: it was not met.

#include <atomic>
#include <string_view>
#include <thread>

#include <fmt/format.h>

#include "campaign/plan.hpp"
#include "campaign/run.hpp"
#include "hunting/arguments.hpp"
#include "hunting/hunt.hpp"
#include "hunting/rare_bugs.hpp"
#include "own_colliders/own_colliders.hpp"

namespace manifuzz::test {
namespace {

using Counts = std::array<std::atomic<std::uint64_t>, 64>;

Plan plan_of(std::uint64_t seed, std::uint64_t cases) {
  Plan plan;
  plan.subject = make_clip();
  plan.oracle = make_clip();
  for (const Regime& regime : regimes()) plan.regimes.push_back(&regime);
  plan.seed = seed;
  plan.cases = cases;
  plan.jobs = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  return plan;
}

void draw(const Plan& plan, Counts& counts) {
  for (CaseNumber number = 0; number < *plan.cases; ++number) {
    const exact::Truth truth(plan.pair(number));
    const std::uint64_t met = rare_bugs_met_by(truth);
    if (met == 0) continue;
    for (std::size_t i = 0; i < rare_bugs().size(); ++i) counts[i] += met >> i & 1;
  }
}

void hunt(const Plan& plan, Counts& firsts) {
  HuntPlan of{.plan = plan, .founders = {}, .measure = {}, .compares = false};
  of.on_hunted = [&](CaseNumber number, const JudgedPair& judged) {
    const std::uint64_t met = rare_bugs_met_by(*judged.truth);
    for (std::size_t i = 0; met >> i != 0; ++i) {
      if ((met >> i & 1) == 0) continue;
      std::uint64_t first = firsts[i];
      while ((first == 0 || number + 1 < first) &&
             !firsts[i].compare_exchange_weak(first, number + 1)) {
      }
    }
  };
  run_hunt(
      of, {}, {},
      {"", {{"machine", ""}, {"compiler", ""}, {"versions", nlohmann::ordered_json::object()}}},
      [](const HuntProgress&) {});
}

int table(std::string_view how, std::uint64_t seed, std::uint64_t cases) {
  const Shared<Counts> counts;
  const Plan plan = plan_of(seed, cases);
  how == "draw" ? draw(plan, *counts) : hunt(plan, *counts);
  for (std::size_t i = 0; i < rare_bugs().size(); ++i) {
    fmt::print("{:<28}{:>12}\n", rare_bugs()[i].name, (*counts)[i].load());
  }
  return 0;
}

}  // namespace
}  // namespace manifuzz::test

int main(int argc, char** argv) {
  using manifuzz::test::number_in;
  const std::string_view way = argc == 4 ? argv[1] : "";
  if ((way != "draw" && way != "hunt") || !number_in(argv[2]) || !number_in(argv[3])) {
    fmt::print(stderr,
               "manifuzz_rare_bugs: draw or hunt, a seed and a number of cases are expected\n");
    return 2;
  }
  return manifuzz::test::table(way, *number_in(argv[2]), *number_in(argv[3]));
}
