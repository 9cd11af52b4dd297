#include <catch2/catch.hpp>

#include "campaign/in_child.hpp"
#include "canary/search.hpp"
#include "canary/worst_cases.hpp"
#include "exchange/json.hpp"
#include "oracle/box2d/box2d.hpp"
#include "own_colliders/own_colliders.hpp"
#include "support/named_tests.hpp"

// What a campaign saves of a finding, its worst case and the smallest that it is shrunk to, speaks
// of one bug: of every planted bug, and of each together with a second one that rounds too much.

namespace manifuzz::canary {
namespace {

constexpr std::uint64_t kCases = 2000;
constexpr std::size_t kFindingsMax = 6;  // of a bug, the first by name

/// Far from the origin depths are off by two hundred bounds.
Collider rounding_far_out(Collider collider) {
  collider.collide = [ask = collider.collide,
                      declaration = collider.declaration](const PairCase& pair) {
    Answer answer = ask(pair);
    auto* const manifold = std::get_if<Manifold<double>>(&answer);
    const bool is_far = pair.a.pose.position.cast<double>().norm() > 10 * exact::Truth(pair).size();
    if (manifold == nullptr || !is_far) return answer;
    for (int i = 0; i < manifold->count; ++i) {
      manifold->points[i].depth += 200 * bounds(pair, declaration).separation;
    }
    return answer;
  };
  return collider;
}

bool is_wrong(const PairCase& pair, const Collider& subject) {
  return is_failure(judge(pair, subject, make_box2d()).bucket);
}

void check(const PlantedBug& bug) {
  const Collider planted = bug.collider();
  const Collider rounding = rounding_far_out(make_clip());
  const Collider both = rounding_far_out(planted);
  Interruption interruption;
  std::size_t findings = 0;
  for (const auto& [look, worst] : worst_cases(both, 1, kCases).by_bucket) {
    if (++findings > kFindingsMax) break;
    const auto& [of_worst, pair] = worst;
    const PairCase smallest = shrink_finding(pair, both, make_box2d(), interruption).pair;
    std::string line;
    append_case_line(line, pair);
    append_case_line(line += '\n', smallest);
    INFO(look << "\n" << line);
    const Judgement of_smallest = judge(smallest, both, make_box2d());
    CHECK(is_alike(of_smallest, of_worst));
    const bool is_of_planted = is_wrong(pair, planted) && is_wrong(smallest, planted);
    const bool is_of_rounding = is_wrong(pair, rounding) && is_wrong(smallest, rounding);
    CHECK((is_of_planted || is_of_rounding));
  }
}

[[maybe_unused]] const bool registered = [] {
  test::add_test(
      "a finding's worst and smallest case speak of one bug, of any planted one and "
      "one of rounding",
      "[planted]", [] {
        for (const PlantedBug& bug : planted_bugs()) {
          if (!bug.collider || is_unedited(bug)) continue;
          INFO(bug.name);
          check(bug);
        }
      });
  return true;
}();

}  // namespace
}  // namespace manifuzz::canary
