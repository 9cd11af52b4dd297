// How near to its bounds a collider's right answers come, by many climbs from drawn cases.
//
//   manifuzz_climbs COLLIDER polygons|round SEED CLIMBS CASES FILE.jsonl [FOUNDER.json]...
//
// So many climbs towards each bound, of so many cases each, up to a third of them from the
// founders. All cases, of polygons with sharp corners or of round shapes, count for every bound. A
// line a bound: its name, and the greatest share that a right answer takes. FILE.jsonl gets the
// case of each, and the cases that were answered wrong, for `manifuzz hunt --from`. The status is 1
// where there are any of these.

#include <algorithm>
#include <atomic>
#include <string_view>
#include <thread>

#include <fmt/format.h>

#include "base/file.hpp"
#include "corpus/corpus.hpp"
#include "engines/colliders.hpp"
#include "hunting/arguments.hpp"
#include "hunting/climb.hpp"

namespace manifuzz::test {
namespace {

struct Climbs {
  Collider collider;
  std::uint64_t seed = 0;
  std::size_t climbs = 0;   ///< towards each summit
  std::uint64_t cases = 0;  ///< of each
  std::vector<PairCase> founders;
};

/// Climbs are dealt to as many threads as there are cores; each writes its own place.
std::vector<Climbed> climb_all(const Summit& summit, const Climbs& of) {
  std::vector<Climbed> climbed(of.climbs);
  std::atomic<std::size_t> next = 0;
  const auto work = [&] {
    for (std::size_t i = next++; i < of.climbs; i = next++) {
      climbed[i] = climb(summit, of.collider, of.founders, of.seed, i, of.cases);
    }
  };
  std::vector<std::jthread> threads;
  for (unsigned i = 0; i < std::max(1U, std::thread::hardware_concurrency()); ++i) {
    threads.emplace_back(work);
  }
  threads.clear();
  return climbed;
}

void append_case(std::string& lines, const PairCase& pair, std::uint64_t seed) {
  append_found_case_line(lines, pair, {seed, std::string(kRegimeOfHunts), 0, {}});
  lines += '\n';
}

/// The greatest share of a summit's bound that any of these climbs met, towards whichever summit.
const Height& highest_of(const Summit& summit, std::span<const Climbed> climbed) {
  const auto share = [&](const Climbed& one) { return one[summit.gauge].share; };
  return (*std::ranges::max_element(climbed, {}, share))[summit.gauge];
}

int table(bool are_round, const Climbs& of, const std::string& file) {
  std::vector<Summit> summits = summits_of(of.collider.declaration);
  std::erase_if(summits, [&](const Summit& summit) { return summit.is_round != are_round; });
  std::vector<Climbed> climbed;
  for (const Summit& summit : summits) {
    const std::vector<Climbed> to_it = climb_all(summit, of);
    climbed.insert(climbed.end(), to_it.begin(), to_it.end());
  }
  std::string lines;
  for (const Summit& summit : summits) {
    const Height& highest = highest_of(summit, climbed);
    fmt::print("{:<24}{:>8.3f}\n", summit.name, highest.share);
    if (highest.share > 0) append_case(lines, highest.pair, of.seed);
  }
  int status = 0;
  for (const Climbed& one : climbed) {
    if (!one.wrong) continue;
    status = 1;
    append_case(lines, *one.wrong, of.seed);
  }
  write_file(file, lines);
  return status;
}

}  // namespace
}  // namespace manifuzz::test

int main(int argc, char** argv) {
  using namespace manifuzz;
  using namespace manifuzz::test;
  const std::string_view shapes = argc < 7 ? "" : argv[2];
  const bool are_shapes = shapes == "polygons" || shapes == "round";
  if (!are_shapes || !number_in(argv[3]) || number_in(argv[4]).value_or(0) == 0 ||
      number_in(argv[5]).value_or(0) == 0) {
    fmt::print(stderr,
               "manifuzz_climbs: a collider, polygons or round, a seed, a number of climbs, a "
               "number of cases in each, a file and maybe founders are expected\n");
    return 2;
  }
  try {
    Climbs of{
        find_collider(argv[1]), *number_in(argv[3]), *number_in(argv[4]), *number_in(argv[5]), {}};
    for (int i = 7; i < argc; ++i) of.founders.push_back(read_case_file(argv[i]).pair());
    return table(shapes == "round", of, argv[6]);
  } catch (const UserError& error) {
    fmt::print(stderr, "manifuzz_climbs: {}\n", error.what());
    return 2;
  }
}
