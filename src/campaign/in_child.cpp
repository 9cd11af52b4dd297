#include "campaign/in_child.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <numeric>
#include <optional>
#include <type_traits>

#include "judging/manifold_error.hpp"

namespace manifuzz {
namespace {

/// What a child that judges leaves behind. The ledger entry's address holds in its parent too.
struct JudgementSlot {
  std::atomic<Fault> at_work{Fault::none};
  Judgement judgement;
};

/// An answer without pointers, for shared memory.
struct AnswerSlot {
  std::size_t kind = 0;  ///< its place among the kinds of an Answer
  PartialManifold manifold;
  Penetration penetration;
  Lost::How how = Lost::How::crashed;
  SharedText<512> why;

  void put(const Answer& answer) {
    kind = answer.index();
    if (const auto* const whole = std::get_if<Manifold<double>>(&answer)) manifold = {*whole};
    if (const auto* const partial = std::get_if<PartialManifold>(&answer)) manifold = *partial;
    if (const auto* const less = std::get_if<Penetration>(&answer)) penetration = *less;
    if (const auto* const declined = std::get_if<Unsupported>(&answer)) why.set(declined->why);
    if (const auto* const lost = std::get_if<Lost>(&answer)) {
      how = lost->how;
      why.set(lost->why);
    }
  }

  Answer answer() const {
    const std::array<Answer, std::variant_size_v<Answer>> kinds{
        manifold.manifold, Unsupported{why.str()}, manifold, Lost{how, why.str()}, penetration};
    return kinds[kind];
  }
};

/// What one in a process of its own answers.
Answer ask_isolated(const Collider& collider, const PairCase& pair, Interruption& interruption) {
  Answer answer;
  const auto go_on = [&] { return !interruption.is_stopped(); };
  if (collider.collide_many({&pair, 1}, {&answer, 1}, go_on) == 0) throw Interrupted();
  return answer;
}

}  // namespace

Lost lost_by(Ending ending) {
  if (ending == Ending::crashed) return {Lost::How::crashed, "crashed"};
  return {Lost::How::timed_out, "timed out"};
}

Bucket bucket_of_lost(Ending ending, Fault at_work) {
  return bucket_of_lost(ending == Ending::crashed ? Verdict::crashed : Verdict::timed_out, at_work);
}

Judgement judge_in_child(const PairCase& pair, const Collider& subject, const Collider& oracle,
                         Interruption& interruption) {
  // Those in a process of their own are asked from here, where they run already.
  const auto asked_here = [&](const Collider& collider) {
    return collider.is_isolated() ? std::optional(ask_isolated(collider, pair, interruption))
                                  : std::nullopt;
  };
  const std::optional<Answer> subject_here = asked_here(subject);
  const std::optional<Answer> oracle_here = asked_here(oracle);
  if (subject_here && oracle_here) {
    return judge(pair, {subject.declaration, *subject_here}, {oracle.declaration, *oracle_here});
  }
  const Shared<JudgementSlot> slot;
  const auto body = [&] {
    slot->at_work = Fault::subject;
    const Answer of_subject = subject_here ? *subject_here : subject.collide(pair);
    slot->at_work = Fault::oracle;
    const Answer of_oracle = oracle_here ? *oracle_here : oracle.collide(pair);
    slot->at_work = Fault::none;
    slot->judgement =
        judge(pair, {subject.declaration, of_subject}, {oracle.declaration, of_oracle});
  };
  const Ending ending = run_in_child(body, case_seconds_max(subject, oracle), interruption);
  if (ending == Ending::stopped) throw Interrupted();
  if (ending == Ending::done) return slot->judgement;
  return {.bucket = bucket_of_lost(ending, slot->at_work)};
}

Answer ask_in_child(const Collider& collider, const PairCase& pair, Interruption& interruption) {
  if (collider.is_isolated()) {
    return whole(ask_isolated(collider, pair, interruption), pair, collider.declaration);
  }
  const Shared<AnswerSlot> slot;
  const Ending ending = run_in_child([&] { slot->put(collider.collide(pair)); },
                                     case_seconds_max(collider, collider), interruption);
  if (ending == Ending::stopped) throw Interrupted();
  if (ending != Ending::done) return lost_by(ending);
  return whole(slot->answer(), pair, collider.declaration);
}

namespace {

/// What a shrinking child has found so far, where its parent can see it even if it dies.
struct ShrinkSlot {
  std::atomic<int> evaluations{0};
  std::atomic<int> accepted{0};
  std::array<PairCase, 2> best;  ///< the one at `accepted` mod 2 is whole
  std::atomic<bool> complete{false};
};

}  // namespace

Shrunk shrink_finding(const PairCase& pair, const Collider& subject, const Collider& oracle,
                      Interruption& interruption, const Deadline& deadline) {
  const Judgement root = judge_in_child(pair, subject, oracle, interruption);
  const bool is_lost =
      root.bucket.verdict == Verdict::crashed || root.bucket.verdict == Verdict::timed_out;
  Interruption::Limits limits = interruption.until_signal();
  if (deadline) limits.stopped_at = std::min(limits.stopped_at.value_or(*deadline), *deadline);
  Interruption shrinking(limits);
  const Shared<ShrinkSlot> slot;
  slot->best[0] = pair;
  const auto like_root = [&](const PairCase& candidate) {
    ++slot->evaluations;
    const Judgement judgement = is_lost ? judge_in_child(candidate, subject, oracle, shrinking)
                                        : judge(candidate, subject, oracle);
    if (!is_alike(judgement, root)) return false;
    slot->best[static_cast<std::size_t>(slot->accepted + 1) % 2] = candidate;
    ++slot->accepted;
    return true;
  };
  run_in_child([&] { slot->complete = shrink(pair, like_root).complete; },
               case_seconds_max(subject, oracle), shrinking,
               [&] { return static_cast<std::uint64_t>(slot->evaluations); });
  return {slot->best[static_cast<std::size_t>(slot->accepted) % 2], slot->evaluations,
          slot->complete};
}

namespace {

/// A crash costs a new process, as long as so many cells: so many times fewer are taken.
constexpr int kCellsACrash = 32;

/// Steps of this share of a circle fill it more evenly than any other.
constexpr double kGoldenSection = 0.6180339887498949;

/// Where a child is, where its parent can see it even if it dies.
struct ChildState {
  std::atomic<int> turn{0};  ///< counts the cells
  int losses_left = 0;       ///< so many crashes there is still time for
  std::atomic<Fault> at_work{Fault::none};

  void lose(Verdict verdict) {
    if (verdict == Verdict::crashed) --losses_left;
    if (verdict == Verdict::timed_out) losses_left = 0;
  }
};

/// From cell to cell so that each of them is met once.
int stride_over(int cells) {
  auto stride = static_cast<int>(cells * kGoldenSection);
  while (std::gcd(stride, cells) != 1) ++stride;
  return stride;
}

void judge_cell(const PairCase& pair, const Collider& subject, const Collider& oracle,
                ChildState& place, Cell& cell) {
  const auto truth = std::make_shared<const exact::Truth>(pair);
  cell.truth = summary_of(*truth);
  place.at_work = Fault::subject;
  const Answer of_subject = manifuzz::ask(subject, pair);
  cell.subject = summary_of(of_subject);
  place.at_work = Fault::oracle;
  const Answer of_oracle = manifuzz::ask(oracle, pair);
  place.at_work = Fault::none;
  cell.oracle = summary_of(of_oracle);
  cell.bucket =
      judge(truth, {subject.declaration, of_subject}, {oracle.declaration, of_oracle}).bucket;
  cell.state = Cell::State::judged;
}

}  // namespace

Neighbourhood ask_neighbourhood(const PairCase& pair, const Collider& subject,
                                const Collider& oracle, const Grid& grid, int cells_max,
                                Interruption& interruption) {
  static_assert(std::is_trivially_copyable_v<Cell>);
  const int count = grid.cell_count();
  const Shared<ChildState> place;
  const Shared<Cell> cells(count);

  const int turns = std::min(count, cells_max);
  place->losses_left = cells_max / kCellsACrash;
  const int stride = stride_over(count);
  const auto cell_in_turn = [&] {  // the middle one first
    return static_cast<int>((count / 2 + std::int64_t{place->turn} * stride) % count);
  };
  const auto ask_the_rest = [&](int) {
    for (; place->turn < turns && place->losses_left > 0; ++place->turn) {
      const int at = cell_in_turn();
      Cell& cell = cells[at];
      const auto moved = neighbour(pair, grid, at);
      cell.state = Cell::State::invalid;
      if (!moved) continue;
      judge_cell(*moved, subject, oracle, *place, cell);
      place->lose(cell.bucket.verdict);
    }
  };
  const auto lose_cell = [&](int, Ending ending) {
    Cell& cell = cells[cell_in_turn()];
    cell.bucket = bucket_of_lost(ending, place->at_work);
    cell.state = Cell::State::judged;
    place->lose(cell.bucket.verdict);
    ++place->turn;
    return place->losses_left > 0;
  };
  run_pool({.body = ask_the_rest,
            .progress = [&](int) { return static_cast<std::uint64_t>(place->turn); },
            .seconds_max = case_seconds_max(subject, oracle),
            .on_lost = lose_cell},
           interruption);
  return {grid, {cells.all().begin(), cells.all().end()}};
}

}  // namespace manifuzz
