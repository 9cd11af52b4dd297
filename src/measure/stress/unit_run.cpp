#include <algorithm>
#include <cmath>
#include <optional>
#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

#include "measure/stress/stress.hpp"

namespace manifuzz {
namespace {

void count(Changes& changes, std::uint64_t frame, bool with_margin) {
  if (!with_margin) {
    ++changes.within_bound;
    return;
  }
  if (changes.with_margin == 0) changes.first = frame;
  ++changes.with_margin;
}

/// The longest distance of a point between two manifolds of as many points.
double longest_move(const Manifold<double>& from, const Manifold<double>& to) {
  double longest = 0;
  for (int i = 0; i < from.count; ++i) {
    const Vector2<double> apart = to.points[i].position - from.points[i].position;
    longest = std::max(longest, std::sqrt(apart.dot(apart)));
  }
  return longest;
}

bool has_same_features(const Manifold<double>& m, const Manifold<double>& n) {
  return std::equal(m.points.begin(), m.points.begin() + m.count, n.points.begin(),
                    n.points.begin() + n.count,
                    [](const auto& p, const auto& q) { return p.features == q.features; });
}

}  // namespace

WalkChangeCounter::Frame WalkChangeCounter::frame_of(const Manifold<double>& manifold,
                                                     const Manifold<double>& truth,
                                                     const Admissible& right) {
  Frame now{.manifold = manifold, .truth = truth};
  const auto& candidates = right.candidates;
  if (candidates.empty()) return now;
  const exact::Clip& first = *candidates.front();
  const bool one_side = std::ranges::all_of(candidates, [&](const exact::Clip* clip) {
    return clip->reference.side == first.reference.side;
  });
  if (one_side) now.reference = first.reference.side;
  const bool decided =
      std::all_of(first.points.begin(), first.points.begin() + first.count, [&](const auto& point) {
        return features_decided(right, first, point) &&
               std::abs(point.depth()) > depth_bound(right, first, point);
      });
  if (candidates.size() == 1 && first.count == 2 && decided) {
    now.only = first.reference;
    now.incident = first.incident;
  }
  for (const exact::Clip* clip : candidates) {
    for (int i = 0; i < clip->count; ++i) {
      now.bound = std::max(now.bound, position_bound(right, *clip, clip->points[i]));
    }
  }
  return now;
}

void WalkChangeCounter::compare(std::uint64_t frame, const Frame& now) {
  const bool is_decided =
      now.only && before_->only == now.only && before_->incident == now.incident;
  if (before_->truth.reference == now.truth.reference &&
      before_->manifold.reference != now.manifold.reference) {
    count(changes_.flickers, frame, now.reference && before_->reference == now.reference);
  }
  if (!has_same_features(before_->truth, now.truth)) return;
  if (!has_same_features(before_->manifold, now.manifold)) {
    count(changes_.features, frame, is_decided);
  }
  if (before_->manifold.count == now.manifold.count &&
      longest_move(before_->manifold, now.manifold) >
          longest_move(before_->truth, now.truth) + before_->bound + now.bound) {
    count(changes_.jumps, frame, is_decided);
  }
}

void WalkChangeCounter::add(std::uint64_t frame, Referee& referee, const Declaration& declaration,
                            const Answer& answer) {
  const Manifold<double>& truth = referee.truth_for(declaration);
  if (truth.count > 0) ++changes_.touching;
  const auto* const manifold = std::get_if<Manifold<double>>(&answer);
  if (manifold == nullptr || manifold->count == 0 || truth.count == 0) {
    before_.reset();
    return;
  }
  const Frame now = frame_of(*manifold, truth, referee.right_for(declaration));
  if (before_) compare(frame, now);
  before_ = now;
}

#if defined(__SSE2__)

namespace {

constexpr unsigned kFlushResults = 0x8000;
constexpr unsigned kFlushInputs = 0x0040;

}  // namespace

bool can_flush_to_zero() {
  return true;
}

FlushToZero::FlushToZero(bool wanted) : wanted_(wanted) {
  if (!wanted_) return;
  before_ = _mm_getcsr();
  _mm_setcsr(before_ | kFlushResults | kFlushInputs);
}

FlushToZero::~FlushToZero() {
  if (wanted_) _mm_setcsr(before_);
}

#else

bool can_flush_to_zero() {
  return false;
}

FlushToZero::FlushToZero(bool wanted) : wanted_(wanted) {}

FlushToZero::~FlushToZero() = default;

#endif

namespace {

constexpr std::uint64_t kBlock = 256;

/// One subject in a unit.
struct SubjectRun {
  const StressSubject* subject = nullptr;
  std::size_t number = 0;
  std::vector<Answer> answers{};  ///< to a block, of one in a process of its own
  bool has_given_up = false;      ///< in its own process it does nothing but die
  ErrorCollector collector;
  WalkChangeCounter changes{};
};

/// Asks one in a process of its own for a whole block; what it does not answer is lost.
void ask_for_block(SubjectRun& run, std::span<const PairCase> pairs, UnitState& state,
                   const std::function<bool()>& go_on) {
  const Collider& collider = run.subject->collider;
  if (!collider.is_isolated()) return;
  run.answers.assign(pairs.size(), Lost{});
  if (run.has_given_up) return;
  const std::size_t answered = collider.collide_many(pairs, run.answers, [&] {
    ++state.progress;
    return go_on();
  });
  run.has_given_up = answered < pairs.size() && go_on();
}

Answer answer_of(const StressPlan& plan, SubjectRun& run, std::size_t in_block, std::uint64_t index,
                 Referee& referee, UnitState& state) {
  const Collider& collider = run.subject->collider;
  if (state.lost[run.number].has(index)) return Lost{};
  if (collider.is_isolated()) return std::move(run.answers[in_block]);
  if (!collider.collide) {
    const Manifold<double>& truth = referee.truth_for(collider.declaration);
    return truth.count > 0 ? Answer(rounded_once(truth)) : Answer(Unsupported{});
  }
  state.subject.store(static_cast<int>(run.number), std::memory_order_relaxed);
  Answer answer = [&] {
    const FlushToZero flushing(plan.flush_to_zero);
    return collider.collide(referee.truth().pair());
  }();
  state.subject.store(kNobody, std::memory_order_relaxed);
  return answer;
}

void measure_case(const StressPlan& plan, const Unit& unit, std::vector<SubjectRun>& runs,
                  const PairCase& pair, std::size_t in_block, std::uint64_t index,
                  UnitState& state) {
  state.index.store(index, std::memory_order_relaxed);
  Referee referee(pair);
  for (SubjectRun& run : runs) {
    const Declaration& declaration = run.subject->collider.declaration;
    const Answer answer =
        referee.whole(declaration, answer_of(plan, run, in_block, index, referee, state));
    run.collector.add(index, referee.measure(declaration, answer));
    if (unit.walk != nullptr) run.changes.add(index, referee, declaration, answer);
  }
  ++state.progress;
}

}  // namespace

void LostCases::add(std::uint64_t index) {
  if (count == kLostMax) {
    given_up_from = 0;
    return;
  }
  cases[count++] = index;
  if (count == kLostMax) given_up_from = index;
}

bool LostCases::has(std::uint64_t index) const {
  const auto* const end = cases.begin() + count;
  return index >= given_up_from || std::find(cases.begin(), end, index) != end;
}

bool run_unit(const StressPlan& plan, const Unit& unit, UnitState& state,
              const std::function<bool()>& go_on,
              const std::function<void(std::uint64_t)>& on_cases,
              std::span<StepStatistics> tallies) {
  const auto errors =
      unit.walk != nullptr ? ErrorCollector::Errors::counted : ErrorCollector::Errors::kept;
  std::vector<SubjectRun> runs;
  for (std::size_t i = 0; i < plan.subjects.size(); ++i) {
    if (unit.walk == nullptr && plan.subjects[i].walks_only) continue;
    runs.push_back(
        {.subject = &plan.subjects[i], .number = i, .collector = ErrorCollector(errors)});
  }
  std::optional<Walker> walker;  // a frame by itself takes all before it
  if (unit.walk != nullptr) walker.emplace(plan.seed, *unit.walk);
  const std::uint64_t total = cases_of(plan, unit);
  std::vector<PairCase> pairs;
  for (std::uint64_t begin = 0; begin < total; begin += kBlock) {
    pairs.clear();
    for (std::uint64_t i = begin; i < std::min(begin + kBlock, total); ++i) {
      pairs.push_back(walker ? walker->next() : case_of(plan, unit, i));
    }
    for (SubjectRun& run : runs) ask_for_block(run, pairs, state, go_on);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      if (!go_on()) return false;
      measure_case(plan, unit, runs, pairs[i], i, begin + i, state);
    }
    on_cases(pairs.size());
  }
  for (const SubjectRun& run : runs) {
    tallies[run.number] = {run.collector.statistics(), run.changes.changes()};
  }
  return true;
}

}  // namespace manifuzz
