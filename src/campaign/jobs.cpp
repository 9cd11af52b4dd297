#include <algorithm>
#include <chrono>

#include "campaign/in_child.hpp"
#include "campaign/job.hpp"
#include "campaign/run.hpp"

namespace manifuzz {
namespace {

/// The share of the time that a signal leaves in which jobs end; the rest is for what they found.
constexpr double kShareOfJobs = 0.4;

void run_job(const Plan& plan, CampaignRun& run, CampaignJob& job) {
  const std::function<void()> run_block = plan.work->block_runner(plan, run, job);
  std::uint64_t length = 1;  // the first answer is there the sooner
  while (run.is_open()) {
    if (job.next >= job.end) {
      const SharedQueue::Block block = run.cases.take(length);
      length = plan.work->block_length();
      if (block.begin >= block.end || block.begin > run.sought) return;
      job.end = block.end;
      job.next = block.begin;
    }
    run_block();
    run.clock.begin();
    if (job.next >= run.sought) return;
  }
}

/// The case that a job died or hung at is a finding of its own.
void lose_case(const Plan& plan, CampaignRun& run, CampaignJob& job, Ending ending,
               Interruption& interruption) {
  const Step step = job.step;
  const Fault fault = step == Step::asking_subject  ? Fault::subject
                      : step == Step::asking_oracle ? Fault::oracle
                                                    : Fault::none;
  Judgement judgement{.bucket = bucket_of_lost(ending, fault)};
  if (step == Step::generating) return job.count(plan, run, {}, judgement);
  const AnyCase any = plan.work->draw(plan, job.next);
  unless_interrupted([&] {
    judgement = plan.work->trial(plan)->judge_lost(any, {ending, fault}, interruption);
  });
  job.count(plan, run, standing(any), judgement, frames_in(any));
}

std::unique_ptr<Tally> added(const Shared<CampaignJob>& jobs) {
  auto total = std::make_unique<Tally>();
  for (const CampaignJob& job : jobs.all()) total->add(job.tally);
  return total;
}

}  // namespace

void add(JobsResult& all, const JobsResult& part) {
  all.tally->add(*part.tally);
  all.seconds += part.seconds;
  all.interrupted = part.interrupted;
  all.given_up = part.given_up;
  all.why_given_up = part.why_given_up;
}

JobsResult run_jobs(const Plan& plan, SharedQueue::Block cases, Interruption& interruption,
                    const OnProgress& on_progress) {
  const Shared<CampaignRun> run;
  run->cases.next = cases.begin;
  run->cases.end = cases.end;
  run->seconds_max = plan.seconds.value_or(run->seconds_max);
  const Shared<CampaignJob> jobs(plan.jobs);
  Interruption until_time_is_up(
      {.begins = interruption.state(), .hurried_at = plan.latest, .share = kShareOfJobs});
  const Pool pool{.jobs = plan.jobs,
                  .body = [&](int job) { run_job(plan, *run, jobs[job]); },
                  .progress = [&](int job) { return jobs[job].next + jobs[job].waits; },
                  .seconds_max = case_seconds_max(plan.subject, plan.oracle),
                  .on_lost =
                      [&](int job, Ending ending) {
                        lose_case(plan, *run, jobs[job], ending, until_time_is_up);
                        return run->is_open();
                      },
                  .hurry = &run->cases.is_closed,
                  .on_tick =
                      [&](double) {
                        on_progress({*added(jobs), run->clock.seconds()});
                      }};
  run_pool(pool, until_time_is_up);
  return {.tally = added(jobs),
          .seconds = run->clock.seconds(),
          .interrupted = interruption.state() != Interruption::State::running,
          .sought = run->sought == kNoCase ? std::nullopt : std::optional(run->sought.load()),
          .given_up = run->given_up,
          .why_given_up = run->why_given_up.str()};
}

}  // namespace manifuzz
