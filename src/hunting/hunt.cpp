#include "hunting/hunt.hpp"

#include <algorithm>

#include "hunting/journal.hpp"

namespace manifuzz {
namespace {

HuntRow row_of(const Hunt& hunt, std::string_view measure, const WorstFound& found) {
  const Plan& plan = hunt.campaign.plan;
  if (!found.pair) return {std::string(measure), 0, found.drawn};
  return {std::string(measure),        found.value, found.drawn, plan.seed,
          plan.index_of(found.number), found.file};
}

/// The row of all bounds is that of the one of which an answer takes the greatest share.
std::vector<HuntRow> rows_of(const Hunt& hunt) {
  std::vector<HuntRow> rows;
  std::vector<HuntRow> of_bounds;
  for (const WorstFound& found : hunt.worst) {
    const Measure measure = measure_of(found.gauge);
    const bool is_of_bound = measure == Measure::bound_share;
    if (is_of_bound) of_bounds.push_back(row_of(hunt, name_of(found.gauge, kGaugeNames), found));
    if (!is_of_bound) rows.push_back(row_of(hunt, name_of(measure, kMeasureNames), found));
  }
  if (of_bounds.empty()) return rows;
  HuntRow of_all = *std::ranges::max_element(of_bounds, {}, &HuntRow::worst);
  of_all.measure = name_of(Measure::bound_share, kMeasureNames);
  of_all.worst_drawn = std::ranges::max_element(of_bounds, {}, &HuntRow::worst_drawn)->worst_drawn;
  rows.push_back(of_all);
  rows.insert(rows.end(), of_bounds.begin(), of_bounds.end());
  return rows;
}

class Hunting {
 public:
  Hunting(const HuntPlan& hunt, const OnHuntProgress& on_progress)
      : hunt_(hunt),
        on_progress_(on_progress),
        aim_(aim_at(hunt.measure)),
        drawn_plan_(hunt.plan),
        plan_(hunt.plan),
        bred_(std::make_shared<HuntedPairs>(
            Breed{hunt.plan.regimes, hunt.founders, aim_, hunt.on_hunted, hunt.earlier, hunt.again},
            hunt.plan)) {
    plan_.regimes = {&kHunted};
    plan_.work = bred_;
    plan_.judge_every = drawn_plan_.judge_every = 1;
    if (!hunt.compares) return;
    drawn_ = std::make_shared<ObservedPairs>(kLongestGeneration + hunt.founders.size(), aim_,
                                             hunt.on_drawn);
    drawn_plan_.work = drawn_;
  }

  const Plan& plan() const { return plan_; }

  JobsResult run(Journal& journal, Interruption& interruption) {
    JobsResult all{.tally = std::make_unique<Tally>()};
    const CaseNumber end = plan_.cases_max();
    for (CaseNumber begun = 0; begun < end && !has_ended(all) && !is_time_up(all);) {
      const SharedQueue::Block cases = bred_->begin_generation(end - begun);
      begun = cases.end;
      const JobsResult part = run_part(plan_, cases, drawn_ ? 0.5 : 1, all, interruption);
      const CaseNumber done = part.tally->cases();
      add(all, part);
      bred_->end_generation(*all.tally);
      keep(journal, *all.tally);
      if (drawn_ && !has_ended(all)) {
        run_drawn({cases.begin, cases.begin + done}, all, interruption);
      }
      met_by_.emplace_back(seconds(all), all.tally->buckets.all().size());
      // A generation that the time cut short is the last: cases bred from it could not be repeated.
      if (plan_.seconds && done < cases.end - cases.begin) break;
    }
    return all;
  }

  Hunt finished(Campaign campaign) const {
    Hunt result{.campaign = std::move(campaign),
                .generations = bred_->generations(),
                .cells = bred_->filled(),
                .cells_drawn = {},
                .worst = {},
                .what = hunt_.what,
                .rounds = hunt_.rounds};
    if (hunt_.rounds) result.archived = bred_->archived();
    for (std::size_t k = 0; k < kGauges; ++k) {
      const auto gauge = static_cast<Gauge>(k);
      if (!aim_.seeks(k)) continue;
      const Worst& worst = bred_->worst()[k];
      WorstFound found{gauge, worst.value, {}, worst.number, {}};
      if (worst.value > 0) found.pair = bred_->pair(plan_, worst.number);
      if (drawn_) found.drawn = drawn_->worst()[k].value;
      result.worst.push_back(found);
    }
    if (!drawn_) return result;
    result.cells_drawn = drawn_->filled();
    for (const BucketTallies::Met& met : drawn_all_.tally->buckets.all()) {
      const bool is_hunted = result.campaign.run.tally->buckets.find(met.bucket) != nullptr;
      if (met.bucket.fault != Fault::none && !is_hunted) {
        result.buckets_drawn.push_back(to_string(met.bucket));
      }
    }
    return result;
  }

 private:
  /// Keeps the first case of each bucket of somebody's mistakes, and the worst of each gauge.
  void keep(Journal& journal, const Tally& tally) const {
    for (const auto& [bucket, met] : tally.buckets.all()) {
      if (bucket.fault != Fault::none) keep(journal, to_string(bucket), 0, met->first);
    }
    for (std::size_t k = 0; k < kGauges; ++k) {
      const auto gauge = static_cast<Gauge>(k);
      const Worst& worst = bred_->worst()[k];
      if (worst.value <= 0 || !aim_.seeks(k)) continue;
      keep(journal, name_of(gauge, kGaugeNames), worst.value, worst.number);
    }
  }

  void keep(Journal& journal, std::string_view key, double value, CaseNumber number) const {
    journal.add(key, value, [&] {
      std::string line;
      append_found_case_line(line, bred_->pair(plan_, number),
                             {plan_.seed, std::string(kHunted.name), plan_.index_of(number), {}});
      return line;
    });
  }

  double seconds(const JobsResult& all) const { return all.seconds + drawn_all_.seconds; }

  bool is_time_up(const JobsResult& all) const {
    return plan_.seconds && seconds(all) >= *plan_.seconds;
  }

  /// Takes at most that share of the time that is left.
  JobsResult run_part(const Plan& plan, SharedQueue::Block cases, double share,
                      const JobsResult& all, Interruption& interruption) {
    Plan part = plan;
    if (plan.seconds) part.seconds = share * (*plan.seconds - seconds(all));
    return run_jobs(part, cases, interruption, [&](const Progress& so_far) { show(so_far, all); });
  }

  void run_drawn(SharedQueue::Block cases, JobsResult& all, Interruption& interruption) {
    drawn_->begin_part(cases);
    add(drawn_all_, run_part(drawn_plan_, cases, 1, all, interruption));
    drawn_->end_part();
    all.interrupted = drawn_all_.interrupted;
  }

  /// How many new behaviours a second were met in the later half of the time until now, so that a
  /// hunt that finds nothing new any more shows it.
  double new_a_second(std::size_t behaviours, double until) const {
    std::pair<double, std::size_t> before{};
    for (const auto& met : met_by_) {
      if (met.first <= until / 2) before = met;
    }
    const double time = until - before.first;
    return time > 0 ? static_cast<double>(behaviours - before.second) / time : 0;
  }

  void show(const Progress& so_far, const JobsResult& all) const {
    const auto tally = std::make_unique<Tally>(*all.tally);
    HuntProgress progress{.plan = plan_,
                          .cases = {*tally, seconds(all) + so_far.seconds},
                          .cells = bred_->filled().all,
                          .cells_drawn = {},
                          .behaviours = tally->buckets.all().size()};
    progress.behaviours_a_second = new_a_second(progress.behaviours, progress.cases.seconds);
    if (drawn_) progress.cells_drawn = drawn_->filled().all;
    for (std::size_t k = kGauges; k-- > 0;) {
      if (bred_->worst()[k].value <= 0) continue;
      progress.worst = bred_->worst()[k].value;
      progress.worst_of = static_cast<Gauge>(k);
    }
    on_progress_(progress);
  }

  const HuntPlan& hunt_;
  const OnHuntProgress& on_progress_;
  Aim aim_;
  Plan drawn_plan_;
  Plan plan_;
  std::shared_ptr<HuntedPairs> bred_;
  std::shared_ptr<ObservedPairs> drawn_;
  JobsResult drawn_all_{.tally = std::make_unique<Tally>()};
  /// After how many seconds how many behaviours were met, a generation each.
  std::vector<std::pair<double, std::size_t>> met_by_;
};

}  // namespace

Hunt run_hunt(const HuntPlan& hunt, const Known& known, const SaveTo& save_to, const Origin& origin,
              const OnHuntProgress& on_progress) {
  Hunting hunting(hunt, on_progress);
  const auto on_saving = [&](const Progress& progress) {
    on_progress({.plan = hunting.plan(), .cases = progress, .cells = 0, .cells_drawn = {}});
  };
  Journal journal(save_to.folder, "hunt", hunting.plan().seed);
  const RunCases run = [&](Interruption& interruption) {
    return hunting.run(journal, interruption);
  };
  Campaign campaign = run_campaign_by(run, hunting.plan(), known, save_to, origin, on_saving);
  const Saving& saving = campaign.saving;
  if (saving.unwritten == 0 && saving.unsaved == 0) journal.end();
  return hunting.finished(std::move(campaign));
}

CampaignResult result_of(const Hunt& hunt) {
  CampaignResult result = hunt.campaign.result;
  const Rounds rounds = hunt.rounds.value_or(Rounds{.cases = 0, .rounds = 0, .shares = 0});
  result.settings.hunt = hunt.what;
  result.hunt = HuntResult{rounds.rounds, rounds.shares,    rounds.cases,  hunt.generations,
                           hunt.cells,    hunt.cells_drawn, rows_of(hunt), hunt.buckets_drawn};
  return result;
}

}  // namespace manifuzz
