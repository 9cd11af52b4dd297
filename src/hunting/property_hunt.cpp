#include "hunting/property_hunt.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "base/text.hpp"
#include "campaign/in_child.hpp"
#include "campaign/property_failure.hpp"
#include "corpus/corpus.hpp"

namespace manifuzz {
namespace {

/// As a campaign runs it. The subject stands in for an oracle too, which nobody asks.
Plan campaign_of(const PropertyHuntPlan& hunt) {
  Plan plan;
  plan.subject = plan.oracle = hunt.subject;
  plan.context.corpus = hunt.corpus;
  narrow_to_colliders(plan);
  plan.regimes = regimes_for({hunt.subject}, {});
  plan.seed = hunt.seed;
  plan.cases = hunt.cases;
  plan.jobs = hunt.jobs;
  return plan;
}

/// The smallest case that fails as the worst did, and what becomes of it.
struct SmallestFailure {
  PairCase pair;
  PropertyOutcome outcome;
};

SmallestFailure smallest_failure(const HuntedProperty& hunted, const Collider& subject,
                                 Interruption& interruption) {
  const Property& property = *hunted.property;
  SmallestFailure smallest{*hunted.failing, fails("not asked again", hunted.worst - 1)};
  unless_interrupted([&] {
    const PropertyOutcome root = check_in_child(property, subject, smallest.pair, interruption);
    if (root.kind != PropertyOutcome::Kind::fails) {
      smallest.outcome.why = "it failed once, and holds when it is asked again";
      return;
    }
    smallest.outcome = root;
    if (root.is_lost || interruption.state() != Interruption::State::running) return;
    const PairCase pair = shrink_failure(property, subject, smallest.pair, root, interruption);
    const PropertyOutcome outcome = check_in_child(property, subject, pair, interruption);
    if (fails_alike(outcome, root)) smallest = {pair, outcome};
  });
  return smallest;
}

std::string report_of(const HuntedProperty& hunted, const PropertyResult& result) {
  if (!result.failing) {
    std::string text = fmt::format("OK, holds of {}", counted(hunted.cases, "hunted case"));
    if (hunted.worst > 0) {
      text += fmt::format("; at most {:.3g} of its bound is taken", hunted.worst);
    }
    return text;
  }
  std::string line;
  append_case_line(line, *result.failing);
  const double worst = hunted.worst - 1;
  const std::string by = worst > 0 ? fmt::format(", at worst by {:.3g} of the size", worst) : "";
  return fmt::format("Fails first after {}{}\n\ncase:\n{}\n\n{}",
                     counted(*hunted.first + 1, "hunted case"), by, line, result.why);
}

/// The names of properties, where they are not all, and the options that hunt so again.
std::string hunted_by(const PropertyHuntPlan& plan) {
  std::string again;
  if (plan.properties.size() < properties().size()) {
    for (const Property* const property : plan.properties)
      again += fmt::format("{} ", property->name);
  }
  return again + fmt::format("--hunt --cases {}", plan.cases);
}

PropertyResult result_of(const HuntedProperty& hunted, const Collider& subject,
                         Interruption& interruption) {
  PropertyResult result{.passed = !hunted.failing,
                        .cases = static_cast<int>(hunted.cases),
                        .applied = static_cast<int>(hunted.applied),
                        .report = "",
                        .failing = {},
                        .why = "",
                        .reproduce = ""};
  if (hunted.failing) {
    const SmallestFailure smallest = smallest_failure(hunted, subject, interruption);
    result.failing = smallest.pair;
    result.magnitude = smallest.outcome.magnitude;
    result.why = smallest.outcome.why;
  }
  result.report = report_of(hunted, result);
  return result;
}

/// Keeps the case of the worst failure of each property.
void keep(Journal& journal, const PropertyChecks& bred, const Plan& plan) {
  for (std::size_t k = 0; k < bred.hunted().size(); ++k) {
    const HuntedProperty& hunted = bred.hunted()[k];
    if (!hunted.failing) continue;
    journal.add(hunted.property->name, hunted.worst, [&] {
      std::string line;
      append_found_case_line(
          line, *hunted.failing,
          {plan.seed, std::string(kHunted.name), plan.index_of(hunted.failing_number), {}},
          hunted.property->name);
      return line;
    });
  }
}

}  // namespace

PropertyHunt hunt_properties(const PropertyHuntPlan& hunt, Interruption& interruption,
                             const OnPropertyProgress& on_progress) {
  Plan plan = campaign_of(hunt);
  const auto bred = std::make_shared<PropertyChecks>(hunt.properties, plan);
  plan.regimes = {&kHunted};
  plan.work = bred;
  Journal journal(hunt.save_to, "property", hunt.seed);
  JobsResult all{.tally = std::make_unique<Tally>()};
  const auto show = [&](const Progress& so_far) {
    on_progress({.cases = all.tally->cases() + so_far.tally.cases(),
                 .of = hunt.cases,
                 .seconds = all.seconds + so_far.seconds,
                 .cells = bred->filled().all,
                 .hunted = bred->hunted()});
  };
  for (CaseNumber begun = 0; begun < hunt.cases && !has_ended(all);) {
    const SharedQueue::Block cases = bred->begin_generation(hunt.cases - begun);
    begun = cases.end;
    const JobsResult part = run_jobs(plan, cases, interruption, show);
    add(all, part);
    bred->end_checks(plan, part);
    keep(journal, *bred, plan);
    bred->end_generation(*all.tally);
  }
  return {.hunted = bred->hunted(),
          .cases = all.tally->cases(),
          .seconds = all.seconds,
          .generations = bred->generations(),
          .cells = bred->filled().all,
          .journal = std::move(journal)};
}

std::vector<CheckedProperty> checked_by_hunt(
    const PropertyHunt& hunt, const PropertyHuntPlan& plan, const Known& known,
    Interruption& interruption, const std::function<void(const CheckedProperty&)>& on_checked) {
  std::vector<CheckedProperty> all;
  for (const HuntedProperty& hunted : hunt.hunted) {
    const auto start = Clock::now();
    CheckedProperty checked{hunted.property, result_of(hunted, plan.subject, interruption)};
    // They were asked of one case after the other, so that each has a share of the time.
    checked.seconds = hunt.seconds / static_cast<double>(hunt.hunted.size()) + seconds_since(start);
    checked.hunted_by = hunted_by(plan);
    if (!checked.result.passed) settle_failure(checked, plan.subject, known, plan.save_to);
    on_checked(checked);
    all.push_back(checked);
  }
  const auto is_saved = [](const CheckedProperty& one) { return one.why_unsaved.empty(); };
  if (std::ranges::all_of(all, is_saved)) hunt.journal.end();
  return all;
}

}  // namespace manifuzz
