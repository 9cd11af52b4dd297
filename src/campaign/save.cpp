#include "campaign/save.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "base/text.hpp"
#include "campaign/in_child.hpp"
#include "campaign/result.hpp"
#include "campaign/sequences/save_sequence.hpp"
#include "exchange/json.hpp"
#include "oracle/exact/curve.hpp"

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
                                        Interruption& interruption) {
  if (finding.verdict == Verdict::agree) return std::nullopt;
  std::optional<Neighbourhood> map;
  Interruption::Limits limits = interruption.until_signal();
  if (interruption.state() == Interruption::State::running) {
    map = whole_map(pair, subject, oracle, limits);
  }
  if (!map && !interruption.is_stopped()) {
    const auto in_a_second = Clock::now() + std::chrono::seconds(1);
    limits.stopped_at = std::min(limits.stopped_at.value_or(in_a_second), in_a_second);
    map = whole_map(pair, subject, oracle, limits);
  }
  if (!map) return std::nullopt;
  const Severity found = severity(*map, finding);
  if (found.valid == 0) return std::nullopt;
  return std::round(found.share() * 1000) / 1000;
}

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

/// Shrinks the finding's worst witness, until there is no more time, and writes it to the corpus,
/// and beside it the worst as it was seen; sets `file`. Whether it is as small as can be. Throws
/// UserError where it cannot be written, and Interrupted.
bool save_finding(Finding& finding, const Tally& tally, const Plan& plan,
                  const std::filesystem::path& corpus, const Deadlines& deadlines,
                  Interruption& interruption) {
  const Found found = found_at(finding, tally, plan);
  if (plan.sequences) {
    return save_sequence(finding, found, plan, corpus, deadlines.of_shrinking, interruption);
  }
  const auto judged = [&](const PairCase& pair) {
    return judge_in_child(pair, plan.subject, plan.oracle, interruption);
  };
  const auto recorded = [&](const PairCase& pair, const Judgement& judgement) {
    CorpusCase saved =
        recorded_case(pair, judgement, plan.subject, plan.oracle, interruption, deadlines.of_all);
    saved.found = found;
    return saved;
  };
  const PairCase worst = plan.pair(finding.tally.worst);
  const Judgement of_worst = judged(worst);
  const auto folder = corpus / corpus_folder(finding.bucket, plan.oracle.declaration.name);
  if (of_worst.bucket != finding.bucket) {
    CorpusCase unrepeated = recorded(worst, {finding.bucket, finding.tally.error.magnitude});
    unrepeated.note += fmt::format(" Asked again, alone, it is {}.", to_string(of_worst.bucket));
    finding.file = write_corpus_case(folder, unrepeated).string();
    return true;
  }
  // One that a collider cannot take shows nothing that a smaller one shows better.
  Shrunk smallest{.pair = worst, .complete = finding.bucket.verdict == Verdict::unsupported};
  if (!smallest.complete && interruption.state() == Interruption::State::running &&
      !has_passed(deadlines.of_all)) {
    smallest =
        shrink_finding(worst, plan.subject, plan.oracle, interruption, deadlines.of_shrinking);
  }
  CorpusCase saved = recorded(smallest.pair, judged(smallest.pair));
  saved.found->is_unshrunk = !smallest.complete;
  const auto file = write_corpus_case(folder, saved);
  finding.file = file.string();
  if (worst != smallest.pair) write_worst_case(file, recorded(worst, of_worst));
  return smallest.complete;
}

}  // namespace

Found found_at(const Finding& finding, const Tally& tally, const Plan& plan) {
  const CaseNumber number = finding.tally.worst;
  Found found{.seed = plan.seed,
              .regime = std::string(plan.regimes[plan.regime_of(number)]->name),
              .index = plan.index_of(number),
              .versions = {}};
  for (const Collider* collider : {&plan.subject, &plan.oracle}) {
    found.versions[collider->declaration.name] = collider->declaration.version;
  }
  if (plan.sequences) found.versions.erase(std::string(kJudgeName));
  if (is_unexplained(finding.bucket.verdict)) found.seen = seen_of(finding, tally, plan);
  return found;
}

std::filesystem::path corpus_folder(const Bucket& bucket, const std::string& oracle) {
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
  if (known.is_sequence()) return "sequences";
  if (!known.property.empty()) return "regressions";
  const auto bucket = known.expect ? find_bucket(known.expect->bucket) : std::nullopt;
  return bucket ? corpus_folder(*bucket, known.expect->oracle) : "seeds";
}

CorpusCase recorded_case(const PairCase& pair, const Judgement& judgement, const Collider& subject,
                         const Collider& oracle, Interruption& interruption,
                         const Deadline& severity_until) {
  CorpusCase recorded;
  recorded.pair = pair;
  Expectation& expect = recorded.expect.emplace(Expectation{
      .subject = subject.declaration.name,
      .oracle = oracle.declaration.name,
      .verdict = std::string(to_string(judgement.bucket.verdict)),
      .bucket = to_string(judgement.bucket),
      .manifolds = {},
      .severity = has_passed(severity_until)
                      ? std::nullopt
                      : recorded_severity(pair, judgement.bucket, subject, oracle, interruption)});
  if (judgement.bucket.verdict != Verdict::agree) {
    expect.magnitude = judgement.magnitude;
    if (judgement.bucket.fault != Fault::none) expect.errors = error_of(judgement).errors;
  }
  for (const Manifold<double>& right : right_manifolds(admissible(pair, subject.declaration))) {
    expect.manifolds.push_back({std::string(kJudgeName), without_negative_zeros(right)});
  }
  std::string ends;
  for (const Collider* collider : {&subject, &oracle}) {
    const Answer answer = ask_in_child(*collider, pair, interruption);
    if (const auto why = why_lost(pair, {collider->declaration, answer})) {
      ends += fmt::format(" {}: {}.", collider->declaration.name, *why);
    }
    if (!std::holds_alternative<Lost>(answer)) {
      expect.manifolds.push_back({collider->declaration.name, without_negative_zeros(answer)});
    }
  }
  recorded.note = note_of(pair, judgement, subject, oracle) + ends;
  return recorded;
}

Saving save_new(std::vector<Finding>& found, const Tally& tally, const Plan& plan,
                const SaveTo& save_to, Interruption::State begins,
                const std::function<void(const std::string&)>& on_finding) {
  Interruption signals;
  Interruption interruption({.begins = begins, .stopped_at = save_to.deadline});
  Saving saving;
  std::vector<Finding*> left;
  for (Finding& finding : found) {
    if (finding.is_new) left.push_back(&finding);
  }
  const Clock::time_point end = after(save_to.shrink_seconds);
  for (std::size_t i = 0; i < left.size(); ++i) {
    Finding& finding = *left[i];
    if (interruption.is_stopped()) {
      ++saving.unsaved;
      continue;
    }
    const bool is_shrunk = interruption.state() == Interruption::State::running;
    on_finding(fmt::format("{} {} ({} of {})", is_shrunk ? "shrinking" : "saving",
                           to_string(finding.bucket), i + 1, left.size()));
    try {
      const Deadlines deadlines = deadlines_of(end, left.size() - i);
      const bool is_small =
          save_finding(finding, tally, plan, save_to.folder, deadlines, interruption);
      if (!is_small) ++saving.unshrunk;
    } catch (const Interrupted&) {
      ++saving.unsaved;
    } catch (const UserError& error) {
      if (saving.first_error.empty()) saving.first_error = error.what();
    }
  }
  saving.interrupted = signals.state() != Interruption::State::running;
  return saving;
}

}  // namespace manifuzz
