#include "campaign/sequences/sequence_plan.hpp"

#include <fmt/format.h>

#include "base/text.hpp"
#include "exchange/json.hpp"
#include "sequence/motions.hpp"

namespace manifuzz {
namespace {

/// A motion's name, where regimes are counted.
const Regime* named_after(const Motion& motion) {
  static const std::vector<Regime> all = [] {
    std::vector<Regime> regimes;
    for (const Motion& one : motions()) regimes.push_back({one.name, one.description, nullptr});
    return regimes;
  }();
  return find_by_name(all, motion.name);
}

}  // namespace

Collider as_declared(const SequenceCollider& subject) {
  Collider declared;
  declared.declaration = subject.declaration;
  return declared;
}

Collider no_oracle() {
  return {};
}

void plan_sequences(Plan& plan, const SequenceCollider& subject,
                    std::span<const std::string> names) {
  plan.subject = as_declared(subject);
  plan.oracle = no_oracle();
  plan.oracle.declaration.name = kJudgeName;
  plan.sequences = {subject, chosen_by_name(motions(), names, "motion", "--regime")};
  if (names.empty()) {
    std::erase_if(plan.sequences->motions, [&](const Motion* motion) {
      return !has_taken(*motion, [&](const Sequence& drawn) { return takes(subject, drawn); });
    });
  }
  if (plan.sequences->motions.empty()) {
    throw UserError(
        fmt::format("{} takes no shapes that any motion has", subject.declaration.name));
  }
  for (const Motion* const motion : plan.sequences->motions) {
    plan.regimes.push_back(named_after(*motion));
  }
}

}  // namespace manifuzz
