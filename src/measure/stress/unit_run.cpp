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

/// One subject's side of a unit.
struct Seat {
  const StressSubject* subject = nullptr;
  std::size_t number = 0;
  std::vector<Answer> answers{};  ///< to a block, of one in a process of its own
  bool has_given_up = false;      ///< in its own process it does nothing but die
  ErrorCollector collector;
  WalkChangeCounter changes{};
};

/// Asks one in a process of its own for a whole block; what it does not answer is lost.
void ask_for_block(Seat& seat, std::span<const PairCase> pairs, UnitDesk& desk,
                   const std::function<bool()>& go_on) {
  const Collider& collider = seat.subject->collider;
  if (!collider.is_isolated()) return;
  seat.answers.assign(pairs.size(), Lost{});
  if (seat.has_given_up) return;
  const std::size_t answered = collider.collide_many(pairs, seat.answers, [&] {
    ++desk.pulse;
    return go_on();
  });
  seat.has_given_up = answered < pairs.size() && go_on();
}

Answer answer_of(const StressPlan& plan, Seat& seat, std::size_t in_block, std::uint64_t index,
                 Referee& referee, UnitDesk& desk) {
  const Collider& collider = seat.subject->collider;
  if (desk.lost[seat.number].has(index)) return Lost{};
  if (collider.is_isolated()) return std::move(seat.answers[in_block]);
  if (!collider.collide) {
    const Manifold<double>& truth = referee.truth_for(collider.declaration);
    return truth.count > 0 ? Answer(rounded_once(truth)) : Answer(Unsupported{});
  }
  desk.subject.store(static_cast<int>(seat.number), std::memory_order_relaxed);
  Answer answer = [&] {
    const FlushToZero flushing(plan.flush_to_zero);
    return collider.collide(referee.truth().pair());
  }();
  desk.subject.store(kNobody, std::memory_order_relaxed);
  return answer;
}

void measure_case(const StressPlan& plan, const Unit& unit, std::vector<Seat>& seats,
                  const PairCase& pair, std::size_t in_block, std::uint64_t index, UnitDesk& desk) {
  desk.index.store(index, std::memory_order_relaxed);
  Referee referee(pair);
  for (Seat& seat : seats) {
    const Declaration& declaration = seat.subject->collider.declaration;
    const Answer answer =
        referee.completed(declaration, answer_of(plan, seat, in_block, index, referee, desk));
    seat.collector.add(index, referee.measure(declaration, answer));
    if (unit.walk != nullptr) seat.changes.add(index, referee, declaration, answer);
  }
  ++desk.pulse;
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

bool run_unit(const StressPlan& plan, const Unit& unit, UnitDesk& desk,
              const std::function<bool()>& go_on,
              const std::function<void(std::uint64_t)>& on_cases, StepStatistics* tallies) {
  const auto errors =
      unit.walk != nullptr ? ErrorCollector::Errors::counted : ErrorCollector::Errors::kept;
  std::vector<Seat> seats;
  for (std::size_t i = 0; i < plan.subjects.size(); ++i) {
    if (unit.walk == nullptr && plan.subjects[i].walks_only) continue;
    seats.push_back(
        {.subject = &plan.subjects[i], .number = i, .collector = ErrorCollector(errors)});
  }
  CaseSource source(plan, unit);
  const std::uint64_t total = cases_of(plan, unit);
  std::vector<PairCase> pairs;
  for (std::uint64_t begin = 0; begin < total; begin += kBlock) {
    pairs.clear();
    while (pairs.size() < std::min(kBlock, total - begin)) pairs.push_back(source.next());
    for (Seat& seat : seats) ask_for_block(seat, pairs, desk, go_on);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      if (!go_on()) return false;
      measure_case(plan, unit, seats, pairs[i], i, begin + i, desk);
    }
    on_cases(pairs.size());
  }
  for (const Seat& seat : seats) {
    tallies[seat.number] = {seat.collector.statistics(), seat.changes.changes()};
  }
  return true;
}

}  // namespace manifuzz
