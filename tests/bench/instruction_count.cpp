// What scripts/guard counts the instructions of: one pass of a subject of `manifuzz bench` over
// fixed cases. Callgrind collects within `manifuzz_counted` alone.
//
//   manifuzz_instruction_count                 what counts depend on: compiler and build
//   manifuzz_instruction_count NAME INPUT      a pass; prints the kernels' instruction set

#include <algorithm>
#include <cstdio>
#include <functional>
#include <string>

#include "kernel/target.hpp"
#include "measure/bench/bench.hpp"

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

int count(const std::string& name, const std::string& input) {
  const std::string used = target();
  const std::vector<BenchSubject> all = own_subjects();
  const auto subject = std::ranges::find_if(all, [&](const BenchSubject& c) {
    return c.name == name && c.input == input && c.query == "manifold" &&
           (c.target.empty() || c.target == used);
  });
  const auto workload = draw_workload({.regime = find_regime("generic"), .vertices = {}}, 1);
  if (subject == all.end() || !workload) {
    std::fprintf(stderr, "there is nothing to count for %s, %s\n", name.c_str(), input.c_str());
    return 2;
  }
  const auto pass = subject->prepare(*workload);
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
