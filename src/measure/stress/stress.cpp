#include "measure/stress/stress.hpp"

#include <algorithm>
#include <atomic>
#include <cassert>
#include <chrono>
#include <memory>

#include "measure/stress/unit_run.hpp"
#include "process/watched_process.hpp"

namespace manifuzz {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kPollSeconds = 0.1;
constexpr double kSilentSecondsMax = 30;  ///< over a case, and over adding up a unit

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

struct Office {
  std::atomic<bool> stop{false};
  std::atomic<std::size_t> undealt{0};  ///< the next unit
};

struct Desk {
  std::size_t unit = 0;
  bool has_unit = false;
  std::atomic<std::uint64_t> done{0};  ///< cases of all its units, for the progress line
  std::uint64_t done_before = 0;       ///< of the units before this one
  UnitDesk at_work;
};

/// The tallies of every unit, where jobs leave them and their parent finds them.
class Ledgers {
 public:
  Ledgers(std::size_t units, std::size_t subjects)
      : contestants_(subjects), memory_(units * bytes_of_one()) {}

  StepStatistics* tallies(std::size_t unit) const {
    return static_cast<StepStatistics*>(at(unit, sizeof(std::uint64_t)));
  }
  void close(std::size_t unit) const { *static_cast<std::uint64_t*>(at(unit, 0)) = 1; }
  bool is_closed(std::size_t unit) const { return *static_cast<std::uint64_t*>(at(unit, 0)) == 1; }

 private:
  std::size_t bytes_of_one() const {
    return sizeof(std::uint64_t) + contestants_ * sizeof(StepStatistics);
  }
  void* at(std::size_t unit, std::size_t offset) const {
    return static_cast<char*>(memory_.data()) + unit * bytes_of_one() + offset;
  }

  std::size_t contestants_;
  SharedMemory memory_;
};

struct Work {
  const StressPlan& plan;
  const std::vector<Unit>& units;
  const Ledgers& ledgers;
  Office& office;
};

void run_job(const Work& work, Desk& desk) {
  const auto go_on = [&work] { return !work.office.stop.load(std::memory_order_relaxed); };
  while (go_on()) {
    if (!desk.has_unit) {
      desk.unit = work.office.undealt++;
      desk.has_unit = true;
      desk.at_work.lost = {};
      desk.done_before = desk.done;
    }
    if (desk.unit >= work.units.size()) return;
    desk.done = desk.done_before;
    const bool is_done = run_unit(
        work.plan, work.units[desk.unit], desk.at_work, go_on,
        [&desk](std::uint64_t cases) { desk.done += cases; }, work.ledgers.tallies(desk.unit));
    if (!is_done) return;
    work.ledgers.close(desk.unit);
    desk.has_unit = false;
  }
}

/// The parent's side of one job.
class Job {
 public:
  explicit Job(const Work& work) : work_(work) { start(); }

  bool alive() const { return process_.alive(); }
  std::uint64_t done() const { return desk_->done; }
  void kill() { process_.kill(); }

  /// Where a subject took the process along, its unit is run again, and it is not asked for that
  /// case.
  void look_after() {
    if (!alive()) return;
    const auto state = process_.look(desk_->at_work.pulse, kSilentSecondsMax);
    if (state != WatchedProcess::State::crashed && state != WatchedProcess::State::hung) return;
    const int subject = desk_->at_work.subject.exchange(kNobody);
    if (subject == kNobody) {
      throw std::runtime_error("stress: a job died and no collider was at work; this is a defect");
    }
    desk_->at_work.lost[static_cast<std::size_t>(subject)].add(desk_->at_work.index);
    if (!work_.office.stop) start();
  }

 private:
  void start() {
    process_.start([this] { run_job(work_, *desk_); });
  }

  const Work& work_;
  Shared<Desk> desk_;
  WatchedProcess process_;
};

void collect(const Work& work, StressResult& result) {
  for (std::size_t i = 0; i < work.units.size(); ++i) {
    if (!work.ledgers.is_closed(i)) continue;
    result.units.push_back(work.units[i]);
    const StepStatistics* const tallies = work.ledgers.tallies(i);
    result.tallies.emplace_back(tallies, tallies + work.plan.subjects.size());
  }
}

}  // namespace

StressSubject ideal_subject() {
  StressSubject ideal{.name = std::string(kIdealName), .collider = {}};
  ideal.collider.declaration.name = kIdealName;
  return ideal;
}

std::vector<Unit> units_of(const StressPlan& plan) {
  std::vector<Unit> units;
  // Walks take longest: they come first, so that no job is left behind with one.
  for (const Walk* const walk : plan.walks) units.push_back({.walk = walk});
  for (const Sweep* const sweep : plan.sweeps) {
    for (std::size_t i = 0; i < sweep->values.size(); ++i) {
      units.push_back({.sweep = sweep, .step = i});
    }
  }
  return units;
}

std::uint64_t cases_of(const StressPlan& plan, const Unit& unit) {
  return unit.walk != nullptr ? plan.frames : plan.cases;
}

PairCase case_of(const StressPlan& plan, const Unit& unit, std::uint64_t index) {
  if (unit.walk != nullptr) return frame_of(plan.seed, *unit.walk, index);
  return draw_case(plan.seed, *unit.sweep, unit.sweep->values[unit.step], index);
}

std::vector<StepStatistics> StressResult::steps(const Sweep& sweep, std::size_t subject) const {
  std::vector<StepStatistics> steps;
  for (std::size_t i = 0; i < units.size(); ++i) {
    if (units[i].sweep == &sweep && units[i].step == steps.size()) {
      steps.push_back(tallies[i][subject]);
    }
  }
  return steps;
}

const StepStatistics* StressResult::walk(const Walk& walk, std::size_t subject) const {
  const auto found = std::ranges::find(units, &walk, &Unit::walk);
  return found == units.end() ? nullptr : &tallies[found - units.begin()][subject];
}

StressResult run_stress(const StressPlan& plan, Interruption& interruption,
                        const std::function<void(const StressProgress&)>& on_progress) {
  assert(plan.subjects.size() <= kSubjectsMax);
  const auto start = Clock::now();
  const std::vector<Unit> units = units_of(plan);
  const Ledgers ledgers(units.size(), plan.subjects.size());
  const Shared<Office> office;
  const Work work{plan, units, ledgers, *office};
  std::uint64_t total = 0;
  for (const Unit& unit : units) total += cases_of(plan, unit);

  std::vector<std::unique_ptr<Job>> jobs;
  for (int i = 0; i < plan.jobs; ++i) jobs.push_back(std::make_unique<Job>(work));
  StressResult result;
  double progress_at = 0;
  while (std::ranges::any_of(jobs, [](const auto& job) { return job->alive(); })) {
    interruption.wait(kPollSeconds);
    if (interruption.requested()) result.interrupted = office->stop = true;
    for (const auto& job : jobs) {
      interruption.requests() > 1 ? job->kill() : job->look_after();
    }
    const double now = seconds_since(start);
    if (now - progress_at < 2 * kPollSeconds) continue;
    progress_at = now;
    std::uint64_t done = 0;
    for (const auto& job : jobs) done += job->done();
    on_progress({done, total, now});
  }
  collect(work, result);
  result.seconds = seconds_since(start);
  return result;
}

}  // namespace manifuzz
