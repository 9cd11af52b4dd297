#include "campaign/save.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <string_view>

#include <fmt/format.h>

#include "base/text.hpp"
#include "campaign/in_child.hpp"
#include "campaign/result.hpp"

namespace manifuzz {
namespace {

/// Until when one finding is shrunk, and until when all of them are.
struct Deadlines {
  Deadline of_shrinking;
  Deadline of_all;
};

/// The first of so many that are left has a second, though there may be none for the last ones: in
/// less a program has hardly started.
Deadlines deadlines_of(const Clock::time_point& end, std::size_t left) {
  return {std::min(end, std::max(*share_of(end, left), after(1))), end};
}

/// Until when anybody is asked about a finding: once it is shrunk, its answers are recorded.
Deadline end_of_asking(const Deadlines& deadlines) {
  constexpr std::chrono::seconds to_answer{2};
  return std::max(*deadlines.of_shrinking, Clock::now()) + to_answer;
}

/// So many findings in a row, and nobody is asked any more once there is no time for shrinking.
constexpr int kInVainMax = 3;

constexpr std::string_view kNotAsked = " Nobody was asked again: there was no time.";

/// Where those of each kind are kept; pair cases by their verdicts.
constexpr std::array<const char*, std::variant_size_v<AnyCase>> kFolderOfKind{"", "sequences"};

/// How a finding was saved.
struct SavedFinding {
  bool is_small = false;    ///< as small as can be
  bool is_as_seen = false;  ///< nobody was asked again, or not to the end
  bool is_answered = true;  ///< asked again, both gave answers
};

/// What the campaign saw of the finding's worst case.
Judgement judgement_seen(const Finding& finding) {
  const WorstError& error = finding.tally.error;
  Judgement seen{.bucket = finding.bucket, .magnitude = error.magnitude};
  seen.of_subject.errors = seen.of_oracle.errors = error.errors;
  return seen;
}

/// Writes the finding as the campaign saw it.
SavedFinding save_unasked(Finding& finding, const Found& found, const Plan& plan,
                          const std::filesystem::path& corpus) {
  const AnyCase worst = plan.work->draw(plan, finding.tally.worst);
  CorpusCase saved = plan.work->trial(plan)->unasked(worst, judgement_seen(finding));
  saved.found = found;
  saved.found->is_unshrunk = true;
  saved.note += kNotAsked;
  const auto folder = corpus / corpus_folder(worst, finding.bucket, plan.oracle.declaration.name);
  finding.file = write_corpus_case(folder, saved).string();
  return {.is_as_seen = true, .is_answered = false};
}

/// Shrinks the finding's worst witness, until there is no more time, and writes it to the corpus,
/// and beside it the worst as it was seen; sets `file`. Throws UserError where it cannot be
/// written, and Interrupted where there was no answer at all.
SavedFinding save_shrunk(Finding& finding, const Found& found, const Plan& plan,
                         const std::filesystem::path& corpus, const Deadlines& deadlines,
                         Interruption& interruption) {
  SavedFinding how;
  const auto trial = plan.work->trial(plan);
  const auto recorded = [&](const AnyCase& any, const Judgement& judgement) {
    CorpusCase saved;
    try {
      const Deadline severity_until = has_passed(deadlines.of_all)
                                          ? deadlines.of_all
                                          : std::max(*deadlines.of_shrinking, after(1));
      saved = trial->recorded(any, judgement, interruption, severity_until);
    } catch (const Interrupted&) {
      how.is_as_seen = true;
      saved = trial->unasked(any, judgement);
      saved.note += kNotAsked;
    }
    saved.found = found;
    return saved;
  };
  const AnyCase worst = plan.work->draw(plan, finding.tally.worst);
  const Judgement of_worst = trial->judge(worst, interruption);
  how.is_answered = !is_of_lost(of_worst.bucket);
  const auto folder = corpus / corpus_folder(worst, finding.bucket, plan.oracle.declaration.name);
  if (of_worst.bucket != finding.bucket) {
    CorpusCase unrepeated = recorded(worst, {.bucket = finding.bucket,
                                             .magnitude = finding.tally.error.magnitude,
                                             .frame = of_worst.frame});
    unrepeated.note += fmt::format(" Asked again, alone, it is {}.", to_string(of_worst.bucket));
    finding.file = write_corpus_case(folder, unrepeated).string();
    how.is_small = true;
    return how;
  }
  // One that a collider cannot take shows nothing that a smaller one shows better.
  Smallest smallest{worst, finding.bucket.verdict == Verdict::unsupported};
  if (!smallest.complete && interruption.state() == Interruption::State::running &&
      !has_passed(deadlines.of_all)) {
    unless_interrupted(
        [&] { smallest = trial->shrink(worst, interruption, deadlines.of_shrinking); });
  }
  Judgement of_smallest = of_worst;
  unless_interrupted([&] { of_smallest = trial->judge(smallest.any, interruption); });
  CorpusCase saved = recorded(smallest.any, of_smallest);
  saved.found->is_unshrunk = !smallest.complete;
  const auto file = write_corpus_case(folder, saved);
  finding.file = file.string();
  if (worst != smallest.any) write_worst_case(file, recorded(worst, of_worst));
  how.is_small = smallest.complete;
  return how;
}

/// Saves the finding, as the campaign saw it where there is no answer.
SavedFinding save_finding(Finding& finding, const Tally& tally, const Plan& plan,
                          const std::filesystem::path& corpus, const Deadlines& deadlines,
                          Interruption& interruption) {
  const Found found = found_at(finding, tally, plan);
  if (interruption.is_stopped()) return save_unasked(finding, found, plan, corpus);
  try {
    return save_shrunk(finding, found, plan, corpus, deadlines, interruption);
  } catch (const Interrupted&) {
    return save_unasked(finding, found, plan, corpus);
  }
}

}  // namespace

Found found_at(const Finding& finding, const Tally& tally, const Plan& plan) {
  const CaseNumber number = finding.tally.worst;
  Found found{.seed = plan.seed,
              .regime = std::string(plan.regimes[plan.regime_of(number)]->name),
              .index = plan.index_of(number),
              .versions = {}};
  for (const Declaration& asked : asked_by(plan)) found.versions[asked.name] = asked.version;
  if (is_unexplained(finding.bucket.verdict)) found.seen = seen_of(finding, tally, plan);
  return found;
}

std::filesystem::path corpus_folder(const AnyCase& any, const Bucket& bucket,
                                    const std::string& oracle) {
  if (kind_of(any) != CaseKind::pair) return kFolderOfKind.at(any.index());
  switch (bucket.verdict) {
    case Verdict::tie:
      return "ties";
    case Verdict::known:
    case Verdict::oracle_wrong:
      return std::filesystem::path("defects") / oracle;
    case Verdict::agree:
    case Verdict::ill_posed:
    case Verdict::unsupported:
      return "seeds";
    default:
      return "regressions";
  }
}

std::filesystem::path corpus_folder(const CorpusCase& known) {
  if (!known.property.empty()) return "regressions";
  const Expectation expect = known.expect.value_or(Expectation{});
  return corpus_folder(known.any, find_bucket(expect.bucket).value_or(Bucket{}), expect.oracle);
}

Saving save_new(std::vector<Finding>& found, const Tally& tally, const Plan& plan,
                const SaveTo& save_to, Interruption::State begins,
                const std::function<void(const std::string&)>& on_finding) {
  Interruption all({.begins = begins, .stopped_at = save_to.deadline});
  Saving saving;
  std::vector<Finding*> left;
  for (Finding& finding : found) {
    if (finding.is_new) left.push_back(&finding);
  }
  const Clock::time_point end = after(save_to.shrink_seconds);
  int in_vain = 0;  // findings in a row
  for (std::size_t i = 0; i < left.size(); ++i) {
    Finding& finding = *left[i];
    if (all.is_called_off()) {
      ++saving.unsaved;
      continue;
    }
    const bool is_shrunk = all.state() == Interruption::State::running;
    on_finding(fmt::format("{} {} ({} of {})", is_shrunk ? "shrinking" : "saving",
                           to_string(finding.bucket), i + 1, left.size()));
    const Deadlines deadlines = deadlines_of(end, left.size() - i);
    const bool is_given_up = in_vain >= kInVainMax && has_passed(end);
    Interruption::Limits limits{.begins = is_given_up ? Interruption::State::stopped : all.state()};
    limits.stopped_at = earlier(save_to.deadline, end_of_asking(deadlines));
    Interruption asking(limits);
    try {
      const SavedFinding how =
          save_finding(finding, tally, plan, save_to.folder, deadlines, asking);
      in_vain = how.is_answered && !how.is_as_seen ? 0 : in_vain + 1;
      if (!how.is_small) ++saving.unshrunk;
      if (how.is_as_seen) ++saving.as_seen;
    } catch (const UserError& error) {
      ++saving.unwritten;
      if (saving.first_error.empty()) saving.first_error = error.what();
    }
  }
  saving.interrupted = all.is_signalled();
  return saving;
}

std::string unwritten_in_words(const Saving& saving) {
  if (saving.unwritten == 0) return "";
  return fmt::format("{} could not be saved: {}", counted(saving.unwritten, "finding"),
                     saving.first_error);
}

}  // namespace manifuzz
