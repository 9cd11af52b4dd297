#include "campaign/neighbourhood_run.hpp"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <memory>
#include <numeric>
#include <type_traits>

#include "campaign/in_child.hpp"
#include "judging/completed.hpp"
#include "process/shared_memory.hpp"

namespace manifuzz {
namespace {

/// A crash costs a new process, as long as so many cells: so many times fewer are taken.
constexpr int kCellsACrash = 32;

/// Steps of this share of a circle fill it more evenly than any other.
constexpr double kGoldenSection = 0.6180339887498949;

/// Where a child is, where its parent can see it even if it dies.
struct Place {
  std::atomic<int> turn{0};  ///< counts the cells
  int losses_left = 0;       ///< so many crashes there is still time for
  std::atomic<Fault> at_work{Fault::none};

  void lose(Verdict verdict) {
    if (verdict == Verdict::crashed) --losses_left;
    if (verdict == Verdict::timed_out) losses_left = 0;
  }
};

/// The cell whose turn it is: the middle one first, each of them once.
class Order {
 public:
  explicit Order(int cells) : cells_(cells), stride_(static_cast<int>(cells * kGoldenSection)) {
    while (std::gcd(stride_, cells_) != 1) ++stride_;
  }
  int cell(int turn) const {
    return static_cast<int>((cells_ / 2 + std::int64_t{turn} * stride_) % cells_);
  }

 private:
  int cells_;
  int stride_;
};

void judge_cell(const PairCase& pair, const Collider& subject, const Collider& oracle, Place& place,
                Cell& cell) {
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
  const Order order(count);
  const Shared<Place> place;
  const Shared<Cell> cells(count);

  const int turns = std::min(count, cells_max);
  place->losses_left = cells_max / kCellsACrash;
  const auto ask_the_rest = [&](int) {
    for (; place->turn < turns && place->losses_left > 0; ++place->turn) {
      Cell& cell = cells[order.cell(place->turn)];
      const auto moved = neighbour(pair, grid, order.cell(place->turn));
      cell.state = Cell::State::invalid;
      if (!moved) continue;
      judge_cell(*moved, subject, oracle, *place, cell);
      place->lose(cell.bucket.verdict);
    }
  };
  const auto lose_cell = [&](int, Ending ending) {
    Cell& cell = cells[order.cell(place->turn)];
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
