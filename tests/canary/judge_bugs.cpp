#include <cmath>

#include "canary/planted.hpp"
#include "canary/search.hpp"
#include "corpus/shrink.hpp"
#include "oracle/box2d/box2d.hpp"
#include "own_colliders/own_colliders.hpp"
#include "support/moved.hpp"
#include "support/twin.hpp"

// Bugs planted into the judge: on answers of colliders right and wrong, it must differ from its
// twin.

namespace manifuzz::canary {
namespace {

/// Whose answers are judged: the right collider, in float and in double, and wrong ones.
const std::vector<Collider>& subjects() {
  static const std::vector<Collider> all = [] {
    std::vector<Collider> made{make_clip(), make_clip64()};
    for (const MakeCollider& make : planted_colliders()) made.push_back(make(0));
    return made;
  }();
  return all;
}

/// Subjects that take round shapes, under policies of the second point too.
const std::vector<Collider>& round_subjects() {
  static const std::vector<Collider> all = [] {
    std::vector<Collider> made{make_clip(), make_clip64()};
    const auto& planted = planted_round_colliders();
    made.insert(made.end(), planted.begin(), planted.end());
    return made;
  }();
  return all;
}

/// Whether an answer is nonsense, written a second time like all else: a figure that is no number,
/// a depth below zero, a feature that is not there.
bool is_nonsense(const PairCase& pair, const Answer& answer) {
  const auto* manifold = std::get_if<Manifold<double>>(&answer);
  if (manifold == nullptr) return false;
  for (int i = 0; i < manifold->count; ++i) {
    const ContactPoint<double>& point = manifold->points[i];
    const bool there = point.features.a.index < pair.a.polygon.count &&
                       point.features.b.index < pair.b.polygon.count;
    const double sum = manifold->normal.sum() + point.position.sum() + point.depth;
    if (!there || !(point.depth >= 0) || !std::isfinite(sum)) return true;
  }
  return false;
}

Bucket twin_bucket(const PairCase& pair, const ColliderAnswer& subject,
                   const ColliderAnswer& oracle) {
  if (is_nonsense(pair, subject.answer)) {
    return {.fault = Fault::subject, .verdict = Verdict::malformed};
  }
  return twin_judge(pair, subject, oracle).bucket;
}

bool differs_from_twin(JudgeOf judge_of, const Bug& bug, std::uint64_t number,
                       const PairCase& pair) {
  static const Collider box2d = make_box2d();
  static const Collider clip64 = make_clip64();
  const Collider& oracle = is_round(pair) ? clip64 : box2d;
  const auto& asked = is_round(pair) ? round_subjects() : subjects();
  Collider subject = asked[number % asked.size()];
  Answer of_subject = subject.collide(pair);
  if (is_round(pair) && number % 4 < 3) {
    // Answers with gross bugs show little of what is right to within a bound.
    Random random(number, "answers", 0);
    subject = random.chance(0.5) ? make_clip() : clip64;
    subject.declaration.second_point = any_policy(random);
    of_subject = moved(subject.collide(pair), pair, subject.declaration, random);
  }
  const Answer of_oracle = oracle.collide(pair);
  const Bucket bucket = [&] {
    const Acting acting(bug);
    return judge_of(pair, subject.declaration, of_subject, oracle.declaration, of_oracle);
  }();
  const Bucket expected = twin_bucket(pair, ColliderAnswer{subject.declaration, of_subject},
                                      ColliderAnswer{oracle.declaration, of_oracle});
  return !(as_twin_has_it(bucket, pair) == as_twin_has_it(expected, pair));
}

}  // namespace

bool add_judges(const std::vector<Bug>& bugs, JudgeOf judge_of) {
  for (const Bug& bug : bugs) {
    add_planted_bug(
        {bug.name, 20'000, [judge_of, bug](Haystack haystack) {
           haystack.regimes = bug.is_round() ? round_regimes() : polygon_regimes();
           return search(
               haystack,
               [&](std::uint64_t number, const PairCase& pair) -> std::optional<Noticed> {
                 if (!differs_from_twin(judge_of, bug, number, pair)) return std::nullopt;
                 return Noticed{"twin", "twin"};
               },
               [&](std::uint64_t number, const PairCase& pair, const Noticed&) {
                 return shrink(pair, [&](const PairCase& smaller) {
                   return differs_from_twin(judge_of, bug, number, smaller);
                 });
               });
         }});
  }
  return true;
}

}  // namespace manifuzz::canary
