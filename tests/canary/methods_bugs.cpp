#include "campaign/in_child.hpp"
#include "canary/blame.hpp"
#include "canary/planted.hpp"
#include "canary/search.hpp"

// Bugs planted into the methods other than clipping: a campaign against clipping in double must
// blame them.

namespace manifuzz::canary {
namespace {

void add_method(const Bug& bug, const std::vector<Collider>& subjects) {
  const auto subject_of = [subjects](std::uint64_t number) -> const Collider& {
    return subjects[number / regimes().size() % subjects.size()];
  };
  const auto search_each = [subject_of](const Haystack& haystack) {
    const Collider right = make_clip64();
    return search(
        haystack,
        [&](std::uint64_t number, const PairCase& pair) -> std::optional<Noticed> {
          const Collider& subject = subject_of(number);
          const auto blamed = blame(pair, subject, right);
          if (!blamed) return std::nullopt;
          return Noticed{"judge of " + subject.declaration.name, to_string(blamed->bucket)};
        },
        [&](std::uint64_t number, const PairCase& pair, const Noticed&) {
          Interruption interruption;
          return shrink_finding(pair, subject_of(number), right, interruption);
        });
  };
  add_planted_bug({.name = bug.name, .cases_max = 400'000, .search = search_each});
}

}  // namespace

bool add_methods(const std::vector<Bug>& bugs, const std::vector<MakeMethod>& makes) {
  for (const Bug& bug : bugs) {
    std::vector<Collider> subjects;
    for (const MakeMethod make : makes) subjects.push_back(with_bug(bug, make()));
    add_method(bug, subjects);
  }
  return true;
}

}  // namespace manifuzz::canary
