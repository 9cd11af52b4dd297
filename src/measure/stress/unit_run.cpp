#include "measure/stress/unit_run.hpp"

#include <algorithm>
#include <optional>

#include "measure/stress/flush_to_zero.hpp"
#include "measure/stress/walk_changes.hpp"

namespace manifuzz {
namespace {

constexpr std::uint64_t kBlock = 256;

/// The cases of a unit, in their order.
class CaseSource {
 public:
  CaseSource(const StressPlan& plan, const Unit& unit) : plan_(plan), unit_(unit) {
    if (unit.walk != nullptr) walker_.emplace(plan.seed, *unit.walk);
  }

  PairCase next() {
    if (walker_) return walker_->next();
    return draw_case(plan_.seed, *unit_.sweep, unit_.sweep->values[unit_.step], index_++);
  }

 private:
  const StressPlan& plan_;
  const Unit& unit_;
  std::optional<Walker> walker_;
  std::uint64_t index_ = 0;
};

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
        referee.completed(declaration, answer_of(plan, run, in_block, index, referee, state));
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
  CaseSource source(plan, unit);
  const std::uint64_t total = cases_of(plan, unit);
  std::vector<PairCase> pairs;
  for (std::uint64_t begin = 0; begin < total; begin += kBlock) {
    pairs.clear();
    while (pairs.size() < std::min(kBlock, total - begin)) pairs.push_back(source.next());
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
