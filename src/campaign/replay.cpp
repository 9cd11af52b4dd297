#include "campaign/replay.hpp"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <tuple>

#include <fmt/format.h>

#include "campaign/in_child.hpp"
#include "judging/properties.hpp"
#include "process/shared_memory.hpp"

namespace manifuzz {
namespace {

namespace fs = std::filesystem;

bool is_against_subject(const Bucket& bucket) {
  return is_failure(bucket) && bucket.fault != Fault::oracle;
}

bool was_against_subject(const Expectation& expect) {
  return expect.bucket.starts_with("subject/") || expect.bucket.starts_with("both/");
}

/// What a child that checks a property leaves behind.
struct OutcomeSlot {
  Outcome::Kind kind = Outcome::Kind::holds;
  SharedText<512> why;
};

Replayed replay_property(const CorpusCase& recorded, const Collider& subject,
                         Interruption& interruption) {
  const Property* const property = find_property(recorded.property);
  if (property == nullptr) {
    return {false, fmt::format("a property named {}", recorded.property), "there is none"};
  }
  const std::string sentence(property->sentence);
  const Shared<OutcomeSlot> slot;
  const auto body = [&] {
    const Outcome outcome = check(*property, subject, recorded.pair);
    slot->kind = outcome.kind;
    slot->why.set(outcome.why);
  };
  const Ending ending = run_in_child(body, case_seconds_max(subject, subject), interruption);
  if (ending == Ending::stopped) throw Interrupted();
  if (ending == Ending::crashed) return {false, sentence, "crashed"};
  if (ending == Ending::timed_out) return {false, sentence, "timed_out"};
  return {slot->kind != Outcome::Kind::fails, sentence, slot->why.str()};
}

/// Nothing where there was no time for it.
std::optional<Replayed> replay_in_time(const CorpusCase& recorded, const Collider& subject,
                                       const Collider& oracle, Interruption& interruption) {
  if (interruption.is_stopped()) return std::nullopt;
  try {
    const Replayed replayed = replay_case(recorded, subject, oracle, interruption);
    return interruption.is_stopped() ? std::nullopt : std::optional(replayed);
  } catch (const Interrupted&) {
    return std::nullopt;
  }
}

}  // namespace

Replayed replay_case(const CorpusCase& recorded, const Collider& subject, const Collider& oracle,
                     Interruption& interruption) {
  if (!recorded.property.empty()) return replay_property(recorded, subject, interruption);
  const Judgement judgement = judge_in_child(recorded.pair, subject, oracle, interruption);
  const std::string got = to_string(judgement.bucket);
  const std::string verdict(to_string(judgement.bucket.verdict));
  if (is_against_subject(judgement.bucket)) {
    return {false, fmt::format("{} to be right", subject.declaration.name), got};
  }
  for (const LedgerEntry& entry : ledger()) {
    const bool is_witness =
        oracle.declaration.name == entry.collider &&
        fs::path(recorded.path).filename() == fs::path(entry.witness).filename();
    if (is_witness && judgement.explanation != &entry) {
      return {false, fmt::format("a witness of {}", entry.id), got};
    }
  }
  const bool same_pair = recorded.expect && recorded.expect->subject == subject.declaration.name &&
                         recorded.expect->oracle == oracle.declaration.name;
  if (same_pair && !was_against_subject(*recorded.expect)) {
    const auto& [expected_bucket, expected_verdict] =
        std::tie(recorded.expect->bucket, recorded.expect->verdict);
    if (!expected_bucket.empty() && expected_bucket != got) return {false, expected_bucket, got};
    if (!expected_verdict.empty() && expected_verdict != verdict) {
      return {false, expected_verdict, verdict};
    }
  }
  return {true, got, got};
}

std::size_t ReplayRun::failed() const {
  return static_cast<std::size_t>(
      std::ranges::count_if(cases, [](const ReplayedCase& one) { return !one.result.passed; }));
}

ReplayRun replay_cases(const std::vector<CorpusCase>& cases, const Collider& subject,
                       const Collider& oracle, Interruption& interruption) {
  ReplayRun run{subject.declaration.name, oracle.declaration.name, {}};
  const auto start = Clock::now();
  for (const CorpusCase& recorded : cases) {
    const auto case_start = Clock::now();
    const auto replayed = replay_in_time(recorded, subject, oracle, interruption);
    if (!replayed) break;
    run.cases.push_back({&recorded, *replayed, seconds_since(case_start)});
  }
  run.left_out = cases.size() - run.cases.size();
  run.seconds = seconds_since(start);
  return run;
}

}  // namespace manifuzz
