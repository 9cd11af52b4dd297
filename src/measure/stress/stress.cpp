#include "measure/stress/stress.hpp"

#include <algorithm>
#include <cassert>
#include <stdexcept>

#include <fmt/format.h>

#include "base/text.hpp"
#include "process/pool.hpp"

namespace manifuzz {

void choose_sweeps(const std::vector<std::string>& names, std::string_view option,
                   StressPlan& plan) {
  struct Choice {
    std::string_view name;
    const Sweep* sweep;
    const Walk* walk;
  };
  std::vector<Choice> all;
  for (const Sweep& sweep : sweeps()) all.push_back({sweep.name, &sweep, nullptr});
  for (const Walk& walk : walks()) all.push_back({walk.name, nullptr, &walk});
  for (const Choice* const one : chosen_by_name(all, names, "sweep", option)) {
    if (one->sweep != nullptr) plan.sweeps.push_back(one->sweep);
    if (one->walk != nullptr) plan.walks.push_back(one->walk);
  }
}

std::vector<StressSubject> with_variants(const std::vector<StressSubject>& chosen) {
  std::vector<StressSubject> subjects{ideal_subject()};
  const auto add = [&subjects](StressSubject subject) {
    if (std::ranges::find(subjects, subject.name, &StressSubject::name) != subjects.end()) {
      throw UserError(
          fmt::format("--collider: there is more than one '{}'", printable(subject.name)));
    }
    subjects.push_back(std::move(subject));
  };
  for (const StressSubject& subject : chosen) {
    add(subject);
    if (!subject.collider.with_tie_bias) continue;
    add({subject.name + " with a bias", subject.collider.with_tie_bias(kWalkBias), true,
         subject.is_ours});
  }
  if (subjects.size() > kSubjectsMax) throw UserError("--collider: that is too many at once");
  return subjects;
}

bool is_broken(const ErrorStatistics& step) {
  if (step.wrong() > 0 && step.wrong() * kWrongEvery >= step.well_posed()) return true;
  const ErrorSpreads& errors = step.of_size;
  return std::max({errors.depth.p999, errors.position.p999, errors.normal.p999}) > kGrossShare;
}

std::optional<std::size_t> breaking_step(std::span<const StepStatistics> steps) {
  const auto broken = std::ranges::find_if(steps, is_broken);
  if (broken == steps.end()) return std::nullopt;
  return static_cast<std::size_t>(broken - steps.begin());
}

namespace {

constexpr double kSilentSecondsMax = 30;  ///< over a case, and over adding up a unit

/// What a job is at, where its parent can see it even if it dies.
struct JobState {
  SharedQueue::Block units;            ///< of one unit, begun anew where the job was lost
  std::atomic<std::uint64_t> done{0};  ///< cases of all its units, for the progress line
  std::uint64_t done_before = 0;       ///< of the units before this one
  UnitState at_work;
};

struct Work {
  const StressPlan& plan;
  const std::vector<Unit>& units;
  SharedQueue& queue;                        ///< of units
  const Shared<StepStatistics>& tallies;     ///< of every unit, by subject
  const Shared<std::atomic<bool>>& is_done;  ///< by unit

  std::span<StepStatistics> tallies_of(std::size_t unit) const {
    return tallies.all().subspan(unit * plan.subjects.size(), plan.subjects.size());
  }
};

void run_job(const Work& work, JobState& job) {
  while (work.queue.is_open()) {
    if (job.units.begin == job.units.end) {
      job.units = work.queue.take(1);
      if (job.units.begin == job.units.end) return;
      job.at_work.lost = {};
      job.done_before = job.done;
    }
    job.done = job.done_before;
    const std::size_t unit = job.units.begin;
    const bool is_done = run_unit(
        work.plan, work.units[unit], job.at_work, [&work] { return work.queue.is_open(); },
        [&job](std::uint64_t cases) { job.done += cases; }, work.tallies_of(unit));
    if (!is_done) return;
    work.is_done[unit] = true;
    job.units.begin = job.units.end;
  }
}

/// Where a subject died or hung, its unit is run again, and it is not asked for that case.
bool lose_case(const Work& work, JobState& job) {
  const int subject = job.at_work.subject.exchange(kNobody);
  if (subject == kNobody) {
    throw std::runtime_error("stress: a job died and no collider was at work; this is a defect");
  }
  job.at_work.lost[static_cast<std::size_t>(subject)].add(job.at_work.index);
  return work.queue.is_open();
}

void collect(const Work& work, StressResult& result) {
  for (std::size_t i = 0; i < work.units.size(); ++i) {
    if (!work.is_done[i]) continue;
    result.units.push_back(work.units[i]);
    const auto tallies = work.tallies_of(i);
    result.tallies.emplace_back(tallies.begin(), tallies.end());
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
  const std::vector<Unit> units = units_of(plan);
  const Shared<SharedQueue> queue;
  queue->end = units.size();
  const Shared<StepStatistics> tallies(units.size() * plan.subjects.size());
  const Shared<std::atomic<bool>> is_done(units.size());
  const Work work{plan, units, *queue, tallies, is_done};
  const Shared<JobState> jobs(plan.jobs);
  std::uint64_t total = 0;
  for (const Unit& unit : units) total += cases_of(plan, unit);

  const Pool pool{.jobs = plan.jobs,
                  .body = [&](int job) { run_job(work, jobs[job]); },
                  .progress = [&](int job) { return jobs[job].at_work.progress.load(); },
                  .seconds_max = kSilentSecondsMax,
                  .on_lost = [&](int job, Ending) { return lose_case(work, jobs[job]); },
                  .hurry = &queue->is_closed,
                  .on_tick =
                      [&](double seconds) {
                        std::uint64_t done = 0;
                        for (const JobState& job : jobs.all()) done += job.done;
                        on_progress({done, total, seconds});
                      }};
  StressResult result;
  result.seconds = run_pool(pool, interruption).seconds;
  result.interrupted = interruption.state() != Interruption::State::running;
  collect(work, result);
  return result;
}

}  // namespace manifuzz
