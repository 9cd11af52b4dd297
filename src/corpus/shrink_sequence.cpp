#include "corpus/shrink_sequence.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "corpus/shrink_gate.hpp"
#include "generating/drafts.hpp"

namespace manifuzz {
namespace {

using Sequences = rc::Seq<Sequence>;
using MaybeSequence = std::optional<Sequence>;

/// A run of frames to leave out.
struct Run {
  std::size_t first = 0;
  std::size_t count = 0;
};

/// Halves, quarters, ..., single frames: of each size the last, the first, and those between from
/// the end on.
std::vector<Run> runs_of(std::size_t frames) {
  std::vector<Run> runs;
  for (std::size_t count = frames / 2; count > 0; count /= 2) {
    runs.push_back({frames - count, count});
    runs.push_back({0, count});
    for (std::size_t end = frames - count; end > 2 * count; end -= count) {
      runs.push_back({end - count, count});
    }
    if (frames > 2 * count) runs.push_back({count, count});  // what is left between
  }
  return runs;
}

Sequences with_fewer_frames(const Sequence& sequence) {
  return rc::seq::map(
      rc::seq::fromContainer(runs_of(sequence.frames.size())), [sequence](const Run& run) {
        Sequence shorter = sequence;
        const auto first = shorter.frames.begin() + static_cast<std::ptrdiff_t>(run.first);
        shorter.frames.erase(first, first + static_cast<std::ptrdiff_t>(run.count));
        return shorter;
      });
}

/// A box of that half width and height around its origin.
ConvexPolygon<float> plain_box(float width, float height) {
  const std::vector<Vector2<float>> corners{
      {-width, -height}, {width, -height}, {width, height}, {-width, height}};
  return make_polygon<float>(corners);
}

/// Turns whose numbers are short.
constexpr std::array<std::array<float, 2>, 6> kPlainTurns{
    {{1, 0}, {0, 1}, {0.6F, 0.8F}, {0.8F, 0.6F}, {0.96F, 0.28F}, {0.28F, 0.96F}}};

/// What may happen in the second frame to a body that stands on another: both are turned about the
/// origin, or the upper one is turned, slid or lifted.
std::vector<FramePoses> plain_second_frames(const FramePoses& first) {
  std::vector<FramePoses> frames;
  for (const auto& turn : kPlainTurns) {
    for (const float sign : {1.0F, -1.0F}) {
      const Vector2<float> rotation(turn[0], sign * turn[1]);
      const Vector2<float> moved = rotate(rotation, first.b.position);
      frames.push_back({{first.a.position, rotation}, {moved, rotation}});
      frames.push_back({first.a, {first.b.position, rotation}});
    }
  }
  for (const float by : {1.0F, 0.5F, 0.1F, 0.01F, -0.1F, -1.0F}) {
    for (const Vector2<float>& way : {Vector2<float>(by, 0), Vector2<float>(0, by)}) {
      frames.push_back({first.a, {first.b.position + way, {1, 0}}});
    }
  }
  return frames;
}

/// The plainest sequences of one frame and of two: a box on a box, as deep as this, and then what
/// may happen. What fails in any of them has one form, wherever it was found.
const std::vector<Sequence>& plain_sequences() {
  static const std::vector<Sequence> all = [] {
    std::vector<Sequence> sequences;
    const ConvexPolygon<float> box = plain_box(1, 1);
    for (const bool has_second : {false, true}) {
      for (const float depth : {1.0F, 0.5F, 0.1F, 0.01F, 0.0F, -0.01F}) {
        const FramePoses first{{}, {{0, 2 - depth}, {1, 0}}};
        if (!has_second) sequences.push_back({box, box, {first}});
        for (const FramePoses& second : plain_second_frames(first)) {
          if (has_second) sequences.push_back({box, box, {first, second}});
        }
      }
    }
    return sequences;
  }();
  return all;
}

/// The rotation of one body, in one frame, plain.
Sequences with_a_plain_turn(const Sequence& sequence) {
  std::vector<Sequence> all;
  for (std::size_t k = 0; k < sequence.frames.size(); ++k) {
    for (Pose<float> FramePoses::*body : {&FramePoses::a, &FramePoses::b}) {
      for (const auto& turn : kPlainTurns) {
        for (const float cos : {turn[0], -turn[0]}) {
          for (const float sin : {turn[1], -turn[1]}) {
            Sequence& turned = all.emplace_back(sequence);
            (turned.frames[k].*body).rotation = {cos, sin};
          }
        }
      }
    }
  }
  return rc::seq::fromContainer(std::move(all));
}

/// Either shape, or both, a plain box.
Sequences with_plain_shapes(const Sequence& sequence) {
  std::vector<Sequence> all;
  for (const ConvexPolygon<float>& box :
       {plain_box(1, 1), plain_box(0.5F, 0.5F), plain_box(2, 1), plain_box(1, 2),
        plain_box(1, 0.5F), plain_box(0.5F, 1)}) {
    all.push_back({box, box, sequence.frames});
    all.push_back({box, sequence.b, sequence.frames});
    all.push_back({sequence.a, box, sequence.frames});
  }
  return rc::seq::fromContainer(std::move(all));
}

/// Each of a list of changes, made in all frames alike: the shapes are then those of the first.
class ChangedAlike {
 public:
  explicit ChangedAlike(const Sequence& sequence) {
    for (std::size_t k = 0; k < sequence.frames.size(); ++k) {
      of_frames_.push_back(like_changes(sequence.at(k)));
    }
  }

  rc::Maybe<Sequence> operator()() {
    Sequence changed;
    for (rc::Seq<PairCase>& of_frame : of_frames_) {
      const rc::Maybe<PairCase> pair = of_frame.next();
      if (!pair) return rc::Nothing;
      if (changed.frames.empty()) {
        changed.a = pair->a.polygon;
        changed.b = pair->b.polygon;
      }
      changed.frames.push_back({pair->a.pose, pair->b.pose});
    }
    return changed;
  }

 private:
  std::vector<rc::Seq<PairCase>> of_frames_;
};

/// One body stands, or is turned, in all frames as in the first; or the world is moved so that it
/// begins at the origin.
Sequences with_less_motion(const Sequence& sequence) {
  std::vector<Sequence> all;
  for (Pose<float> FramePoses::*body : {&FramePoses::a, &FramePoses::b}) {
    const Pose<float> first = sequence.frames.front().*body;
    Sequence& still = all.emplace_back(sequence);
    for (FramePoses& frame : still.frames) frame.*body = first;
    Sequence& unturned = all.emplace_back(sequence);
    for (FramePoses& frame : unturned.frames) (frame.*body).rotation = first.rotation;
    Sequence& moved = all.emplace_back(sequence);
    for (FramePoses& frame : moved.frames) {
      frame.a.position -= first.position;
      frame.b.position -= first.position;
    }
  }
  return rc::seq::fromContainer(std::move(all));
}

/// What makes one frame's case simpler, the shapes of all frames with it.
Sequences simpler_in_a_frame(const Sequence& sequence) {
  const int frames = static_cast<int>(sequence.frames.size());
  return rc::seq::join(rc::seq::map(rc::seq::range(0, frames), [sequence](int number) {
    const auto k = static_cast<std::size_t>(number);
    return rc::seq::map(simpler_neighbours(sequence.at(k)), [sequence, k](const PairCase& pair) {
      Sequence changed = sequence;
      changed.a = pair.a.polygon;
      changed.b = pair.b.polygon;
      changed.frames[k] = {pair.a.pose, pair.b.pose};
      return changed;
    });
  }));
}

/// With every frame's case valid, its normals computed afresh, and 0 in place of -0.
MaybeSequence revalidated(const Sequence& sequence) {
  Sequence result = sequence;
  for (std::size_t k = 0; k < sequence.frames.size(); ++k) {
    const std::optional<PairCase> valid = revalidated(without_negative_zeros(sequence.at(k)));
    if (!valid) return std::nullopt;
    result.a = valid->a.polygon;
    result.b = valid->b.polygon;
    result.frames[k] = {valid->a.pose, valid->b.pose};
  }
  return result;
}

}  // namespace

std::vector<float> numbers_of(const Sequence& sequence) {
  std::vector<float> numbers;
  for (std::size_t k = 0; k < sequence.frames.size(); ++k) {
    const std::vector<float> of_frame = numbers_of(sequence.at(k));
    numbers.insert(numbers.end(), of_frame.begin(), of_frame.end());
  }
  return numbers;
}

SequenceComplexity complexity(const Sequence& sequence) {
  // Numbers of the shapes count once: they stand in the first frame's.
  const Complexity shapes = complexity(PairCase{{sequence.a, {}}, {sequence.b, {}}});
  SequenceComplexity result{sequence.frames.size(), complexity(sequence.at(0))};
  Complexity& sum = result.of_numbers;
  for (std::size_t k = 1; k < sequence.frames.size(); ++k) {
    const Complexity of_frame = complexity(sequence.at(k));
    sum.placements += of_frame.placements - shapes.placements;
    sum.odd_numbers += of_frame.odd_numbers - shapes.odd_numbers;
    sum.digits += of_frame.digits - shapes.digits;
    sum.size += of_frame.size - shapes.size;
    sum.numbers.insert(sum.numbers.end(), of_frame.numbers.begin(), of_frame.numbers.end());
  }
  return result;
}

namespace {

/// One kind of change: what it makes of a sequence, the boldest first.
using Pass = Sequences (*)(const Sequence&);

Sequences plainest_sequences(const Sequence&) {
  return rc::seq::fromContainer(plain_sequences());
}

Sequences changed_alike(const Sequence& sequence) {
  return rc::makeSeq<ChangedAlike>(sequence);
}

constexpr std::array<Pass, 7> kPasses{with_fewer_frames, plainest_sequences, with_plain_shapes,
                                      with_less_motion,  with_a_plain_turn,  changed_alike,
                                      simpler_in_a_frame};

/// The first of a pass that is valid, simpler, and fails.
MaybeSequence first_smaller(Pass pass, const Sequence& sequence, ShrinkGate<Sequence>& gate) {
  const SequenceComplexity limit = complexity(sequence);
  Sequences proposals = pass(sequence);
  while (gate.complete) {
    const rc::Maybe<Sequence> proposal = proposals.next();
    if (!proposal) break;
    MaybeSequence valid = revalidated(*proposal);
    if (valid && complexity(*valid) < limit && gate.passes(*valid)) return valid;
  }
  return std::nullopt;
}

}  // namespace

ShrunkSequence shrink(const Sequence& sequence,
                      const std::function<bool(const Sequence&)>& still_fails,
                      int evaluations_max) {
  ShrinkGate<Sequence> gate{still_fails, evaluations_max, {numbers_of(sequence)}};
  const MaybeSequence positive_zeros = revalidated(sequence);
  const bool is_tidy = positive_zeros && gate.fails(*positive_zeros);
  Sequence smallest = is_tidy ? *positive_zeros : sequence;
  // Each pass until it finds nothing more; all of them until none does.
  for (bool is_smaller = true; is_smaller;) {
    is_smaller = false;
    for (const Pass pass : kPasses) {
      while (const MaybeSequence next = first_smaller(pass, smallest, gate)) {
        smallest = *next;
        is_smaller = true;
      }
    }
  }
  return {smallest, gate.evaluations, gate.complete};
}

}  // namespace manifuzz
