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

/// Every case of the plan, or, where it ends at what is new and wrong, rounds of them, up to the
/// first such case: any number of jobs ends at the same.
JobsResult run_plan(const Plan& plan, const Known& known, Interruption& interruption,
                    const OnProgress& on_progress) {
  const CaseNumber end = plan.cases_max();
  if (!plan.until_new) return run_jobs(plan, {0, end}, interruption, on_progress);
  JobsResult all{.tally = std::make_unique<Tally>()};
  Plan rest = plan;  // with the time that is left
  rest.ends_with = [&](const Judgement& judgement) {
    return is_new_and_wrong(judgement, plan, known);
  };
  CaseNumber length = kFirstRound;
  for (CaseNumber begin = 0; begin < end; begin += length) {
    if (begin > 0) length = std::min(2 * length, kLongestRound);
    length = std::min(length, end - begin);
    if (plan.seconds) rest.seconds = *plan.seconds - all.seconds;
    JobsResult round =
        run_round(rest, {begin, begin + length}, interruption, [&](const Progress& so_far) {
          const auto tally = std::make_unique<Tally>(so_far.tally);
          tally->add(*all.tally);
          on_progress({*tally, all.seconds + so_far.seconds});
        });
    round.tally->add(*all.tally);
    round.seconds += all.seconds;
    all = std::move(round);
    const bool is_time_up = plan.seconds && all.seconds >= *plan.seconds;
    if (all.interrupted || all.given_up != Fault::none || is_time_up || all.sought) break;
  }
  return all;
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

std::map<std::string, std::uint64_t> counts_of(const Finding& finding, const Plan& plan) {
  std::map<std::string, std::uint64_t> counts;
  for (std::size_t r = 0; r < plan.regimes.size(); ++r) {
    const std::uint64_t count = finding.tally.regimes[r];
    if (count > 0) counts[std::string(plan.regimes[r]->name)] = count;
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
          .regimes = counts_of(finding, plan)};
}

/// What is accepted is no more unexplained in its regimes.
void count_as_accepted(const BucketResult& found, CampaignResult& result) {
  for (RegimeResult& regime : result.regimes) {
    const auto count = found.regimes.find(regime.name);
    if (count != found.regimes.end())
      regime.unexplained -= std::min(regime.unexplained, count->second);
  }
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
