#include "sequence/sequence_judge.hpp"

#include <algorithm>
#include <array>
#include <memory>

#include "sequence/frame_judge.hpp"
#include "sequence/sequence_ledger.hpp"

namespace manifuzz {
namespace {

/// What can be wrong in a frame, most serious first: bodies that fall through each other, or jump
/// apart; what points the wrong way or is of the wrong size; what is at the wrong place; and what
/// was right once.
constexpr std::array kMostSeriousFirst{
    Kind::missed_contact, Kind::phantom_contact, Kind::reversed, Kind::normal,
    Kind::inconsistent,   Kind::not_minimal,     Kind::depth,    Kind::witness,
    Kind::position,       Kind::lingering,       Kind::extent};

/// Less is more serious; what is explained comes after all that is not, and nothing wrong last.
std::size_t place_of(const FrameJudgement& judgement) {
  const auto* const kind = std::ranges::find(kMostSeriousFirst, judgement.kind);
  const auto place = static_cast<std::size_t>(kind - kMostSeriousFirst.begin());
  const bool is_explained = judgement.explanation != nullptr || judgement.kind == Kind::none;
  return is_explained ? place + kMostSeriousFirst.size() : place;
}

bool is_more_serious(const FrameJudgement& p, const FrameJudgement& q) {
  return place_of(p) < place_of(q);
}

Verdict verdict_of(Lost::How how) {
  constexpr std::array verdicts{Verdict::crashed, Verdict::timed_out, Verdict::malformed};
  return verdicts[static_cast<std::size_t>(how)];
}

/// What is said of a frame in which nothing is to be judged.
std::optional<Bucket> bucket_without_points(const Keeping& keeping,
                                            std::span<const KeptAnswer> answers,
                                            std::size_t frame) {
  if (const auto* const lost = std::get_if<Lost>(&answers[frame])) {
    return bucket_of_lost(verdict_of(lost->how), Fault::subject);
  }
  if (std::holds_alternative<Unsupported>(answers[frame])) {
    return Bucket{.verdict = Verdict::unsupported};
  }
  if (!why_malformed(keeping, answers, frame)) return std::nullopt;
  return bucket_of_lost(Verdict::malformed, Fault::subject);
}

bool is_ill_posed(const exact::Truth& truth, const Declaration& declaration) {
  return is_ill_posed(truth.size(), bounds(truth.pair(), declaration, truth.extent())) ||
         tolerance_of(truth, declaration) > kIllPosedShare * truth.size();
}

Side true_side(const exact::Truth& truth) {
  return truth.has_faces() ? truth.greatest().side : Side::a;
}

class SequenceJudge {
 public:
  SequenceJudge(const Sequence& sequence, const SequenceCollider& subject,
                std::span<const KeptAnswer> answers)
      : sequence_(sequence), subject_(subject), answers_(answers) {}

  SequenceJudgement judge() {
    for (std::size_t frame = 0; frame < answers_.size(); ++frame) {
      if (const auto bucket = bucket_without_points(subject_.keeping, answers_, frame)) {
        result_.bucket = *bucket;
        result_.frame = frame;
        return result_;
      }
      add(frame);
    }
    decide();
    return result_;
  }

 private:
  void add(std::size_t frame) {
    const exact::Truth truth(sequence_.at(frame));
    bounds_.push_back(kept_bounds(truth, subject_.declaration));
    if (is_ill_posed(truth, subject_.declaration)) {
      result_.frames.push_back({.is_ill_posed = true});
      return;
    }
    const FrameView view{sequence_, subject_, answers_, frame, truth, bounds_};
    std::vector<FrameJudgement> found = judge_frame(view);
    for (FrameJudgement& judgement : found)
      judgement.explanation = find_sequence_explanation(view, judgement);
    const auto most_serious = std::ranges::min_element(found, is_more_serious);
    result_.frames.push_back(most_serious == found.end() ? FrameJudgement{} : *most_serious);
    if (result_.frames.size() == 1 || is_more_serious(result_.frames.back(), worst_)) {
      worst_ = result_.frames.back();
      result_.frame = frame;
      result_.bucket.reference = true_side(truth);
    }
  }

  void decide() {
    Bucket& bucket = result_.bucket;
    if (worst_.kind == Kind::none) {
      const bool is_unknown =
          std::ranges::all_of(result_.frames, &FrameJudgement::is_ill_posed) && !answers_.empty();
      bucket = {.verdict = is_unknown ? Verdict::ill_posed : Verdict::agree};
      result_.frame = 0;
      return;
    }
    result_.magnitude = worst_.magnitude;
    result_.explanation = worst_.explanation;
    bucket.fault = Fault::subject;
    bucket.verdict = worst_.explanation != nullptr ? Verdict::known : Verdict::subject_wrong;
    bucket.kind = worst_.kind;
    bucket.error_class = class_of(worst_.kind, worst_.magnitude, worst_.bound);
  }

  const Sequence& sequence_;
  const SequenceCollider& subject_;
  std::span<const KeptAnswer> answers_;
  std::vector<KeptBounds> bounds_;
  FrameJudgement worst_;
  SequenceJudgement result_;
};

}  // namespace

SequenceJudgement judge_sequence(const Sequence& sequence, const SequenceCollider& subject,
                                 std::span<const KeptAnswer> answers) {
  return SequenceJudge(sequence, subject, answers).judge();
}

bool takes(const SequenceCollider& subject, const Sequence& sequence) {
  const PairCase pair = sequence.at(0);
  const bool has_mitred_radius = !is_round(pair) && total_radius(pair) > 0;
  return takes_shapes(subject.declaration, pair) &&
         (subject.declaration.takes_radius || !has_mitred_radius);
}

std::vector<KeptAnswer> ask_sequence(const SequenceCollider& subject, const Sequence& sequence) {
  if (!takes(subject, sequence)) return {Unsupported{"declares that it takes no such shapes"}};
  std::vector<KeptAnswer> answers;
  const auto ask = subject.begin();
  for (std::size_t frame = 0; frame < sequence.frames.size(); ++frame) {
    answers.push_back(ask(sequence.at(frame)));
    if (!std::holds_alternative<KeptManifold>(answers.back())) break;
  }
  return answers;
}

}  // namespace manifuzz
