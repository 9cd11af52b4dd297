#include "canary/blame.hpp"

#include <memory>

namespace manifuzz::canary {

std::optional<Judgement> blame(const PairCase& pair, const ColliderAnswer& subject,
                               const ColliderAnswer& oracle) {
  const auto truth = std::make_shared<const exact::Truth>(pair);
  if (plainly_agree(*truth, subject, oracle)) return std::nullopt;
  const Judgement judgement = judge(truth, subject, oracle);
  return is_failure(judgement.bucket) ? std::optional(judgement) : std::nullopt;
}

std::optional<Judgement> blame(const PairCase& pair, const Collider& subject,
                               const Collider& oracle) {
  const Answer of_subject = subject.collide(pair);
  const Answer of_oracle = oracle.collide(pair);
  return blame(pair, ColliderAnswer{subject.declaration, of_subject},
               ColliderAnswer{oracle.declaration, of_oracle});
}

}  // namespace manifuzz::canary
