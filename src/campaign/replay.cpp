#include "campaign/replay.hpp"

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <tuple>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/text.hpp"
#include "campaign/in_child.hpp"
#include "campaign/property_failure.hpp"
#include "engines/asked_engines.hpp"

namespace manifuzz {
namespace {

namespace fs = std::filesystem;

/// What is known of a collider that keeps points has to come again.
bool was_against_subject(const Expectation& expect) {
  return (expect.bucket.starts_with("subject/") && !expect.bucket.starts_with("subject/known/")) ||
         expect.bucket.starts_with("both/");
}

/// What becomes of a failure that may be accepted by that key.
Replayed failed_unless_accepted(const std::string& key, const WorstError& error, const Known& known,
                                const std::string& expected, const std::string& got) {
  const KnownAs as = known_as(key, error, known);
  if (as.acceptance == nullptr) return {false, expected, got};
  if (!as.is_accepted()) return {false, expected, fmt::format("{}: {}", got, as.objection)};
  return {.passed = true, .expected = got, .got = got, .is_accepted = true};
}

Replayed replay_property(const CorpusCase& recorded, const Collider& subject, const Known& known,
                         Interruption& interruption) {
  const Property* const property = find_by_name(properties(), recorded.property);
  if (property == nullptr) {
    return {false, fmt::format("a property named {}", recorded.property), "there is none"};
  }
  const std::string sentence(property->sentence);
  const PropertyOutcome outcome = check_in_child(*property, subject, recorded.pair(), interruption);
  const bool fails = outcome.kind == PropertyOutcome::Kind::fails;
  if (!fails && !takes(subject, recorded.pair())) {
    return {.expected = sentence, .got = "", .is_unsupported = true};
  }
  if (!fails) {
    return {
        .passed = true, .expected = sentence, .got = "", .is_stale = recorded.accepted.has_value()};
  }
  return failed_unless_accepted(finding_key(property->name, subject.declaration.name),
                                {outcome.magnitude, {}}, known, sentence, outcome.why);
}

/// Replays a case on which the subject is wrong.
Replayed replay_wrong(const CorpusCase& recorded, const Judgement& judgement,
                      const Collider& subject, const Collider& oracle, const Known& known) {
  const std::string expected = fmt::format("{} to be right", subject.declaration.name);
  const std::string got = to_string(judgement.bucket);
  const bool is_again = recorded.expect && !recorded.expect->bucket.empty() &&
                        is_bucket(got, recorded.expect->bucket);
  if (!is_again) return {false, expected, got};
  const std::string key =
      finding_key(Expectation{subject.declaration.name, oracle.declaration.name, "", got, {}});
  return failed_unless_accepted(key, worst_error(judgement), known, expected, got);
}

/// What came of it: where the oracle's ledger is not in this program, what was known when the case
/// was recorded is taken to be so still.
Bucket bucket_with_ledger(const CorpusCase& recorded, const Bucket& bucket,
                          const Collider& oracle) {
  Bucket taken = bucket;
  const bool was_known = recorded.expect && recorded.expect->verdict == to_string(Verdict::known);
  if (was_known && is_unexplained(bucket.verdict) && bucket.fault == Fault::oracle &&
      is_without_ledger(oracle.declaration.name)) {
    taken.verdict = Verdict::known;
  }
  return taken;
}

/// What that makes of the verdict on a case.
Replayed replayed(const CorpusCase& recorded, const Judgement& judgement, const Collider& subject,
                  const Collider& oracle, const Known& known) {
  const Bucket bucket = bucket_with_ledger(recorded, judgement.bucket, oracle);
  const std::string got = to_string(bucket);
  const std::string verdict(to_string(bucket.verdict));
  if (is_failure(judgement.bucket) && judgement.bucket.fault != Fault::oracle) {
    return replay_wrong(recorded, judgement, subject, oracle, known);
  }
  const bool is_unsupported = judgement.bucket.verdict == Verdict::unsupported;
  const bool shows_nothing = is_unsupported || judgement.bucket.verdict == Verdict::ill_posed;
  for (const LedgerEntry& entry : ledger()) {
    const bool is_witness =
        !shows_nothing && oracle.declaration.name == entry.collider &&
        fs::path(recorded.path).filename() == fs::path(witness_of(entry)).filename();
    if (is_witness && judgement.explanation != &entry) {
      return {false, fmt::format("a witness of {}", entry.id), got};
    }
  }
  const bool same_pair = recorded.expect && recorded.expect->subject == subject.declaration.name &&
                         recorded.expect->oracle == oracle.declaration.name;
  // What is accepted may go, and is stale then; it may not become another mistake.
  const bool may_go = recorded.accepted && !is_unexplained(judgement.bucket.verdict);
  if (same_pair && !was_against_subject(*recorded.expect) && !may_go) {
    const auto& [expected_bucket, expected_verdict] =
        std::tie(recorded.expect->bucket, recorded.expect->verdict);
    if (!is_bucket(got, expected_bucket)) return {false, expected_bucket, got};
    if (!expected_verdict.empty() && expected_verdict != verdict) {
      return {false, expected_verdict, verdict};
    }
  }
  if (is_unsupported) return {.expected = got, .got = got, .is_unsupported = true};
  return {.passed = true,
          .expected = got,
          .got = got,
          .is_stale = is_stale(recorded, got, subject, oracle)};
}

}  // namespace

Replayed replay_case(const CorpusCase& recorded, const Trial& trial, const Known& known,
                     Interruption& interruption) {
  if (!trial.is_there()) return {.expected = "", .got = "", .is_unsupported = true};
  if (!recorded.property.empty()) {
    return replay_property(recorded, trial.subject(), known, interruption);
  }
  return replayed(recorded, trial.judge(recorded.any, interruption), trial.subject(),
                  trial.oracle(), known);
}

namespace {

std::size_t count_of(const std::vector<ReplayedCase>& cases, const auto& is_counted) {
  return static_cast<std::size_t>(std::ranges::count_if(cases, is_counted, &ReplayedCase::result));
}

}  // namespace

std::size_t ReplayRun::failed() const {
  return count_of(cases, &Replayed::has_failed);
}

std::size_t ReplayRun::unsupported() const {
  return count_of(cases, &Replayed::is_unsupported);
}

std::size_t ReplayRun::accepted() const {
  return count_of(cases, &Replayed::is_accepted);
}

std::vector<std::string> ReplayRun::stale() const {
  std::vector<std::string> files;
  for (const ReplayedCase& one : cases) {
    if (one.result.is_stale) files.push_back(one.recorded->path);
  }
  return files;
}

std::vector<Declaration> ReplayRun::declarations() const {
  std::map<std::string, Declaration> by_name;
  for (const ReplayedCase& one : cases) {
    for (const Collider* const asked : {&one.trial->subject(), &one.trial->oracle()}) {
      by_name.emplace(asked->declaration.name, asked->declaration);
    }
  }
  by_name.erase("");  // the judge
  std::vector<Declaration> all;
  all.reserve(by_name.size());
  for (const auto& [name, declaration] : by_name) all.push_back(declaration);
  return all;
}

void ReplayRun::add(const ReplayRun& run) {
  const auto append = [](std::string& names, const std::string& more) {
    if (!names.empty() && !more.empty()) names += ", ";
    names += more;
  };
  append(subject, run.subject);
  append(oracle, run.oracle);
  cases.insert(cases.end(), run.cases.begin(), run.cases.end());
  unasked.insert(unasked.end(), run.unasked.begin(), run.unasked.end());
  seconds += run.seconds;
  left_out += run.left_out;
}

ReplayRun replay_cases(const std::vector<CorpusCase>& cases, const TrialOf& trial_of,
                       const Known& known, Interruption& interruption) {
  ReplayRun run;
  std::set<std::string> subjects;
  std::set<std::string> oracles;
  const auto start = Clock::now();
  try {
    for (const CorpusCase& recorded : cases) {
      const auto case_start = Clock::now();
      if (interruption.is_stopped()) break;
      const auto trial = trial_of(recorded);
      if (trial == nullptr) {
        run.unasked.push_back(&recorded);
        continue;
      }
      const Replayed result = replay_case(recorded, *trial, known, interruption);
      if (interruption.is_stopped()) break;
      run.cases.push_back({&recorded, result, seconds_since(case_start), trial});
      subjects.insert(trial->subject().declaration.name);
      oracles.insert(trial->oracle().declaration.name);
    }
  } catch (const Interrupted&) {
    // This one is left out too.
  }
  run.subject = fmt::format("{}", fmt::join(subjects, ", "));
  run.oracle = fmt::format("{}", fmt::join(oracles, ", "));
  run.left_out = cases.size() - run.cases.size() - run.unasked.size();
  run.seconds = seconds_since(start);
  return run;
}

std::vector<CheckedProperty> check_properties(
    const std::vector<const Property*>& chosen, const Collider& subject, const PropertyPlan& plan,
    const Known& known, const Deadline& deadline, const std::string& save_to,
    const std::function<void(const CheckedProperty&)>& on_checked) {
  std::vector<CheckedProperty> all;
  Interruption signals(kUntilSignal);
  for (const Property* const property : chosen) {
    const auto start = Clock::now();
    Interruption interruption({.hurried_at = share_of(deadline, chosen.size() - all.size())});
    PropertyPlan in_turn = plan;
    in_turn.interruption = &interruption;
    CheckedProperty checked{property, run_property(*property, subject, in_turn)};
    checked.seconds = seconds_since(start);
    if (!checked.result.passed) settle_failure(checked, subject, known, save_to);
    on_checked(checked);
    all.push_back(checked);
    if (signals.is_stopped()) break;
  }
  return all;
}

}  // namespace manifuzz
