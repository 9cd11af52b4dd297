#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <map>
#include <set>
#include <vector>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "campaign/in_child.hpp"
#include "canary/search.hpp"
#include "canary/worst_cases.hpp"
#include "corpus/shrink.hpp"
#include "exchange/json.hpp"
#include "generating/regime.hpp"
#include "oracle/box2d/box2d.hpp"

// What the shrinker and the buckets make of each planted bug, over many seeds: how many forms it
// comes down to, how plain they are, what they cost, and how far a bucket's name tells one bug from
// another. MANIFUZZ_SEEDS says how many seeds (100), MANIFUZZ_BUG of which bug alone; those in the
// kernels, which are copies of the clean code's, only if named.

namespace manifuzz::canary {
namespace {

std::string text_of(const PairCase& pair) {
  std::string text;
  append_case_line(text, pair);
  return text;
}

template <class Number>
Number median(std::vector<Number> numbers) {
  const auto middle = numbers.begin() + static_cast<std::ptrdiff_t>(numbers.size() / 2);
  std::nth_element(numbers.begin(), middle, numbers.end());
  return *middle;
}

constexpr std::uint64_t kCampaign = 20'000;

/// What came of one bug.
struct Forms {
  std::map<std::string, std::map<std::string, int>> by_look;  ///< look, shrunk case: how often
  std::set<std::string> simplest;                             ///< the simplest case of each seed
  int seeds = 0;                                              ///< in which it was caught
  int wrong = 0;                                              ///< cases in all campaigns
  int gross = 0;                                              ///< of those
  std::vector<int> vertices, digits, evaluations;
  std::vector<double> shrink_ms;

  void add(const Sighting& sighting) {
    const PairCase& pair = sighting.shrunk.pair;
    ++by_look[sighting.noticed.look][text_of(pair)];
    vertices.push_back(pair.a.polygon.count + pair.b.polygon.count);
    digits.push_back(digits_of(pair));
    evaluations.push_back(sighting.shrunk.evaluations);
    shrink_ms.push_back(1000 * sighting.shrink_seconds);
  }
  bool is_gross() const { return 2 * gross > wrong; }
  std::size_t distinct() const {
    std::size_t all = 0;
    for (const auto& [look, forms] : by_look) all += forms.size();
    return all;
  }
};

/// Adds what a small campaign saves: the worst of each bucket, shrunk; or, where the judge notices
/// nothing there, what is noticed first.
void add_campaign(Forms& forms, const PlantedBug& bug, std::uint64_t seed) {
  std::optional<PairCase> simplest;
  const auto add = [&](const Sighting& sighting) {
    forms.add(sighting);
    const PairCase& pair = sighting.shrunk.pair;
    if (!simplest || complexity(pair) < complexity(*simplest)) simplest = pair;
  };
  if (bug.collider) {
    const Collider subject = bug.collider();
    Interruption interruption;
    const WorstCases found = worst_cases(subject, seed, kCampaign);
    forms.wrong += found.wrong;
    forms.gross += found.gross;
    for (const auto& [look, worst] : found.by_bucket) {
      const auto start = Clock::now();
      Sighting sighting{{"judge of clip", look}, "", 0, 0, {}};
      sighting.shrunk = shrink_finding(worst.second, subject, make_box2d(), interruption);
      sighting.shrink_seconds = seconds_since(start);
      add(sighting);
    }
  }
  if (!simplest) {
    if (const auto caught = bug.search({seed, bug.cases_max})) add(*caught);
  }
  if (!simplest) return;
  ++forms.seeds;
  forms.simplest.insert(text_of(*simplest));
}

std::map<std::string, int> looks_of(const Forms& forms) {
  std::map<std::string, int> counts;
  for (const auto& [look, cases] : forms.by_look) {
    for (const auto& [form, count] : cases) counts[look] += count;
  }
  return counts;
}

std::string forms_heading() {
  return fmt::format("{:<35} {:>6} {:>6} {:>9} {:>7} {:>6} {:>13} {:>11} {:>16} {:>12}\n",
                     "planted bug", "caught", "gross", "simplest", "buckets", "forms",
                     "vertices, max", "digits, max", "evaluations, max", "ms, max");
}

std::string row(const std::string& name, const Forms& forms) {
  const auto most = [](const auto& numbers) {
    return *std::max_element(numbers.begin(), numbers.end());
  };
  return fmt::format(
      "{:<35} {:>6} {:>6} {:>9} {:>7} {:>6} {:>8}, {:>3} {:>7}, {:>2} {:>8}, {:>6} {:>5.0f}, "
      "{:>5.0f}\n",
      name, forms.seeds, forms.is_gross() ? "yes" : "no", forms.simplest.size(),
      forms.by_look.size(), forms.distinct(), median(forms.vertices), most(forms.vertices),
      median(forms.digits), most(forms.digits), median(forms.evaluations), most(forms.evaluations),
      median(forms.shrink_ms), most(forms.shrink_ms));
}

/// Where a sighting's bucket alone is known: how often the likeliest bug is the right guess, every
/// bug being as frequent as any other. And how often a bug shows in its most frequent bucket.
std::string purity(const std::map<std::string, Forms>& bugs) {
  std::map<std::string, double> likeliest;
  double in_main_bucket = 0;
  for (const auto& [bug, forms] : bugs) {
    double main_share = 0;
    for (const auto& [look, count] : looks_of(forms)) {
      const double share = static_cast<double>(count) / static_cast<double>(forms.vertices.size());
      likeliest[look] = std::max(likeliest[look], share);
      main_share = std::max(main_share, share);
    }
    in_main_bucket += main_share;
  }
  double right = 0;
  for (const auto& [look, share] : likeliest) right += share;
  const double count = static_cast<double>(bugs.size());
  return fmt::format(
      "{} bugs in {} buckets: the bucket alone names the bug for {:.0f}% (by chance {:.0f}%); a "
      "bug "
      "shows in its most frequent bucket in {:.0f}%\n",
      bugs.size(), likeliest.size(), 100 * right / count, 100 / count,
      100 * in_main_bucket / count);
}

/// Among bugs whose cases are gross for the most part: how many have one simplest form.
std::string simplest_forms(const std::map<std::string, Forms>& bugs) {
  int gross = 0;
  int with_one = 0;
  int with_few = 0;
  for (const auto& [bug, forms] : bugs) {
    if (!forms.is_gross()) continue;
    ++gross;
    if (forms.simplest.size() == 1) ++with_one;
    if (forms.simplest.size() <= 4) ++with_few;
  }
  return fmt::format("{} of {} gross bugs have one simplest form, {} at most 4\n", with_one, gross,
                     with_few);
}

}  // namespace
}  // namespace manifuzz::canary

using namespace manifuzz::canary;

TEST_CASE("the forms of each planted bug over many seeds", "[.seeds]") {
  const char* const wanted_seeds = std::getenv("MANIFUZZ_SEEDS");
  const char* const wanted_bug = std::getenv("MANIFUZZ_BUG");
  const std::uint64_t seeds =
      wanted_seeds == nullptr ? 100 : std::strtoull(wanted_seeds, nullptr, 10);
  std::map<std::string, Forms> bugs_in_collider;
  std::cout << forms_heading();
  for (const PlantedBug& bug : planted_bugs()) {
    const bool wanted = wanted_bug == nullptr ? !bug.in_kernel : bug.name == wanted_bug;
    if (is_unedited(bug) || !wanted) continue;
    Forms forms;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
      add_campaign(forms, bug, seed);
    }
    REQUIRE(!forms.vertices.empty());
    std::cout << row(bug.name, forms) << std::flush;
    if (!forms.by_look.contains("twin")) bugs_in_collider[bug.name] = forms;
    if (wanted_bug == nullptr) continue;
    for (const auto& [look, cases] : forms.by_look) {
      for (const auto& [form, count] : cases)
        std::cout << count << ' ' << look << ' ' << form << '\n';
    }
  }
  std::cout << purity(bugs_in_collider) << simplest_forms(bugs_in_collider);
}
