#include "campaign/in_child.hpp"
#include "canary/blame.hpp"
#include "canary/planted.hpp"
#include "canary/search.hpp"
#include "judging/extent.hpp"

// Bugs planted into the methods other than clipping: a campaign against clipping in double must
// blame them.

namespace manifuzz::canary {
namespace {

/// Whether a collider's points span all of a contact of polygons.
bool spans_all(const Collider& collider, const PairCase& pair) {
  const exact::Truth truth(pair);
  const Answer answer = collider.collide(pair);
  const Manifold<double>* const manifold = manifold_in(answer);
  if (is_round(pair) || manifold == nullptr || manifold->count == 0) return false;
  const Declaration& declaration = collider.declaration;
  return extent_left_out(truth, declaration.tie_bias, bounds(pair, declaration, truth.extent()),
                         *manifold)
             .share() == 0.0;
}

/// One that may give less than the whole extent is to give as much as it does without bugs.
Collider as_good_as(const Collider& right, Collider planted) {
  const auto collide = planted.collide;
  Collider promising = planted;
  promising.declaration.one_point_enough = false;
  promising.collide = [right, collide](const PairCase& pair) -> Answer {
    if (!spans_all(right, pair)) return Unsupported{"it never spans all of this contact"};
    return collide(pair);
  };
  return promising;
}

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
    for (const MakeMethod make : makes) {
      const Collider planted = with_bug(bug, make());
      subjects.push_back(planted);
      if (planted.declaration.name == "perturbed") {
        subjects.push_back(as_good_as(make_perturbed(), planted));
      }
    }
    add_method(bug, subjects);
  }
  return true;
}

}  // namespace manifuzz::canary
