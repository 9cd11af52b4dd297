#include <array>

#include "campaign/in_child.hpp"
#include "canary/blame.hpp"
#include "canary/planted.hpp"
#include "canary/search.hpp"

// Bugs planted into the collider of round shapes: a campaign against the right one in double, which
// takes all of them, must blame it.

namespace manifuzz::canary {
namespace {

const Collider& right_collider() {
  static const Collider collider = make_clip64();
  return collider;
}

void add_round_collider(const Bug& bug, const std::vector<Collider>& subjects) {
  auto& all = planted_round_colliders();
  all.insert(all.end(), subjects.begin(), subjects.end());
  const auto subject_of = [subjects](std::uint64_t number) {
    return subjects[number / round_regimes().size() % subjects.size()];
  };
  const auto search_each = [subject_of](Haystack haystack) {
    haystack.regimes = round_regimes();
    return search(
        haystack,
        [&](std::uint64_t number, const PairCase& pair) -> std::optional<Noticed> {
          const Collider subject = subject_of(number);
          const auto blamed = blame(pair, subject, right_collider());
          if (!blamed) return std::nullopt;
          return Noticed{"judge of " + subject.declaration.name, to_string(blamed->bucket)};
        },
        [&](std::uint64_t number, const PairCase& pair, const Noticed&) {
          Interruption interruption;
          return shrink_finding(pair, subject_of(number), right_collider(), interruption);
        });
  };
  add_planted_bug({.name = bug.name, .cases_max = 400'000, .search = search_each});
}

}  // namespace

std::vector<Collider>& planted_round_colliders() {
  static std::vector<Collider> all;
  return all;
}

bool add_round_colliders(const std::vector<Bug>& bugs, const MakeCollider& make,
                         MakeWithSecondPoint make_with_second_point) {
  for (const Bug& bug : bugs) {
    std::vector<Collider> subjects{make(0), make(0).in_double(),
                                   make_with_second_point(SecondPoint::never()),
                                   make_with_second_point(SecondPoint::within(0.2))};
    for (Collider& subject : subjects) subject = with_bug(bug, std::move(subject));
    add_round_collider(bug, subjects);
  }
  return true;
}

}  // namespace manifuzz::canary
