#include "campaign/in_child.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <numeric>
#include <optional>
#include <type_traits>

#include "campaign/shrink_in_child.hpp"
#include "judging/manifold_error.hpp"

namespace manifuzz {
namespace {

/// What a child that judges leaves behind. The ledger entry's address holds in its parent too.
struct JudgementSlot {
  std::atomic<Fault> at_work{Fault::none};
  Judgement judgement;
};

/// What one in a process of its own answers.
Answer ask_isolated(const Collider& collider, const PairCase& pair, Interruption& interruption) {
  Answer answer;
  const auto go_on = [&] { return !interruption.is_stopped(); };
  if (collider.collide_many({&pair, 1}, {&answer, 1}, go_on) == 0) throw Interrupted();
  return answer;
}

}  // namespace

void unless_interrupted(const std::function<void()>& work) {
  try {
    work();
  } catch (const Interrupted&) {
    // What is done until then is kept.
  }
}

Lost lost_by(Ending ending) {
  if (ending == Ending::crashed) return {Lost::How::crashed, "crashed"};
  return {Lost::How::timed_out, "timed out"};
}

Bucket bucket_of_lost(Ending ending, Fault at_work) {
  return bucket_of_lost(ending == Ending::crashed ? Verdict::crashed : Verdict::timed_out, at_work);
}

Judgement judge_in_child(const PairCase& pair, const Collider& subject, const Collider& oracle,
                         Interruption& interruption) {
  // Colliders in a process of their own are asked from here, where they run already.
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
  return judge_lost(pair, subject, oracle, {ending, slot->at_work}, interruption);
}

Judgement judge_lost(const PairCase& pair, const Collider& subject, const Collider& oracle,
                     const Loss& loss, Interruption& interruption) {
  const Judgement lost{.bucket = bucket_of_lost(loss.ending, loss.at_work)};
  if (loss.at_work != Fault::oracle) return lost;
  Collider silent;
  silent.declaration = oracle.declaration;
  silent.collide = [&](const PairCase&) { return lost_by(loss.ending); };
  const Judgement judgement = judge_in_child(pair, subject, silent, interruption);
  return judgement.explanation != nullptr ? judgement : lost;
}

Answer ask_in_child(const Collider& collider, const PairCase& pair, Interruption& interruption) {
  return whole(ask_isolated(hosted(collider), pair, interruption), pair, collider.declaration);
}

namespace {

/// Both as they are asked again and again: from here, where one of them runs in a process of its
/// own already, for in another child that would have to be started anew.
struct AskedOften {
  AskedOften(const Collider& first, const Collider& second)
      : is_here(first.is_isolated() || second.is_isolated()),
        subject(is_here ? hosted(first) : first),
        oracle(is_here ? hosted(second) : second) {}

  bool is_here;
  Collider subject;
  Collider oracle;
};

}  // namespace

Shrunk shrink_finding(const PairCase& pair, const Collider& subject, const Collider& oracle,
                      Interruption& interruption, const Deadline& deadline) {
  const AskedOften asked(subject, oracle);
  const Judgement root = judge_in_child(pair, asked.subject, asked.oracle, interruption);
  const auto judged = [&](const PairCase& candidate, Interruption& shrinking) {
    return is_of_lost(root.bucket) || asked.is_here
               ? judge_in_child(candidate, asked.subject, asked.oracle, shrinking)
               : judge(candidate, subject, oracle);
  };
  return ShrinkTask<PairCase, PairCase>{pair, asked.is_here, case_seconds_max(subject, oracle),
                                        deadline,
                                        [&](const PairCase& candidate, Interruption& shrinking) {
                                          return is_alike(judged(candidate, shrinking), root);
                                        }}
      .run(interruption);
}

namespace {

/// A crash costs a new process, as long as so many cells: so many times fewer are taken.
constexpr int kCellsACrash = 32;

/// A map of what hardly ever answers shows no more after so long.
constexpr double kLostSecondsMax = 2;

/// Steps of this share of a circle fill it more evenly than any other.
constexpr double kGoldenSection = 0.6180339887498949;

/// Where a child is, where its parent can see it even if it dies.
struct ChildState {
  std::atomic<int> turn{0};  ///< counts the cells
  int losses_left = 0;       ///< so many crashes there is still time for
  double seconds_lost = 0;   ///< over answers that did not come, or were none
  std::atomic<Fault> at_work{Fault::none};

  bool goes_on() const { return losses_left > 0 && seconds_lost < kLostSecondsMax; }
  void lose(const Bucket& bucket, double seconds) {
    if (!is_of_lost(bucket)) return;
    if (bucket.verdict == Verdict::crashed) --losses_left;
    if (bucket.verdict == Verdict::timed_out) losses_left = 0;
    seconds_lost += seconds;
  }
};

/// From cell to cell so that each of them is met once.
int stride_over(int cells) {
  auto stride = static_cast<int>(cells * kGoldenSection);
  while (std::gcd(stride, cells) != 1) ++stride;
  return stride;
}

void judge_cell(const PairCase& pair, const AskedOften& asked, Interruption& interruption,
                ChildState& place, Cell& cell) {
  const auto ask = [&](const Collider& collider) {
    return asked.is_here ? ask_in_child(collider, pair, interruption)
                         : manifuzz::ask(collider, pair);
  };
  const auto truth = std::make_shared<const exact::Truth>(pair);
  cell.truth = summary_of(*truth);
  place.at_work = Fault::subject;
  const Answer of_subject = ask(asked.subject);
  cell.subject = summary_of(of_subject);
  place.at_work = Fault::oracle;
  const Answer of_oracle = ask(asked.oracle);
  place.at_work = Fault::none;
  cell.oracle = summary_of(of_oracle);
  cell.bucket =
      judge(truth, {asked.subject.declaration, of_subject}, {asked.oracle.declaration, of_oracle})
          .bucket;
  cell.state = Cell::State::judged;
}

}  // namespace

Neighbourhood ask_neighbourhood(const PairCase& pair, const Collider& subject,
                                const Collider& oracle, const Grid& grid, int cells_max,
                                Interruption& interruption) {
  static_assert(std::is_trivially_copyable_v<Cell>);
  const AskedOften asked(subject, oracle);
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
    for (; place->turn < turns && place->goes_on(); ++place->turn) {
      const int at = cell_in_turn();
      Cell& cell = cells[at];
      const auto moved = neighbour(pair, grid, at);
      if (!moved) {
        cell.state = Cell::State::invalid;
        continue;
      }
      const Clock::time_point began = Clock::now();
      judge_cell(*moved, asked, interruption, *place, cell);
      place->lose(cell.bucket, seconds_since(began));
    }
  };
  const auto lose_cell = [&](int, Ending ending) {
    Cell& cell = cells[cell_in_turn()];
    cell.bucket = bucket_of_lost(ending, place->at_work);
    cell.state = Cell::State::judged;
    place->lose(cell.bucket, 0);
    ++place->turn;
    return place->goes_on();
  };
  if (asked.is_here) {
    unless_interrupted([&] { ask_the_rest(0); });
  } else {
    run_pool({.body = ask_the_rest,
              .progress = [&](int) { return static_cast<std::uint64_t>(place->turn); },
              .seconds_max = case_seconds_max(subject, oracle),
              .on_lost = lose_cell},
             interruption);
  }
  return {grid, {cells.all().begin(), cells.all().end()}};
}

}  // namespace manifuzz
