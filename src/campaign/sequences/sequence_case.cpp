#include "campaign/sequences/sequence_case.hpp"

#include <algorithm>
#include <array>
#include <atomic>

#include <fmt/format.h>

#include "campaign/in_child.hpp"
#include "campaign/shrink_in_child.hpp"
#include "judging/errors/clip_error.hpp"
#include "process/pool.hpp"
#include "sequence/sequence_json.hpp"

namespace manifuzz {
namespace {

/// More points than any collider declares; an answer with more is nonsense.
constexpr std::size_t kKeptMax = 32;

/// A frame's answer where the parent of the child that asks can see it.
struct KeptSlot {
  enum class Kind { none, kept, unsupported, lost };
  Kind kind = Kind::none;
  Lost::How how = Lost::How::crashed;
  std::size_t count = 0;
  std::array<KeptPoint, kKeptMax> points;
  SharedText<256> why;
};

void put(KeptSlot& slot, const KeptAnswer& answer) {
  if (const auto* const kept = std::get_if<KeptManifold>(&answer)) {
    slot.count = kept->points.size();
    std::copy_n(kept->points.begin(), std::min(slot.count, kKeptMax), slot.points.begin());
    slot.kind = KeptSlot::Kind::kept;
  } else if (const auto* const unsupported = std::get_if<Unsupported>(&answer)) {
    slot.why.set(unsupported->why);
    slot.kind = KeptSlot::Kind::unsupported;
  } else {
    const Lost& lost = std::get<Lost>(answer);
    slot.how = lost.how;
    slot.why.set(lost.why);
    slot.kind = KeptSlot::Kind::lost;
  }
}

KeptAnswer taken_from(const KeptSlot& slot) {
  if (slot.kind == KeptSlot::Kind::unsupported) return Unsupported{slot.why.str()};
  if (slot.kind == KeptSlot::Kind::lost) return Lost{slot.how, slot.why.str()};
  if (slot.count > kKeptMax) {
    return Lost{Lost::How::malformed, fmt::format("keeps {} points", slot.count)};
  }
  const auto begin = slot.points.begin();
  return KeptManifold{{begin, begin + static_cast<std::ptrdiff_t>(slot.count)}};
}

/// A sequence in shared memory.
struct SequenceSlot {
  std::size_t frames = 0;
  ConvexPolygon<float> a;
  ConvexPolygon<float> b;
  std::array<FramePoses, kFramesMax> poses;

  SequenceSlot& operator=(const Sequence& sequence) {
    frames = sequence.frames.size();
    a = sequence.a;
    b = sequence.b;
    std::copy_n(sequence.frames.begin(), frames, poses.begin());
    return *this;
  }
  explicit operator Sequence() const {
    return {a, b, {poses.begin(), poses.begin() + static_cast<std::ptrdiff_t>(frames)}};
  }
};

/// The bound of the frame that decides.
double bound_of(const SequenceJudgement& judgement) {
  return judgement.frame < judgement.frames.size() ? judgement.frames[judgement.frame].bound : 0;
}

/// Whether the bodies touch in the frame that decides.
bool touches_where_decided(const Sequence& sequence, const SequenceJudgement& judgement) {
  return standing(exact::Truth(sequence.at(judgement.frame))).touching;
}

}  // namespace

SequenceCollider watched(const SequenceCollider& subject, const std::function<void()>& on_frame) {
  SequenceCollider all = subject;
  all.begin = [begin = subject.begin, on_frame] {
    return [ask = begin(), on_frame](const PairCase& frame) {
      on_frame();
      return ask(frame);
    };
  };
  return all;
}

Judgement counted(const SequenceJudgement& judgement) {
  Judgement result{.bucket = judgement.bucket,
                   .magnitude = judgement.magnitude,
                   .bound = bound_of(judgement),
                   .explanation = judgement.explanation,
                   .is_judged = true,
                   .frame = judgement.frame};
  if (judgement.bucket.kind != Kind::none) {
    result.of_subject.add_beyond(component_of(judgement.bucket.kind), judgement.magnitude, 0);
  }
  return result;
}

std::vector<KeptAnswer> ask_in_child(const SequenceCollider& subject, const Sequence& sequence,
                                     Interruption& interruption) {
  if (subject.is_isolated || !takes(subject, sequence)) {
    std::vector<KeptAnswer> answers = ask_sequence(subject, sequence);
    if (interruption.is_stopped()) throw Interrupted();  // it may have been cut short
    return answers;
  }
  const Shared<KeptSlot> slots(sequence.frames.size());
  const Shared<std::atomic<std::size_t>> done;
  const auto body = [&] {
    const auto ask = subject.begin();
    for (std::size_t k = 0; k < sequence.frames.size(); ++k) {
      put(slots[k], ask(sequence.at(k)));
      ++*done;
      if (slots[k].kind != KeptSlot::Kind::kept) break;
    }
  };
  const Ending ending =
      run_in_child(body, kCaseSeconds, interruption, [&] { return std::uint64_t{*done}; });
  if (ending == Ending::stopped) throw Interrupted();
  std::vector<KeptAnswer> answers;
  for (std::size_t k = 0; k < *done; ++k) answers.push_back(taken_from(slots[k]));
  if (ending != Ending::done) answers.emplace_back(lost_by(ending));
  return answers;
}

JudgedSequence judged_sequence(const CorpusCase& given, const SequenceCollider& subject,
                               Interruption& interruption) {
  const Sequence sequence = given.sequence();
  JudgedSequence judged{given, subject, ask_in_child(subject, sequence, interruption), {}};
  judged.judgement = judge_sequence(sequence, subject, judged.answers);
  return judged;
}

SequenceJudgement judge_in_child(const Sequence& sequence, const SequenceCollider& subject,
                                 Interruption& interruption) {
  return judge_sequence(sequence, subject, ask_in_child(subject, sequence, interruption));
}

ShrunkSequence shrink_finding(const Sequence& sequence, const SequenceCollider& subject,
                              Interruption& interruption, const Deadline& deadline) {
  const SequenceJudgement root = judge_in_child(sequence, subject, interruption);
  const Verdict verdict = root.bucket.verdict;
  const bool is_lost = verdict == Verdict::crashed || verdict == Verdict::timed_out;
  const bool is_touching = touches_where_decided(sequence, root);
  const auto is_like_root = [&](const Sequence& candidate, Interruption& shrinking) {
    const SequenceJudgement judgement =
        is_lost ? judge_in_child(candidate, subject, shrinking)
                : judge_sequence(candidate, subject, ask_sequence(subject, candidate));
    return is_alike(counted(judgement), counted(root)) &&
           touches_where_decided(candidate, judgement) == is_touching;
  };
  return ShrinkTask<SequenceSlot, Sequence>{sequence, is_lost || subject.is_isolated, kCaseSeconds,
                                            deadline, is_like_root}
      .run(interruption);
}

}  // namespace manifuzz
