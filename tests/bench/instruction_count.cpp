// What scripts/guard counts the instructions of: one pass of a subject of `manifuzz bench` over
// fixed cases, or what a job of a campaign does with its cases. Callgrind collects within
// `manifuzz_counted` alone.
//
//   manifuzz_instruction_count                 what counts depend on: compiler and build
//   manifuzz_instruction_count NAME INPUT      a pass; prints the kernels' instruction set
//   manifuzz_instruction_count campaign cases  a thousand cases; prints the same

#include <algorithm>
#include <cstdio>
#include <functional>
#include <memory>
#include <string>

#include "campaign/run.hpp"
#include "kernel/target.hpp"
#include "measure/bench/bench.hpp"
#include "oracle/box2d/box2d.hpp"
#include "own_colliders/own_colliders.hpp"

extern "C" [[gnu::noinline]] void manifuzz_counted(const std::function<void()>& pass) {
  pass();
}

using namespace manifuzz;

namespace {

/// AVX2, the widest that valgrind runs; where there is none, the widest there is.
std::string target() {
  const std::vector<std::string> targets = kernel::targets();
  const auto avx2 = std::ranges::find(targets, "AVX2");
  return avx2 == targets.end() ? targets.front() : *avx2;
}

/// From its numbers to the tally.
void run_case(const Plan& plan, CaseNumber number, Tally& tally) {
  const PairCase pair = plan.pair(number);
  const exact::Truth on_stack(pair);
  const std::shared_ptr<const exact::Truth> truth = exact::unowned(on_stack);
  const Answer of_subject = plan.subject.collide(pair);
  const Answer of_oracle = plan.oracle.collide(pair);
  const Judgement judgement =
      judgement_on(plan, number, truth, {plan.subject.declaration, of_subject},
                   {plan.oracle.declaration, of_oracle});
  tally.add(plan.regime_of(number), number, standing(*truth), judgement);
}

std::function<void()> campaign_pass() {
  constexpr CaseNumber cases = 1000;
  const auto plan = std::make_shared<Plan>();
  plan->subject = make_clip();
  plan->oracle = make_box2d();
  plan->regimes = {find_regime("generic")};
  plan->seed = 1;
  const auto tally = std::make_shared<Tally>();
  return [=] {
    for (CaseNumber number = 0; number < cases; ++number) run_case(*plan, number, *tally);
  };
}

/// None where there is no such subject for the instruction set.
std::function<void()> bench_pass(const std::string& name, const std::string& input,
                                 const std::string& used) {
  const std::vector<BenchSubject> all = own_subjects();
  const auto subject = std::ranges::find_if(all, [&](const BenchSubject& c) {
    return c.name == name && c.input == input && c.query == "manifold" &&
           (c.target.empty() || c.target == used);
  });
  const auto workload = draw_workload({.regime = find_regime("generic"), .vertices = {}}, 1);
  if (subject == all.end() || !workload) return {};
  return subject->prepare(*workload);
}

int count(const std::string& name, const std::string& input) {
  const std::string used = target();
  const std::function<void()> pass =
      name == "campaign" ? campaign_pass() : bench_pass(name, input, used);
  if (!pass) {
    std::fprintf(stderr, "there is nothing to count for %s, %s\n", name.c_str(), input.c_str());
    return 2;
  }
  kernel::use_target(used);
  pass();  // whatever only the first pass does
  manifuzz_counted(pass);
  std::puts(used.c_str());
  return 0;
}

}  // namespace

int main(int arguments, char** argument) {
  if (arguments == 3) return count(argument[1], argument[2]);
  std::puts(MANIFUZZ_BUILD);
}
