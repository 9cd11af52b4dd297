#include "campaign/pairs/recorded_case.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "base/text.hpp"
#include "campaign/in_child.hpp"
#include "exact/curve.hpp"
#include "exchange/json.hpp"
#include "judging/unjudged.hpp"

namespace manifuzz {
namespace {

std::string note_of(const PairCase& pair, const Judgement& judgement, const Collider& subject,
                    const Collider& oracle) {
  if (judgement.explanation != nullptr) {
    return fmt::format("{}: {}.", judgement.explanation->id, judgement.explanation->description);
  }
  const Bucket& bucket = judgement.bucket;
  return fmt::format("{} against {}: {} ({}), the {} being {:.3g}.", subject.declaration.name,
                     oracle.declaration.name, to_string(bucket.verdict),
                     name_of(bucket.kind, kKindNames),
                     is_round(pair) ? "separation" : "greatest separation",
                     exact::separation_of(exact::Truth(pair)));
}

/// What a corpus file keeps of an answer, for people: signs of zeros say nothing there.
Answer without_negative_zeros(Answer answer) {
  auto* manifold = std::get_if<Manifold<double>>(&answer);
  if (auto* const partial = std::get_if<PartialManifold>(&answer)) manifold = &partial->manifold;
  if (manifold == nullptr) return answer;
  manifold->normal = manifuzz::without_negative_zeros(manifold->normal);
  for (ContactPoint<double>& point : manifold->points) {
    point.position = manifuzz::without_negative_zeros(point.position);
    point.depth += 0;
  }
  return answer;
}

/// The map of the neighbours, unless it is stopped before all of them are asked.
std::optional<Neighbourhood> whole_map(const PairCase& pair, const Collider& subject,
                                       const Collider& oracle, const Interruption::Limits& limits) {
  // A fair sample of the map's cells: the share is right to about 0.01, in about 15 ms.
  constexpr int cells_max = 1000;
  Interruption interruption(limits);
  const Grid grid = grid_around(exact::Truth(pair));
  Neighbourhood map = ask_neighbourhood(pair, subject, oracle, grid, cells_max, interruption);
  return interruption.is_stopped() ? std::nullopt : std::optional(std::move(map));
}

/// The share of the neighbours that fail alike, to three digits; none where nobody is at fault and
/// nothing differs, or where there is no time: once there is hurry, there is a second for it.
std::optional<double> recorded_severity(const PairCase& pair, const Bucket& finding,
                                        const Collider& subject, const Collider& oracle,
                                        Interruption& interruption, const Deadline& until) {
  if (finding.verdict == Verdict::agree || has_passed(until)) return std::nullopt;
  std::optional<Neighbourhood> map;
  Interruption::Limits limits = interruption.until_signal();
  limits.stopped_at = earlier(limits.stopped_at, until);
  if (interruption.state() == Interruption::State::running) {
    map = whole_map(pair, subject, oracle, limits);
  }
  if (!map && !interruption.is_stopped() && !has_passed(limits.stopped_at)) {
    limits.stopped_at = earlier(limits.stopped_at, after(1));
    map = whole_map(pair, subject, oracle, limits);
  }
  if (!map) return std::nullopt;
  const Severity found = severity(*map, finding);
  if (found.valid == 0) return std::nullopt;
  return std::round(found.share() * 1000) / 1000;
}

}  // namespace

CorpusCase unasked_case(const PairCase& pair, const Judgement& judgement, const Collider& subject,
                        const Collider& oracle) {
  CorpusCase recorded;
  recorded.any = pair;
  Expectation& expect = recorded.expect.emplace(
      Expectation{.subject = subject.declaration.name,
                  .oracle = oracle.declaration.name,
                  .verdict = std::string(to_string(judgement.bucket.verdict)),
                  .bucket = to_string(judgement.bucket),
                  .manifolds = {}});
  if (judgement.bucket.verdict != Verdict::agree) {
    expect.magnitude = judgement.magnitude;
    if (judgement.bucket.fault != Fault::none) expect.errors = error_of(judgement).errors;
  }
  for (const Manifold<double>& right : right_manifolds(admissible(pair, subject.declaration))) {
    expect.manifolds.push_back({std::string(kJudgeName), without_negative_zeros(right)});
  }
  recorded.note = note_of(pair, judgement, subject, oracle);
  return recorded;
}

CorpusCase recorded_case(const PairCase& pair, const Judgement& judgement, const Collider& subject,
                         const Collider& oracle, Interruption& interruption,
                         const Deadline& severity_until) {
  CorpusCase recorded = unasked_case(pair, judgement, subject, oracle);
  recorded.expect->severity =
      recorded_severity(pair, judgement.bucket, subject, oracle, interruption, severity_until);
  for (const Collider* collider : {&subject, &oracle}) {
    const Answer answer = ask_in_child(*collider, pair, interruption);
    if (const auto why = why_lost(pair, {collider->declaration, answer})) {
      recorded.note += fmt::format(" {}: {}.", collider->declaration.name, *why);
    }
    if (!std::holds_alternative<Lost>(answer)) {
      recorded.expect->manifolds.push_back(
          {collider->declaration.name, without_negative_zeros(answer)});
    }
  }
  return recorded;
}

}  // namespace manifuzz
