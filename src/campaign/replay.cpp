#include "campaign/replay.hpp"

#include <fmt/format.h>

#include "campaign/guarded.hpp"
#include "judging/properties.hpp"

namespace manifuzz {
namespace {

bool is_against_subject(const Bucket& bucket) {
  return is_failure(bucket) && bucket.fault != Fault::oracle;
}

bool was_against_subject(const Expectation& expect) {
  return expect.bucket.starts_with("subject/") || expect.bucket.starts_with("both/");
}

Replayed replay_property(const CorpusCase& recorded, const Collider& subject) {
  const Property* const property = find_property(recorded.property);
  if (property == nullptr) {
    return {false, fmt::format("a property named {}", recorded.property), "there is none"};
  }
  const Outcome outcome = check(*property, subject, recorded.pair);
  return {outcome.kind != Outcome::Kind::fails, std::string(property->sentence), outcome.why};
}

}  // namespace

Replayed replay_case(const CorpusCase& recorded, const Collider& subject, const Collider& oracle,
                     Interruption& interruption) {
  if (!recorded.property.empty()) return replay_property(recorded, subject);
  const Judgement judgement = judge_guarded(recorded.pair, subject, oracle, interruption);
  const std::string got = to_string(judgement.bucket);
  if (is_against_subject(judgement.bucket)) {
    return {false, fmt::format("{} to be right", subject.declaration.name), got};
  }
  const bool same_pair = recorded.expect && recorded.expect->subject == subject.declaration.name &&
                         recorded.expect->oracle == oracle.declaration.name;
  if (same_pair && !was_against_subject(*recorded.expect) && recorded.expect->bucket != got) {
    return {false, recorded.expect->bucket, got};
  }
  return {true, got, got};
}

}  // namespace manifuzz
