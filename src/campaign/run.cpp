#include "campaign/run.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "base/text.hpp"
#include "campaign/in_child.hpp"

namespace manifuzz {
namespace {

/// The first round is over in a moment. Each is twice as long as the one before, so that a round's
/// start weighs little, up to what a slow collider answers in some seconds.
constexpr CaseNumber kFirstRound = 1024;
constexpr CaseNumber kLongestRound = 1 << 15;

/// The cases of one round. Where one of them ends the plan, those up to it again: the first time,
/// jobs had run other cases behind it, which ones is chance.
JobsResult run_round(const Plan& plan, SharedQueue::Block cases, Interruption& interruption,
                     const OnProgress& on_progress) {
  JobsResult round = run_jobs(plan, cases, interruption, on_progress);
  if (!round.sought) return round;
  Plan to_the_end = plan;
  to_the_end.ends_with = {};
  JobsResult again =
      run_jobs(to_the_end, {cases.begin, *round.sought + 1}, interruption, on_progress);
  again.seconds += round.seconds;
  again.sought = round.sought;
  return again;
}

/// How a plan runs in rounds.
struct Rounds {
  std::function<CaseNumber(CaseNumber done)> length;
  std::function<void(JobsResult& so_far)> look;  ///< sets what ends it
};

/// Rounds of the plan's cases, until one of them, time or a look ends it.
JobsResult run_rounds(Plan plan, const Rounds& rounds, Interruption& interruption,
                      const OnProgress& on_progress) {
  JobsResult all{.tally = std::make_unique<Tally>()};
  const std::optional<double> seconds = plan.seconds;
  const CaseNumber end = plan.cases_max();
  for (CaseNumber begin = 0, length = 0; begin < end; begin += length) {
    length = std::min(rounds.length(begin), end - begin);
    if (seconds) plan.seconds = *seconds - all.seconds;  // what is left
    JobsResult round =
        run_round(plan, {begin, begin + length}, interruption, [&](const Progress& so_far) {
          const auto tally = std::make_unique<Tally>(so_far.tally);
          tally->add(*all.tally);
          on_progress({*tally, all.seconds + so_far.seconds});
        });
    round.tally->add(*all.tally);
    round.seconds += all.seconds;
    round.looks = all.looks;
    all = std::move(round);
    rounds.look(all);
    const bool is_time_up = seconds && all.seconds >= *seconds;
    if (all.interrupted || all.given_up != Fault::none || is_time_up) break;
    if (all.sought || all.is_risk_met) break;
  }
  return all;
}

/// Up to the first case of something new and wrong: any number of jobs ends at the same.
JobsResult run_until_new(Plan plan, const Known& known, Interruption& interruption,
                         const OnProgress& on_progress) {
  plan.ends_with = [&known, asked = plan](const Judgement& judgement) {
    return is_new_and_wrong(judgement, asked, known);
  };
  const Rounds rounds{[](CaseNumber done) { return std::min(done + kFirstRound, kLongestRound); },
                      [](JobsResult&) {}};
  return run_rounds(std::move(plan), rounds, interruption, on_progress);
}

/// Looks at the risk whenever there are twice as many cases, and at the end.
JobsResult run_until_risk(const Plan& plan, Interruption& interruption,
                          const OnProgress& on_progress) {
  const Rounds rounds{[](CaseNumber done) { return std::max(done, kFirstRound); },
                      [&plan](JobsResult& so_far) {
                        const double error = error_of_look(++so_far.looks);
                        so_far.is_risk_met =
                            risk_of_all(*so_far.tally, plan, error).any.high <= *plan.until_risk;
                      }};
  return run_rounds(plan, rounds, interruption, on_progress);
}

/// Every case of the plan, or those up to what ends it.
JobsResult run_plan(const Plan& plan, const Known& known, Interruption& interruption,
                    const OnProgress& on_progress) {
  if (plan.until_new) return run_until_new(plan, known, interruption, on_progress);
  if (plan.until_risk) return run_until_risk(plan, interruption, on_progress);
  return run_jobs(plan, {0, plan.cases_max()}, interruption, on_progress);
}

/// What a collider does not claim, and what else its declaration keeps from being judged.
void add_allowances(const Declaration& declaration, std::vector<std::string>& all) {
  const auto add = [&](const std::string& what) { all.push_back(declaration.name + " " + what); };
  if (declaration.claims == Claims::touching) {
    add("claims only whether they touch: no depth, normal or point is judged");
  } else if (declaration.claims == Claims::separation) {
    add("claims no points: none are judged");
  } else if (declaration.claims == Claims::point) {
    add("claims one point: that there is no second one is not judged");
  } else if (!declaration.clips) {
    add("does not clip: reference and features are not judged");
  }
  if (declaration.one_point_enough) {
    add(declaration.clips ? "may give one point of two"
                          : "may give one point of two: the extent of its points is not judged");
  }
  if (declaration.speculative > 0) {
    add(fmt::format("may see contact across gaps up to {}", declaration.speculative));
  }
  if (declaration.least_depth > 0) {
    add(fmt::format("may miss contacts up to {} deep", declaration.least_depth));
  }
  if (declaration.alters_shapes) add("alters shapes: it is judged by those that it used");
  if (!declaration.tolerance.is_none()) {
    add(fmt::format("may stop {} and {}% of the depth short of the least, by {}",
                    declaration.tolerance.absolute, 100 * declaration.tolerance.relative,
                    printable(declaration.tolerance_source, 200)));
  }
}

Settings settings_of(const Plan& plan) {
  std::vector<std::string> allowances;
  add_allowances(plan.subject.declaration, allowances);
  add_allowances(plan.oracle.declaration, allowances);
  return {.subject = plan.subject.declaration.name,
          .oracle = plan.oracle.declaration.name,
          .versions = {},
          .tie_bias = plan.subject.declaration.tie_bias,
          .radius = plan.context.radius,
          .judge_every = plan.judge_every,
          .allowances = allowances};
}

void add_provenance(CampaignResult& result, const nlohmann::ordered_json& provenance) {
  result.machine = provenance.at("machine");
  result.compiler = provenance.at("compiler");
  for (const auto& [name, version] : provenance.at("versions").items()) {
    result.settings.versions.emplace_back(name, version);
  }
}

/// What is not 0, by the regimes' names.
std::map<std::string, std::uint64_t> counts_of(std::span<const std::uint64_t> regimes,
                                               const Plan& plan) {
  std::map<std::string, std::uint64_t> counts;
  for (std::size_t r = 0; r < plan.regimes.size(); ++r) {
    if (regimes[r] > 0) counts[std::string(plan.regimes[r]->name)] = regimes[r];
  }
  return counts;
}

BucketResult bucket_result(const Finding& finding, const Plan& plan, const std::string& command) {
  const CaseNumber first = finding.tally.first;
  const std::string regime(plan.regimes[plan.regime_of(first)]->name);
  return {.bucket = to_string(finding.bucket),
          .verdict = std::string(to_string(finding.bucket.verdict)),
          .count = finding.tally.count,
          .seed = plan.seed,
          .first_index = plan.index_of(first),
          .regime = regime,
          .error = finding.tally.error,
          .file = finding.file,
          .command = command + plan.work->options_again(plan, first),
          .is_new = finding.is_new,
          .is_accepted = finding.is_accepted,
          .objection = finding.objection,
          .regimes = counts_of(finding.tally.regimes, plan),
          .agreed = counts_of(finding.tally.agreed, plan)};
}

/// What is accepted is no more unexplained in its regimes.
void count_as_accepted(const BucketResult& found, CampaignResult& result) {
  for (RegimeResult& regime : result.regimes) {
    const auto count = found.regimes.find(regime.name);
    if (count != found.regimes.end())
      regime.unexplained -= std::min(regime.unexplained, count->second);
  }
}

/// What a campaign that the risk was to end was ended by.
std::string end_of(const JobsResult& run, const Plan& plan) {
  if (run.is_risk_met) return "risk";
  if (run.interrupted) return "interruption";
  if (run.given_up != Fault::none) return "lost answers";
  return plan.seconds && run.seconds >= *plan.seconds ? "seconds" : "cases";
}

CampaignResult result_of(const Campaign& campaign, const Origin& origin) {
  const Plan& plan = campaign.plan;
  const Tally& tally = *campaign.run.tally;
  CampaignResult result;
  result.settings = settings_of(plan);
  add_provenance(result, origin.provenance);
  result.jobs = static_cast<std::uint64_t>(plan.jobs);
  result.verdicts = tally.verdicts;
  result.by_tolerance = tally.by_tolerance;
  result.agreeing_judged = tally.agreeing_judged;
  result.of_subject = tally.of_subject;
  result.of_oracle = tally.of_oracle;
  result.interrupted = campaign.run.interrupted || campaign.saving.interrupted;
  result.unshrunk = campaign.saving.unshrunk;
  result.stopped_early = campaign.run.given_up != Fault::none;
  result.budgets_hold = holds_budgets(plan);
  // Cases that are bred from others follow no law that the next one keeps to.
  if (plan.work->has_budgets()) {
    result.risk_error = plan.until_risk ? error_of_look(campaign.run.looks) : kRiskError;
  }
  if (plan.until_risk) result.ended_by = end_of(campaign.run, plan);
  CasesRun part{plan.seed, plan.first, {}, campaign.run.seconds};
  for (std::size_t i = 0; i < plan.regimes.size(); ++i) {
    result.regimes.push_back({tally.regimes[i], std::string(plan.regimes[i]->name)});
    part.cases[result.regimes.back().name] = tally.regimes[i].cases;
  }
  result.parts = {part};
  result.ledger = ledger_counts(tally, plan);
  for (const Finding& finding : campaign.findings) {
    result.buckets.push_back(bucket_result(finding, plan, origin.command));
    if (finding.is_accepted) count_as_accepted(result.buckets.back(), result);
  }
  return result;
}

/// The files whose finding is accepted and does not come any more, asked again.
std::vector<std::string> stale_files(const Plan& plan, const Known& known,
                                     Interruption& interruption) {
  std::vector<std::string> stale;
  for (const auto& [key, accepted] : known.accepted) {
    if (interruption.state() != Interruption::State::running) break;
    try {
      const CorpusCase known_case = read_case_file(accepted.file, plan.work->kind());
      const std::string got =
          to_string(plan.work->trial(plan)->judge(known_case.any, interruption).bucket);
      if (is_stale(known_case, got, plan.subject, plan.oracle)) {
        stale.push_back(accepted.file);
      }
    } catch (const UserError&) {
      // Somebody took the file away meanwhile.
    } catch (const Interrupted&) {
      break;
    }
  }
  std::ranges::sort(stale);
  stale.erase(std::unique(stale.begin(), stale.end()), stale.end());
  return stale;
}

}  // namespace

Campaign run_campaign(const Plan& plan, const Known& known, const SaveTo& save_to,
                      const Origin& origin, const OnProgress& on_progress) {
  const RunCases run_cases = [&](Interruption& interruption) {
    return run_plan(plan, known, interruption, on_progress);
  };
  return run_campaign_by(run_cases, plan, known, save_to, origin, on_progress);
}

Campaign run_campaign_by(const RunCases& run_cases, const Plan& plan, const Known& known,
                         const SaveTo& save_to, const Origin& origin,
                         const OnProgress& on_progress) {
  Interruption interruption;  // until it is saved: a signal between the steps ends no step
  Campaign campaign{plan, run_cases(interruption), {}, {}, {}};
  const JobsResult& run = campaign.run;
  campaign.findings = findings(*run.tally, plan, known);
  if (!save_to.folder.empty()) {
    using State = Interruption::State;
    const State begins = interruption.is_called_off() ? State::stopped
                         : run.interrupted            ? State::hurried
                                                      : State::running;
    campaign.saving = save_new(campaign.findings, *run.tally, plan, save_to, begins,
                               [&](const std::string& text) {
                                 on_progress({*run.tally, run.seconds, text});
                               });
  }
  campaign.result = result_of(campaign, origin);
  campaign.result.hints = plan.work->hints(*run.tally, plan, interruption);
  campaign.result.stale = stale_files(plan, known, interruption);
  return campaign;
}

}  // namespace manifuzz
