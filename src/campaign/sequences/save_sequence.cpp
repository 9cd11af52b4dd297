#include "campaign/sequences/save_sequence.hpp"

#include <fmt/format.h>

#include "base/text.hpp"
#include "campaign/in_child.hpp"
#include "campaign/save.hpp"

namespace manifuzz {
namespace {

std::string sequence_note(const SequenceJudgement& judgement, const Declaration& subject,
                          std::size_t frames) {
  const LedgerEntry* const entry = judgement.explanation;
  if (entry != nullptr) return fmt::format("{}: {}.", entry->id, entry->description);
  const Bucket& bucket = judgement.bucket;
  const std::string where = frames == 1
                                ? "its one frame"
                                : fmt::format("frame {} of 0 to {}", judgement.frame, frames - 1);
  return fmt::format("{}: {} ({}) in {}.", subject.name, to_string(bucket.verdict),
                     name_of(bucket.kind, kKindNames), where);
}

}  // namespace

CorpusCase recorded_sequence(const Sequence& sequence, const SequenceJudgement& judgement,
                             const SequenceCollider& subject) {
  CorpusCase recorded;
  recorded.set(sequence);
  Expectation& expect = recorded.expect.emplace();
  expect.subject = subject.declaration.name;
  expect.verdict = to_string(judgement.bucket.verdict);
  expect.bucket = to_string(judgement.bucket);
  if (judgement.bucket.verdict != Verdict::agree) expect.magnitude = judgement.magnitude;
  recorded.note = sequence_note(judgement, subject.declaration, sequence.frames.size());
  return recorded;
}

CorpusCase unasked_sequence(const Finding& finding, const Plan& plan) {
  SequenceJudgement seen;
  seen.bucket = finding.bucket;
  seen.magnitude = finding.tally.error.magnitude;
  const SequenceCollider& subject = plan.sequences->subject;
  CorpusCase recorded = recorded_sequence(plan.sequence(finding.tally.worst), seen, subject);
  recorded.note =
      fmt::format("{}: {} ({}).", subject.declaration.name, to_string(seen.bucket.verdict),
                  name_of(seen.bucket.kind, kKindNames));
  return recorded;
}

bool save_sequence(Finding& finding, const Found& found, const Plan& plan,
                   const std::filesystem::path& corpus, const Deadline& deadline,
                   Interruption& interruption) {
  const SequenceCollider& subject = plan.sequences->subject;
  const auto recorded = [&](const Sequence& sequence, const SequenceJudgement& judgement) {
    CorpusCase saved = recorded_sequence(sequence, judgement, subject);
    saved.found = found;
    return saved;
  };
  const Sequence worst = plan.sequence(finding.tally.worst);
  const SequenceJudgement of_worst = judge_in_child(worst, subject, interruption);
  const CorpusCase as_seen = recorded(worst, of_worst);
  const auto folder = corpus / corpus_folder(as_seen);
  if (of_worst.bucket != finding.bucket) {
    SequenceJudgement unrepeated = of_worst;
    unrepeated.bucket = finding.bucket;
    unrepeated.magnitude = finding.tally.error.magnitude;
    CorpusCase saved = recorded(worst, unrepeated);
    saved.note += fmt::format(" Asked again, alone, it is {}.", to_string(of_worst.bucket));
    finding.file = write_corpus_case(folder, saved).string();
    return true;
  }
  ShrunkSequence smallest{worst, 0, finding.bucket.verdict == Verdict::unsupported};
  if (!smallest.complete && interruption.state() == Interruption::State::running) {
    smallest = shrink_finding(worst, subject, interruption, deadline);
  }
  CorpusCase saved =
      recorded(smallest.sequence, judge_in_child(smallest.sequence, subject, interruption));
  saved.found->is_unshrunk = !smallest.complete;
  const auto file = write_corpus_case(folder, saved);
  finding.file = file.string();
  if (worst != smallest.sequence) write_worst_case(file, as_seen);
  return smallest.complete;
}

CorpusCase shrunk_sequence(const CorpusCase& given, const SequenceCollider& subject,
                           Interruption& interruption) {
  const Sequence sequence = given.sequence();
  const SequenceJudgement root = judge_in_child(sequence, subject, interruption);
  const bool was_begun = given.found && given.found->is_unshrunk;
  if (root.bucket.fault == Fault::none && !was_begun) {
    throw UserError(fmt::format(
        "{}: {} is {} on it; a sequence on which it is wrong is expected", given.path,
        subject.declaration.name,
        root.bucket.verdict == Verdict::agree ? "right" : to_string(root.bucket.verdict)));
  }
  const ShrunkSequence smallest = shrink_finding(sequence, subject, interruption);
  SequenceJudgement of_smallest = root;
  unless_interrupted(
      [&] { of_smallest = judge_in_child(smallest.sequence, subject, interruption); });
  CorpusCase result = recorded_sequence(smallest.sequence, of_smallest, subject);
  result.found = given.found;
  if (result.found) result.found->is_unshrunk = !smallest.complete;
  // What is another mistake by now is not what was accepted.
  const bool is_again = given.expect && is_bucket(result.expect->bucket, given.expect->bucket);
  if (is_again) result.accepted = given.accepted;
  return result;
}

}  // namespace manifuzz
