#include "campaign/property_failure.hpp"

#include <filesystem>

#include <fmt/format.h>

#include "base/text.hpp"
#include "campaign/in_child.hpp"
#include "campaign/shrink_in_child.hpp"
#include "process/pool.hpp"

namespace manifuzz {
namespace {

/// What a child that checks a property leaves behind.
struct OutcomeSlot {
  PropertyOutcome::Kind kind = PropertyOutcome::Kind::holds;
  SharedText<512> why;
  double magnitude = 0;
};

/// Writes the failing case to the corpus and returns its path.
std::string save(const std::string& corpus, const Property& property, const Collider& subject,
                 const PropertyResult& result) {
  CorpusCase failing;
  failing.any = *result.failing;
  failing.property = std::string(property.name);
  failing.expect.emplace().subject = subject.declaration.name;
  failing.expect->magnitude = result.magnitude;
  failing.note = fmt::format("{} {}: {}: {}.", subject.declaration.name,
                             subject.declaration.version, property.sentence, result.why);
  return write_corpus_case(std::filesystem::path(corpus) / "regressions", failing).string();
}

}  // namespace

Collider until(const std::function<bool()>& is_over, const Collider& collider) {
  Collider hurried = collider;
  hurried.collide = [collider, is_over](const PairCase& pair) -> Answer {
    Answer answer = Unsupported{"time is up"};
    if (is_over()) return answer;
    if (!collider.is_isolated()) return collider.collide(pair);
    collider.collide_many({&pair, 1}, {&answer, 1}, [&is_over] { return !is_over(); });
    return answer;
  };
  return hurried;
}

PropertyOutcome check_in_child(const Property& property, const Collider& collider,
                               const PairCase& pair, Interruption& interruption) {
  const Shared<OutcomeSlot> slot;
  const auto body = [&] {
    const PropertyOutcome outcome = check(property, collider, pair);
    slot->kind = outcome.kind;
    slot->magnitude = outcome.magnitude;
    slot->why.set(outcome.why);
  };
  const Ending ending = run_in_child(body, case_seconds_max(collider, collider), interruption);
  if (ending == Ending::stopped) throw Interrupted();
  if (ending != Ending::done) {
    PropertyOutcome lost = fails(lost_by(ending).why, slot->magnitude);
    lost.is_lost = true;
    return lost;
  }
  return {.kind = slot->kind, .why = slot->why.str(), .magnitude = slot->magnitude};
}

bool fails_alike(const PropertyOutcome& outcome, const PropertyOutcome& root) {
  return outcome.kind == PropertyOutcome::Kind::fails && outcome.why == root.why &&
         is_about(outcome.magnitude, root.magnitude);
}

PairCase shrink_failure(const Property& property, const Collider& collider, const PairCase& pair,
                        const PropertyOutcome& root, Interruption& interruption) {
  const auto is_alike = [&](const PairCase& candidate, Interruption& shrinking) {
    const Collider hurried = until([&] { return shrinking.is_stopped(); }, collider);
    return fails_alike(check(property, hurried, candidate), root);
  };
  return ShrinkTask<PairCase, PairCase>{
      pair, collider.is_isolated(), case_seconds_max(collider, collider), {}, is_alike}
      .run(interruption)
      .pair;
}

void settle_failure(CheckedProperty& checked, const Collider& subject, const Known& known,
                    const std::string& save_to) {
  const PropertyResult& result = checked.result;
  const KnownAs as = known_as(finding_key(checked.property->name, subject.declaration.name),
                              {result.magnitude, {}}, known);
  checked.objection = as.objection;
  checked.is_accepted = as.is_accepted();
  if (!result.failing || checked.is_accepted || save_to.empty()) return;
  try {
    checked.saved = save(save_to, *checked.property, subject, result);
  } catch (const UserError& error) {
    checked.why_unsaved = error.what();
  }
}

}  // namespace manifuzz
